//! A probe: a point of the fluid, or the face of a gauge that reads means.

use crate::backend::{FluidBackend, PointValue};
use crate::element::simplex::cross;
use case_io::document::{GaugeFace, Probe, unit_vector};

/// Points that stand for a disc, of equal shares.
const POINTS: usize = 64;

/// What reads the fluid at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Gauge {
    /// Name of its columns.
    pub name: String,
    /// Its middle (m).
    pub at: [f64; 3],
    /// Points of its face; none of a point.
    face: Vec<[f64; 3]>,
}

impl From<&Probe> for Gauge {
    fn from(probe: &Probe) -> Self {
        let at = probe.at.to_array();
        let face = probe.disc.as_ref().map_or(Vec::new(), |face| points(&at, face));
        Self { name: probe.name.clone(), at, face }
    }
}

impl Gauge {
    /// What it reads: of a face the mean pressure, 0 where no fluid is, and the mean of all else over what is wet. Where all is dry,
    /// what is not known is not a number.
    pub fn read(&self, backend: &dyn FluidBackend, time: f64) -> PointValue {
        const DRY: PointValue =
            PointValue { velocity: [f64::NAN; 3], pressure: f64::NAN, void_fraction: f64::NAN };
        if self.face.is_empty() {
            return backend.at(time, self.at).unwrap_or(DRY);
        }
        let wet: Vec<PointValue> = self.face.iter().filter_map(|&point| backend.at(time, point)).collect();
        let sum = |value: &dyn Fn(&PointValue) -> f64| wet.iter().map(value).sum::<f64>();
        let count = wet.len() as f64;
        PointValue {
            velocity: std::array::from_fn(|k| sum(&|value| value.velocity[k]) / count),
            pressure: sum(&|value| value.pressure) / self.face.len() as f64,
            void_fraction: sum(&|value| value.void_fraction) / count,
        }
    }
}

/// Points of equal shares of a disc: at √((k + ½)/n) of its radius, each turned by the golden angle against the last.
///
/// Source: Vogel, *Math. Biosci.* 44 (1979) 179.
fn points(centre: &[f64; 3], face: &GaugeFace) -> Vec<[f64; 3]> {
    let golden_angle = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    let normal: [f64; 3] = unit_vector(&face.normal);
    // The axis that is least along the normal.
    let least = (1..3).fold(2, |least, k| if normal[k].abs() < normal[least].abs() { k } else { least });
    let axis: [f64; 3] = std::array::from_fn(|k| if k == least { 1.0 } else { 0.0 });
    let first = unit_vector::<3>(&cross(&normal, &axis));
    let second = cross(&normal, &first);
    let point = |index: usize| {
        let share = (index as f64 + 0.5) / POINTS as f64;
        let (sin, cos) = (index as f64 * golden_angle).sin_cos();
        let reach = face.radius.si() * share.sqrt();
        std::array::from_fn(|k| centre[k] + reach * (cos * first[k] + sin * second[k]))
    };
    (0..POINTS).map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use case_io::document::quantity::Length;

    #[test]
    fn the_points_of_a_face_have_its_centre_and_its_second_moment() {
        let centre = [1.0, 2.0, 3.0];
        for normal in [[-1.0, 0.0, 0.0], [0.0, 0.0, 2.0], [1.0, 2.0, -3.0]] {
            let face = GaugeFace { radius: Length::from_si(0.2), normal: normal.to_vec() };
            let unit: [f64; 3] = unit_vector(&normal);
            let away = |x: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|k| x[k] - centre[k]) };
            let points: Vec<[f64; 3]> = points(&centre, &face).iter().map(away).collect();
            let mean = |value: &dyn Fn(&[f64; 3]) -> f64| points.iter().map(value).sum::<f64>() / 64.0;
            for k in 0..3 {
                assert!(mean(&|x| x[k]).abs() < 0.01 * 0.2);
                // Of a disc R²/4 along each direction in it.
                let expected = 0.25 * 0.04 * (1.0 - unit[k] * unit[k]);
                assert!((mean(&|x| x[k] * x[k]) - expected).abs() < 0.02 * 0.01, "{normal:?} {k}");
            }
            assert!(points.iter().all(|x| (0..3).map(|k| x[k] * unit[k]).sum::<f64>().abs() < 1e-15));
        }
    }
}
