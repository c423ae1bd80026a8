//! The executable `fluid-solver`.

use crate::backend;
use crate::command::Command;
use crate::couple::FluidParticipant;
use crate::error::FluidError;
use crate::gauge::Gauge;
use crate::record::Record;
use case_io::document::{Case, Overrides, Scheme};
use case_io::exit_code::ExitCode;
use case_io::plan::Plan;
use interface::InterfaceError;
use interface::assignment::Assignment;
use interface::message::Failure;
use interface::participant::serve;
use interface::run::Who;
use interface::transport::{FluidEnds, shared_memory};

/// Runs the command line; returns the exit code.
pub fn main() -> std::process::ExitCode {
    let participate = |part: &Assignment| {
        // A pool that exists already computes the same bits.
        let _ = rayon::ThreadPoolBuilder::new().num_threads(part.threads).build_global();
        let abandon = Box::new(|| std::process::exit(i32::from(ExitCode::PeerDied.code())));
        take_part(part, shared_memory::join_as_fluid(part.run_id()?, part.deadlines(), abandon)?)
    };
    interface::solver::main((Who::Fluid, env!("CARGO_PKG_DESCRIPTION")), participate, |command: Command| {
        command.run().into()
    })
}

/// Sets up the fluid of a case and serves the coupler over any transport.
///
/// # Errors
/// This side's own failure once it is reported; a dead or frozen coupler.
pub fn take_part(part: &Assignment, ends: FluidEnds) -> Result<(), InterfaceError> {
    let FluidEnds { mut control, grains, samples, reaction } = ends;
    let frames = (grains, samples, reaction);
    serve(&mut control, part.hold.as_ref(), |_| set_up(part, frames).map_err(Failure::from))
}

type Frames = (
    interface::transport::FrameReader<interface::GrainRow>,
    interface::transport::FrameWriter<interface::SampleRow>,
    interface::transport::FrameReader<interface::ReactionRow>,
);

fn set_up(part: &Assignment, frames: Frames) -> Result<FluidParticipant, FluidError> {
    let case = load(part)?;
    let document = &case.document;
    let probes = document.probe.iter().map(Gauge::from).collect();
    let record = Record::new(&part.out, probes, document.output.compress, document.output.films_start());
    let identity = (case.hash.clone(), Plan::of(document).hash());
    let coupled = document.grains.is_some();
    let one_way = document.coupling.as_ref().is_some_and(|coupling| coupling.scheme == Scheme::OneWay);
    let backend = backend::of(&case, !one_way)?;
    let mut participant = FluidParticipant::new(backend, frames, record, identity, coupled);
    if let Some(folder) = &part.resume {
        participant.resume(folder)?;
    }
    Ok(participant)
}

fn load(part: &Assignment) -> Result<Case, FluidError> {
    let overrides = Overrides { set: part.set.clone(), variant: part.variant.clone() };
    Ok(Case::load_run(&part.case, &overrides, part.name.as_deref())?)
}
