//! The books of a run: what must balance in every window, and by how much it did not.

use crate::error::CouplerError;
use crate::window::Outcome;
use case_io::summary::LedgerMaximum;
use interface::ledger::{FluidLedger, GrainLedger, Vector};
use interface::message::Window;
use std::collections::BTreeMap;

/// Names of the rows, in the order of the columns of `series/ledger.csv`.
pub const ROWS: [&str; 6] = ["grains", "fluid", "received", "given", "momentum", "undelivered"];

/// Residuals of one window, relative to the sum of absolute impulses and momenta; in the order of [`ROWS`].
/// - `grains`: ΔP − gravity − walls − drag − explicit
/// - `fluid`: rate − body − boundary + drag + stress − explicit
/// - `received`: what the grains booked as received, against the coupler's sum over grains
/// - `given`: what the fluid booked as given, against the coupler's sum over grains
/// - `momentum`: grains + fluid + undelivered against all that came from outside
/// - `undelivered`: what one side gave and the other has not yet received
pub type Residuals = [f64; 6];

/// What undelivered impulses may be at most, in parts of the scale: more, and the sides have lost each other.
const UNDELIVERED_BOUND: f64 = 1.0;

/// Keeps the maxima and the totals of a run.
pub struct Ledger {
    tolerance: f64,
    maxima: Residuals,
}

impl Ledger {
    /// An empty book.
    pub fn new(tolerance: f64) -> Ledger {
        Ledger { tolerance, maxima: [0.0; 6] }
    }

    /// Books a window.
    ///
    /// # Errors
    /// [`CouplerError::Ledger`] for the first row out of tolerance.
    pub fn book(
        &mut self,
        outcome: &Outcome,
        owed: Vector,
        window: Window,
    ) -> Result<Residuals, CouplerError> {
        let residuals = residuals(outcome, owed);
        for (index, residual) in residuals.into_iter().enumerate() {
            self.maxima[index] = self.maxima[index].max(residual);
            if residual.is_nan() || residual > self.allowed(index) {
                return Err(CouplerError::Ledger {
                    row: ROWS[index],
                    window: window.number,
                    time: window.time,
                    residual,
                    tolerance: self.allowed(index),
                });
            }
        }
        Ok(residuals)
    }

    fn allowed(&self, row: usize) -> f64 {
        if ROWS[row] == "undelivered" { UNDELIVERED_BOUND } else { self.tolerance }
    }

    /// Largest residuals so far.
    pub fn largest(&self) -> Residuals {
        self.maxima
    }

    /// Goes on with the largest residuals of a restart point.
    pub fn resume(&mut self, maxima: Residuals) {
        self.maxima = maxima;
    }

    /// Largest residuals so far, for the summary.
    pub fn maxima(&self) -> BTreeMap<String, LedgerMaximum> {
        ROWS.iter()
            .zip(self.maxima)
            .enumerate()
            .map(|(index, (name, residual))| {
                (name.to_string(), LedgerMaximum { residual, tolerance: self.allowed(index) })
            })
            .collect()
    }
}

fn residuals(outcome: &Outcome, owed: Vector) -> Residuals {
    let grains = outcome.grains.clone().unwrap_or_default();
    let fluid = outcome.fluid.clone().unwrap_or_default();
    let scale = grains.scale + fluid.scale;
    let grain_defect = grain_defect(&grains);
    let fluid_defect = fluid_defect(&fluid);
    let (mut received, mut given, mut momentum) = ([0.0; 3], [0.0; 3], [0.0; 3]);
    if let Some(crossed) = outcome.crossed {
        for k in 0..3 {
            received[k] = grains.drag[k] + grains.explicit[k] + grains.supports[k] - crossed.received[k];
            given[k] = fluid.drag[k] + fluid.stress[k] - fluid.explicit[k] - crossed.given[k];
            let inside = grains.momentum[k] - grains.momentum_before[k] + fluid.rate[k] + owed[k]
                - outcome.owed_before[k];
            let outside =
                grains.gravity[k] + grains.walls[k] - grains.supports[k] + fluid.body[k] + fluid.boundary[k];
            momentum[k] = inside - outside;
        }
    }
    let relative =
        |defect: Vector, scale: f64| if scale > 0.0 { largest(defect) / scale } else { largest(defect) };
    [
        relative(grain_defect, grains.scale),
        relative(fluid_defect, fluid.scale),
        relative(received, scale),
        relative(given, scale),
        relative(momentum, scale),
        relative(owed, scale),
    ]
}

fn grain_defect(ledger: &GrainLedger) -> Vector {
    std::array::from_fn(|k| {
        ledger.momentum[k]
            - ledger.momentum_before[k]
            - (ledger.gravity[k] + ledger.walls[k] + ledger.drag[k] + ledger.explicit[k])
    })
}

fn fluid_defect(ledger: &FluidLedger) -> Vector {
    std::array::from_fn(|k| {
        ledger.rate[k]
            - (ledger.body[k] + ledger.boundary[k] - ledger.drag[k] - ledger.stress[k] + ledger.explicit[k])
    })
}

fn largest(vector: Vector) -> f64 {
    // `max` would drop a NaN.
    vector
        .iter()
        .fold(0.0, |largest, component| if component.abs() <= largest { largest } else { component.abs() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exchange::Crossed;

    /// A grain that receives 3 of the 4 that the fluid gives, on a scene that nothing touches from outside.
    fn outcome() -> Outcome {
        let grains = GrainLedger {
            momentum_before: [1.0, 0.0, 0.0],
            momentum: [4.0, 0.0, 0.0],
            drag: [3.0, 0.0, 0.0],
            scale: 10.0,
            ..Default::default()
        };
        let fluid =
            FluidLedger { rate: [-4.0, 0.0, 0.0], drag: [4.0, 0.0, 0.0], scale: 10.0, ..Default::default() };
        let crossed = Crossed { given: [4.0, 0.0, 0.0], received: [3.0, 0.0, 0.0] };
        Outcome { grains: Some(grains), fluid: Some(fluid), crossed: Some(crossed), ..Outcome::default() }
    }

    const WINDOW: Window = Window { number: 5, time: 0.0, step: 1.0, grains_changed: false };

    #[test]
    fn what_is_owed_closes_the_balance() {
        let residuals = Ledger::new(1e-12).book(&outcome(), [1.0, 0.0, 0.0], WINDOW).unwrap();
        assert_eq!(residuals[..5], [0.0; 5]);
        assert_eq!(residuals[5], 1.0 / 20.0);
    }

    #[test]
    fn a_lost_impulse_and_a_number_that_is_none_fail_the_run() {
        let mut ledger = Ledger::new(1e-12);
        assert!(matches!(
            ledger.book(&outcome(), [0.0; 3], WINDOW),
            Err(CouplerError::Ledger { row: "momentum", window: 5, .. })
        ));
        let mut broken = outcome();
        broken.grains.as_mut().unwrap().drag[2] = f64::NAN;
        assert!(matches!(
            ledger.book(&broken, [1.0, 0.0, 0.0], WINDOW),
            Err(CouplerError::Ledger { row: "grains", .. })
        ));
    }
}
