//! The change of the forces between fluid and grains in an iteration.

use super::{Change, Measure};

/// ‖F^k − F^{k−1}‖ ≤ e·max(‖F^k‖, floor), F the force of the fluid on each grain.
///
/// Grain by grain, not their sum: opposite changes of two grains do not cancel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceResidual {
    /// e \[-\], above 0.
    pub tolerance: f64,
    /// Smallest reference \[N\], above 0.
    pub floor: f64,
}

impl ForceResidual {
    /// The change between the forces \[N\] of two iterations, same grain in the same row. Without grains nothing changes.
    pub fn change(before: &[[f64; 3]], after: &[[f64; 3]]) -> Change {
        debug_assert_eq!(before.len(), after.len());
        let (mut change, mut reference) = (0.0, 0.0);
        for (old, new) in before.iter().zip(after) {
            for (old, new) in old.iter().zip(new) {
                change += (new - old) * (new - old);
                reference += new * new;
            }
        }
        let rows = after.len().max(1) as f64;
        Change { change: (change / rows).sqrt(), reference: (reference / rows).sqrt() }
    }
}

impl Measure for ForceResidual {
    const NAME: &'static str = "force-residual";
    const FORMULA: &'static str = "‖F^k − F^{k−1}‖ ≤ e·max(‖F^k‖, floor)";
    const SOURCE: &'static str = "Küttler & Wall 2008, Comput. Mech. 43:61 (interface residual)";

    fn residual(&self, change: &Change) -> f64 {
        change.change / (self.tolerance * change.reference.max(self.floor))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opposite_changes_of_two_grains_do_not_cancel() {
        let before = [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
        let after = [[1.5, 0.0, 0.0], [0.5, 0.0, 0.0]];
        let change = ForceResidual::change(&before, &after);
        assert_eq!(change, Change { change: 0.5, reference: 1.25_f64.sqrt() });
    }

    #[test]
    fn without_grains_the_forces_have_converged() {
        let residual = ForceResidual { tolerance: 1e-3, floor: 1e-15 };
        assert_eq!(residual.residual(&ForceResidual::change(&[], &[])), 0.0);
    }

    #[test]
    fn a_force_that_is_not_a_number_has_not_converged() {
        let change = ForceResidual::change(&[[0.0; 3]], &[[0.0, f64::NAN, 0.0]]);
        let residual = ForceResidual { tolerance: 1e-3, floor: 1e-15 }.residual(&change);
        assert!(residual.is_nan() || residual > 1.0, "{residual}");
    }
}
