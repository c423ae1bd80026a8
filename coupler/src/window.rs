//! One coupling window t → t + Δt.

use crate::acceleration::Acceleration;
use crate::convergence::{Change, Judge, Residuals, Verdict};
use crate::error::CouplerError;
use crate::exchange::{Crossed, Exchange};
use crate::interaction::{Interaction, Passage, Shape, compliant_reaction, reaction};
use crate::owed::Owed;
use crate::session::{Answer, Session};
use interface::frames::ReactionRow;
use interface::ledger::{FluidLedger, GrainLedger};
use interface::message::{Norms, Window};

/// How grains and fluid act on each other in this scene.
pub struct Coupling {
    /// The laws.
    pub interaction: Interaction,
    /// Discs or spheres.
    pub shape: Shape,
    /// The fluid feels the grains.
    pub two_way: bool,
    /// Most iterations of a window.
    pub max_iterations: u32,
    /// Run until converged; otherwise once.
    pub implicit: bool,
    /// When a window has converged.
    pub judge: Judge,
    /// How the iterations are relaxed. State: its factor starts the next window.
    pub relaxation: Acceleration,
}

impl Coupling {
    /// What a grain does to the fluid: where nothing iterates, the fluid's solution knows how the grain gives way.
    fn reaction(&self, passage: &Passage<'_>, step: f64) -> ReactionRow {
        if self.implicit { reaction(passage, step) } else { compliant_reaction(passage, self.shape, step) }
    }
}

/// What a window gave.
#[derive(Debug, Default)]
pub struct Outcome {
    /// Iterations done.
    pub iterations: u32,
    /// Changes of the last iteration in parts of the tolerance; none where nothing iterates.
    pub residuals: Option<Residuals>,
    /// The grains' books.
    pub grains: Option<GrainLedger>,
    /// The fluid's books.
    pub fluid: Option<FluidLedger>,
    /// What crossed, by the coupler's own sums.
    pub crossed: Option<Crossed>,
    /// What was owed before.
    pub owed_before: [f64; 3],
    /// DEM substeps of all iterations.
    pub substeps: u64,
    /// Linear iterations of all iterations.
    pub linear_iterations: u64,
}

/// The window with both sides: grains first, with the latest fluid iterate, then the fluid with the grains' new places.
/// All sides are open when it begins and solved when it ends.
///
/// # Errors
/// A participant's failure, a law's input out of range, no convergence.
pub fn coupled_window(
    session: &mut Session,
    coupling: &mut Coupling,
    exchange: &mut Exchange,
    owed: &mut Owed,
    window: Window,
) -> Result<Answer<Outcome>, CouplerError> {
    let mut outcome = Outcome { owed_before: owed.sum(), ..Outcome::default() };
    coupling.judge.open();
    coupling.relaxation.open();
    exchange.open(&session.grains()?);
    for iteration in 1.. {
        let ends = &mut session.ends;
        let relaxation = (iteration > 1).then_some(&mut coupling.relaxation);
        exchange.evaluate(
            &coupling.interaction,
            (&ends.grains.newest()?, &ends.samples.newest()?),
            owed,
            window.step,
            relaxation,
        )?;
        let (grain_ledger, substeps) = match session.advance_dem(window, iteration, &exchange.hydro)? {
            Answer::Done(done) => done,
            Answer::TooLarge(refusal) => return Ok(Answer::TooLarge(refusal)),
        };

        let ends = &mut session.ends;
        let (grains, impulses) =
            (ends.grains.of(window.number, iteration)?, ends.impulse.of(window.number, iteration)?);
        exchange.react(&grains, &impulses, window.step, |passage| coupling.reaction(passage, window.step));
        if !coupling.two_way {
            exchange.reactions.fill(Default::default());
        }
        let (fluid_ledger, norms, linear_iterations) =
            match session.advance_fluid(window, iteration, &exchange.reactions)? {
                Answer::Done(done) => done,
                Answer::TooLarge(refusal) => return Ok(Answer::TooLarge(refusal)),
            };

        outcome.iterations = iteration;
        outcome.substeps += substeps;
        outcome.linear_iterations += linear_iterations;
        let samples = session.ends.samples.of(window.number, iteration)?;
        let shape = coupling.shape;
        let force = || exchange.force_change(&samples, shape, window.step);
        if is_finished(coupling, norms, force, &mut outcome, window)? {
            if coupling.two_way {
                outcome.crossed = Some(exchange.settle(&samples, coupling.shape, window.step, owed));
            }
            (outcome.grains, outcome.fluid) = (Some(grain_ledger), Some(fluid_ledger));
            return Ok(Answer::Done(outcome));
        }
        session.restore()?;
    }
    unreachable!("the loop returns")
}

fn is_finished(
    coupling: &mut Coupling,
    norms: Norms,
    force: impl FnOnce() -> Change,
    outcome: &mut Outcome,
    window: Window,
) -> Result<bool, CouplerError> {
    if !coupling.implicit {
        return Ok(true);
    }
    let velocity = Change { change: norms.velocity_change, reference: norms.velocity };
    let pressure = Change { change: norms.pressure_change, reference: norms.pressure };
    let (verdict, residuals) = coupling.judge.judge(&velocity, &pressure, &force());
    outcome.residuals = Some(residuals);
    let not_converged = CouplerError::NotConverged {
        window: window.number,
        time: window.time,
        iterations: outcome.iterations,
        residuals,
    };
    match verdict {
        Verdict::Converged => Ok(true),
        Verdict::Diverged => Err(not_converged),
        Verdict::Continue if outcome.iterations >= coupling.max_iterations => Err(not_converged),
        Verdict::Continue => Ok(false),
    }
}

/// The window of a scene with one side only.
///
/// # Errors
/// A participant's failure.
pub fn single_window(session: &mut Session, window: Window) -> Result<Answer<Outcome>, CouplerError> {
    let mut outcome = Outcome { iterations: 1, ..Outcome::default() };
    if session.dem {
        let (ledger, substeps) = match session.advance_dem(window, 1, &[])? {
            Answer::Done(done) => done,
            Answer::TooLarge(refusal) => return Ok(Answer::TooLarge(refusal)),
        };
        outcome.grains = Some(ledger);
        outcome.substeps = substeps;
    }
    if session.fluid {
        let (ledger, _, linear_iterations) = match session.advance_fluid(window, 1, &[])? {
            Answer::Done(done) => done,
            Answer::TooLarge(refusal) => return Ok(Answer::TooLarge(refusal)),
        };
        outcome.fluid = Some(ledger);
        outcome.linear_iterations = linear_iterations;
    }
    Ok(Answer::Done(outcome))
}
