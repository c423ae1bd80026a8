//! Aitken's Δ² relaxation for vectors.

use serde::{Deserialize, Serialize};

use super::Relaxation;

/// Smallest and largest factor.
const BOUNDS: (f64, f64) = (0.05, 1.5);
/// Largest first factor of a window.
const LARGEST_FIRST: f64 = 0.5;

/// ω_k = −ω_{k−1} r_{k−1}·(r_k − r_{k−1})/‖r_k − r_{k−1}‖², within 0.05…1.5; a window starts from min(last ω, 0.5).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Aitken {
    factor: f64,
    previous: Vec<f64>,
}

impl Aitken {
    /// Starts from this factor, in (0, 1]; `None` for any other. The first window, too, starts from at most 0.5.
    pub fn new(factor: f64) -> Option<Self> {
        (factor > 0.0 && factor <= 1.0).then_some(Self { factor, previous: Vec::new() })
    }
}

impl Relaxation for Aitken {
    const NAME: &'static str = "aitken";
    const FORMULA: &'static str =
        "x ← x + ω_k r_k, r = H(x) − x, ω_k = −ω_{k−1} r_{k−1}·(r_k − r_{k−1})/‖r_k − r_{k−1}‖²";
    const SOURCE: &'static str =
        "Irons & Tuck 1969, Int. J. Numer. Meth. Eng. 1:275; Küttler & Wall 2008, Comput. Mech. 43:61";

    fn open(&mut self) {
        self.previous.clear();
    }

    fn factor(&mut self, residual: &[f64]) -> f64 {
        if self.previous.is_empty() {
            self.factor = self.factor.min(LARGEST_FIRST);
        } else {
            let (mut projection, mut square) = (0.0, 0.0);
            for (old, new) in self.previous.iter().zip(residual) {
                projection += old * (new - old);
                square += (new - old) * (new - old);
            }
            // Two equal residuals say nothing of the slope: the factor stays.
            if square > 0.0 {
                self.factor = (-self.factor * projection / square).clamp(BOUNDS.0, BOUNDS.1);
            }
        }
        self.previous.clear();
        self.previous.extend_from_slice(residual);
        self.factor
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Iterates x ← H(x) = a∘x + b from 0 and returns ‖x − x*‖ after each iteration.
    fn errors(aitken: &mut Aitken, amplification: &[f64], iterations: usize) -> Vec<f64> {
        let fixed_point = 1.0;
        let mut x = vec![0.0; amplification.len()];
        aitken.open();
        (0..iterations)
            .map(|_| {
                let residual: Vec<f64> =
                    x.iter().zip(amplification).map(|(x, a)| (a - 1.0) * (x - fixed_point)).collect();
                let factor = aitken.factor(&residual);
                x.iter_mut().zip(&residual).for_each(|(x, r)| *x += factor * r);
                x.iter().map(|x| (x - fixed_point) * (x - fixed_point)).sum::<f64>().sqrt()
            })
            .collect()
    }

    #[test]
    fn one_linear_unknown_is_solved_by_the_second_factor() {
        for amplification in [-10.0, -3.0, -0.5, 0.3] {
            let mut aitken = Aitken::new(0.4).unwrap();
            let errors = errors(&mut aitken, &[amplification], 2);
            assert!(errors[1] < 1e-14, "{amplification}: {errors:?}");
            assert!((aitken.factor * (1.0 - amplification) - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn several_unknowns_whose_plain_iteration_explodes_converge() {
        let errors = errors(&mut Aitken::new(0.5).unwrap(), &[-3.0, -1.2, 0.1, 0.4], 60);
        assert!(errors[59] < 1e-10, "{errors:?}");
    }

    #[test]
    fn the_factor_stays_within_its_bounds() {
        let mut aitken = Aitken::new(1.0).unwrap();
        aitken.open();
        assert_eq!(aitken.factor(&[1.0]), 0.5);
        assert_eq!(aitken.factor(&[0.99]), 1.5);
        assert_eq!(aitken.factor(&[2.0]), 0.05);
    }

    #[test]
    fn a_window_starts_from_the_last_factor_but_not_above_one_half() {
        for (amplification, first) in [(-3.0, 0.25), (0.2, 0.5)] {
            let mut aitken = Aitken::new(0.4).unwrap();
            errors(&mut aitken, &[amplification], 2);
            aitken.open();
            assert!((aitken.factor(&[7.0]) - first).abs() < 1e-14);
        }
    }

    #[test]
    fn equal_and_vanishing_residuals_keep_the_factor() {
        let mut aitken = Aitken::new(0.3).unwrap();
        assert_eq!(aitken.factor(&[2.0, 1.0]), 0.3);
        assert_eq!(aitken.factor(&[2.0, 1.0]), 0.3);
        let mut aitken = Aitken::new(0.3).unwrap();
        assert_eq!(aitken.factor(&[0.0]), 0.3);
        assert_eq!(aitken.factor(&[0.0]), 0.3);
        assert_eq!(Aitken::new(0.3).unwrap().factor(&[]), 0.3);
    }

    #[test]
    fn restored_state_goes_on_with_the_same_bits() {
        let mut through = Aitken::new(0.4).unwrap();
        errors(&mut through, &[-2.0, 0.3], 5);
        let saved = through.clone();
        let went_on = errors(&mut through, &[-2.0, 0.3], 5);
        assert_ne!(saved, through);
        through = saved;
        assert_eq!(errors(&mut through, &[-2.0, 0.3], 5), went_on);
    }

    #[test]
    fn factors_outside_zero_to_one_are_refused() {
        for factor in [0.0, -0.5, 1.5, f64::NAN, f64::INFINITY] {
            assert_eq!(Aitken::new(factor), None, "{factor}");
        }
    }
}
