//! The executable `fluid-solver`.

use crate::backend;
use crate::couple::FluidParticipant;
use crate::error::FluidError;
use crate::record::Record;
use case_io::document::{Case, Overrides, Scheme};
use case_io::exit_code::ExitCode;
use case_io::plan::Plan;
use clap::{Parser, Subcommand};
use interface::InterfaceError;
use interface::assignment::Assignment;
use interface::message::Failure;
use interface::participant::serve;
use interface::run::leave_interrupts_to_coupler;
use interface::transport::{FluidEnds, shared_memory};
use std::io::Write;

/// The fluid side of a coupled run; alone on a case without grains.
#[derive(Parser)]
#[command(name = "fluid-solver", version, about, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run a case without grains, with the flags and the output of `coupler run`.
    Run {
        /// Case and flags, as for `coupler run`.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Take part in a coupled run (used by the coupler).
    #[command(hide = true)]
    Participate {
        /// What the coupler wants.
        assignment: String,
    },
}

/// Runs the command line; returns the exit code.
pub fn main() -> std::process::ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            let _ = error.print();
            return if error.use_stderr() { ExitCode::CommandLine.into() } else { ExitCode::Done.into() };
        }
    };
    match arguments.command {
        Command::Run { arguments } => interface::alone::run_by_coupler(&arguments),
        Command::Participate { assignment } => match participate(&assignment) {
            Ok(()) => ExitCode::Done.into(),
            Err(error) => {
                let _ = writeln!(std::io::stderr(), "fluid-solver: {error}");
                FluidError::from(error).exit_code().into()
            }
        },
    }
}

fn participate(assignment: &str) -> Result<(), InterfaceError> {
    leave_interrupts_to_coupler();
    let part = Assignment::from_argument(assignment)?;
    // A pool that exists already computes the same bits.
    let _ = rayon::ThreadPoolBuilder::new().num_threads(part.threads).build_global();
    let abandon = Box::new(|| std::process::exit(i32::from(ExitCode::PeerDied.code())));
    let ends = shared_memory::join_as_fluid(part.run_id()?, part.deadlines(), abandon)?;
    take_part(&part, ends)
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
    let probes = document.probe.iter().map(|probe| (probe.name.clone(), probe.at.to_array())).collect();
    let record = Record::new(&part.out, probes, document.output.compress);
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
    let cases = Case::load(&part.case, &overrides)?;
    cases.into_iter().find(|case| case.run == part.name).ok_or_else(|| {
        FluidError::Interface(InterfaceError::Difference {
            field: "run of the sweep",
            own: "none of this name".to_string(),
            theirs: part.name.clone().unwrap_or_default(),
        })
    })
}
