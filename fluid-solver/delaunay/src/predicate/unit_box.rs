//! Points at the corners of one box: those of a grid. They lie on one sphere, and their coordinates are two numbers an axis.

/// Corners of a box as those of the unit cube, which orients them alike; none if the points are not all corners of one box
/// along the axes.
#[inline(always)]
pub fn map<const D: usize, const N: usize>(
    corners: [&[f64; D]; N],
    point: &[f64; D],
) -> Option<([[f64; D]; N], [f64; D])> {
    let (mut low, mut high) = (*point, *point);
    for corner in corners {
        for k in 0..D {
            low[k] = low[k].min(corner[k]);
            high[k] = high[k].max(corner[k]);
        }
    }
    // All are looked at, for a branch at each would be taken by chance.
    let mut inside = false;
    for x in corners.iter().chain([&point]) {
        for k in 0..D {
            inside |= (x[k] != low[k]) & (x[k] != high[k]);
        }
    }
    if inside {
        return None;
    }
    let unit = |x: &[f64; D]| std::array::from_fn(|k| f64::from(u8::from(x[k] == high[k])));
    Some((corners.map(unit), unit(point)))
}
