//! Runs a trial to its end or its error.

use std::fs;
use std::path::Path;

use case_io::document::{Case, Overrides};
use case_io::output::OutputError;

use super::outcome::{Fault, Outcome, Worst};
use super::trial::Trial;
use crate::backend::{self, Attempt, FluidBackend, Step};

/// Windows are halved so often before a trial is given up.
const HALVINGS: u32 = 10;

/// Runs a trial; its case stays in `folder`.
///
/// # Errors
/// The disk's; whatever the backend says is an outcome.
pub fn run(trial: &Trial, folder: &Path) -> Result<Outcome, OutputError> {
    fs::create_dir_all(folder).map_err(OutputError::system("make", folder))?;
    let path = folder.join("case.toml");
    fs::write(&path, trial.case()).map_err(OutputError::system("write", &path))?;
    let (mut time, mut worst) = (0.0, Worst::NONE);
    Ok(match advance(trial, folder, &mut time, &mut worst) {
        Ok(()) => Outcome::Ran(worst),
        Err(message) => Outcome::Stopped(worst, Fault { time, message }),
    })
}

/// Runs it and keeps the worst, or says what ended it.
fn advance(trial: &Trial, folder: &Path, time: &mut f64, worst: &mut Worst) -> Result<(), String> {
    let case = Case::load_run(folder, &Overrides::default(), None).map_err(told)?;
    let mut fluid = backend::of(&case, true).map_err(told)?;
    let first = energy(fluid.as_ref(), 0.0);
    let mut halvings = 0;
    while *time < trial.end * (1.0 - 1e-9) {
        let whole = trial.window * 0.5_f64.powi(halvings as i32);
        let step = Step { time: *time, length: whole.min(fluid.largest_step()).min(trial.end - *time) };
        fluid.save();
        match fluid.solve(step, &[]).map_err(told)? {
            Attempt::Solved(_) => {
                fluid.commit(step).map_err(told)?;
                *time = step.end();
                halvings = 0;
                // The greatest, and not a number if one is none.
                let greatest = |old: f64, new: f64| if new <= old { old } else { new };
                let fluid = fluid.as_ref();
                // A mesh that stays has no error of volume.
                let lost = statistic(fluid, *time, "volume-error[-]").unwrap_or_default();
                worst.volume_error = greatest(worst.volume_error, lost.abs());
                worst.energy_growth = greatest(worst.energy_growth, energy(fluid, *time) / first);
                worst.speed = statistic(fluid, *time, "speed-max[m/s]").unwrap_or(f64::NAN);
            }
            Attempt::TooLarge(refused) => {
                fluid.restore();
                halvings += 1;
                worst.halved += 1;
                if halvings > HALVINGS {
                    return Err(format!("a window of {:.1e} s is too long: {}", step.length, refused.reason));
                }
            }
        }
    }
    Ok(())
}

fn told(error: impl ToString) -> String {
    error.to_string()
}

/// Energy (J): kinetic and potential; of a fluid that fills its vessel, kinetic.
fn energy(fluid: &dyn FluidBackend, time: f64) -> f64 {
    let told = |name| statistic(fluid, time, name);
    told("energy[J]").or_else(|| told("kinetic-energy[J]")).unwrap_or(f64::NAN)
}

/// A statistic by its name.
fn statistic(fluid: &dyn FluidBackend, time: f64, name: &str) -> Option<f64> {
    let told = fluid.statistics(time);
    told.iter().find(|(title, _)| *title == name).map(|(_, value)| *value)
}
