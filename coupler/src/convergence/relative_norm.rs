//! The change of a field in an iteration, relative to the field when the window opened.

use super::{Change, Measure};

/// ‖x^{k+1} − x^k‖ ≤ e·max(‖x^n‖, floor); x^n is the field at the opening of the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeNorm {
    /// e \[-\], above 0.
    pub tolerance: f64,
    /// Smallest reference, in the field's unit, above 0.
    pub floor: f64,
}

impl Measure for RelativeNorm {
    const NAME: &'static str = "relative-norm";
    const FORMULA: &'static str = "‖x^{k+1} − x^k‖ ≤ e·max(‖x^n‖, floor)";
    const SOURCE: &'static str = "Idelsohn, Oñate & Becker 2017, eq. 125; the floor is needed at rest";

    fn residual(&self, change: &Change) -> f64 {
        change.change / (self.tolerance * change.reference.max(self.floor))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NORM: RelativeNorm = RelativeNorm { tolerance: 1e-3, floor: 1e-9 };

    #[test]
    fn a_fluid_at_rest_converges_by_the_floor() {
        assert_eq!(NORM.residual(&Change { change: 0.0, reference: 0.0 }), 0.0);
        assert!(NORM.residual(&Change { change: 0.9e-12, reference: 0.0 }) < 1.0);
        assert!(NORM.residual(&Change { change: 1.1e-12, reference: 0.0 }) > 1.0);
    }

    #[test]
    fn a_moving_fluid_converges_relative_to_its_speed() {
        assert!(NORM.residual(&Change { change: 1.9e-3, reference: 2.0 }) < 1.0);
        assert!(NORM.residual(&Change { change: 2.1e-3, reference: 2.0 }) > 1.0);
    }

    #[test]
    fn what_is_not_a_number_has_not_converged() {
        assert!(NORM.residual(&Change { change: f64::NAN, reference: 1.0 }).is_nan());
    }
}
