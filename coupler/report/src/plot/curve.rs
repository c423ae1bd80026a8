//! One curve, thinned to what a plot can show.

/// A named run of points.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve {
    pub(crate) name: String,
    /// Runs of points without a gap; NaN and infinity make a gap.
    pub(crate) pieces: Vec<Vec<(f64, f64)>>,
}

/// No plot shows more rows of one curve than this many pairs of smallest and largest.
const BUCKETS: usize = 500;

impl Curve {
    /// A curve through the finite points. Of many points, every bucket keeps its smallest and largest value: peaks
    /// stay visible.
    pub(crate) fn new(name: &str, x: &[f64], y: &[f64]) -> Self {
        let mut pieces = vec![Vec::new()];
        for (&x, &y) in x.iter().zip(y) {
            if x.is_finite() && y.is_finite() {
                if let Some(piece) = pieces.last_mut() {
                    piece.push((x, y));
                }
            } else if pieces.last().is_some_and(|piece| !piece.is_empty()) {
                pieces.push(Vec::new());
            }
        }
        pieces.retain(|piece| !piece.is_empty());
        let bucket = x.len().div_ceil(BUCKETS);
        if bucket > 2 {
            pieces = pieces.iter().map(|piece| thinned(piece, bucket)).collect();
        }
        Self { name: name.to_owned(), pieces }
    }

    /// The way up and down along the curve: Σ |y_{i+1} − y_i|.
    pub(crate) fn travel(&self) -> f64 {
        self.pieces.iter().flat_map(|piece| piece.windows(2)).map(|pair| (pair[1].1 - pair[0].1).abs()).sum()
    }

    pub(crate) fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.pieces.iter().flatten().copied()
    }
}

fn thinned(piece: &[(f64, f64)], bucket: usize) -> Vec<(f64, f64)> {
    let mut kept = Vec::with_capacity(2 * piece.len() / bucket + 2);
    for points in piece.chunks(bucket) {
        let extreme = |sign: f64| points.iter().copied().min_by(|a, b| (sign * a.1).total_cmp(&(sign * b.1)));
        let mut pair: Vec<(f64, f64)> = [extreme(1.0), extreme(-1.0)].into_iter().flatten().collect();
        pair.sort_by(|a, b| a.0.total_cmp(&b.0));
        pair.dedup();
        kept.extend(pair);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nan_makes_a_gap() {
        let curve = Curve::new("v", &[0.0, 1.0, 2.0, 3.0], &[1.0, f64::NAN, f64::INFINITY, 4.0]);
        assert_eq!(curve.pieces, [vec![(0.0, 1.0)], vec![(3.0, 4.0)]]);
        assert!(Curve::new("v", &[0.0], &[f64::NAN]).pieces.is_empty());
    }

    #[test]
    fn the_travel_of_a_curve_counts_every_way_up_and_down_but_no_gap() {
        let curve = Curve::new("v", &[0.0, 1.0, 2.0, 3.0, 4.0], &[0.0, 2.0, 1.0, f64::NAN, 9.0]);
        assert_eq!(curve.travel(), 3.0);
    }

    #[test]
    fn thinning_keeps_the_peak_and_the_ends_in_order() {
        let x: Vec<f64> = (0..100_000).map(f64::from).collect();
        let mut y: Vec<f64> = x.iter().map(|x| (x * 1e-4).sin()).collect();
        y[54_321] = 9.0;
        let curve = Curve::new("v", &x, &y);
        assert_eq!(curve.pieces.len(), 1);
        assert!(curve.pieces[0].len() <= 2 * BUCKETS);
        assert!(curve.pieces[0].contains(&(54_321.0, 9.0)));
        assert!(curve.pieces[0].is_sorted_by(|a, b| a.0 < b.0));
    }
}
