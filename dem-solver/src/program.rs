//! The executable `dem-solver`.

use crate::command::Command;
use crate::couple::{DemParticipant, Frames};
use crate::error::DemError;
use crate::record::Record;
use crate::setup::{FluidMesh, set_up};
use crate::wall::Facet;
use case_io::document::{Case, Dimension, Overrides};
use case_io::exit_code::ExitCode;
use case_io::plan::Plan;
use interface::InterfaceError;
use interface::assignment::Assignment;
use interface::message::{Failure, Surface};
use interface::participant::serve;
use interface::run::Who;
use interface::transport::{CommandReceiver, DemEnds, shared_memory};

/// Runs the command line; returns the exit code.
pub fn main() -> std::process::ExitCode {
    let participate = |part: &Assignment| {
        // A pool that exists already computes the same bits.
        let _ = rayon::ThreadPoolBuilder::new().num_threads(part.threads).build_global();
        let abandon = Box::new(|| std::process::exit(i32::from(ExitCode::PeerDied.code())));
        take_part(part, shared_memory::join_as_dem(part.run_id()?, part.deadlines(), abandon)?)
    };
    interface::solver::main((Who::Dem, env!("CARGO_PKG_DESCRIPTION")), participate, |command: Command| {
        command.run().into()
    })
}

/// Sets up the grains of a case and serves the coupler over any transport.
///
/// # Errors
/// This side's own failure once it is reported; a dead or frozen coupler.
pub fn take_part(part: &Assignment, ends: DemEnds) -> Result<(), InterfaceError> {
    let DemEnds { mut control, grains, impulse, hydro } = ends;
    let frames = (grains, impulse, hydro);
    let dimension = load(part).map(|case| case.document.case.dimension);
    match dimension {
        Ok(Dimension::Two) => serve_case::<2>(part, frames, &mut control),
        // What keeps the case from being loaded is told when the coupler asks.
        Ok(Dimension::Three) | Err(_) => serve_case::<3>(part, frames, &mut control),
    }
}

fn serve_case<const D: usize>(
    part: &Assignment,
    frames: Frames,
    control: &mut CommandReceiver,
) -> Result<(), InterfaceError> {
    serve(control, part.hold.as_ref(), |hello| {
        participant::<D>(part, frames, hello.surface.as_ref()).map_err(Failure::from)
    })
}

fn participant<const D: usize>(
    part: &Assignment,
    frames: Frames,
    surface: Option<&Surface>,
) -> Result<DemParticipant<D>, DemError> {
    let case = load(part)?;
    let setup = set_up::<D>(&case, surface.map(FluidMesh::from).as_ref())?;
    let record = Record::new(&part.out, &case.document.output);
    let identity = (case.hash.clone(), Plan::of(&case.document).hash());
    let mut participant = DemParticipant::new(setup, frames, record, identity, case.document.fluid.is_some());
    if let Some(folder) = &part.resume {
        participant.resume(folder)?;
    }
    Ok(participant)
}

impl<const D: usize> From<&Surface> for FluidMesh<D> {
    fn from(surface: &Surface) -> Self {
        let point = |point: &[f64; 3]| -> [f64; D] { std::array::from_fn(|axis| point[axis]) };
        let facet =
            |vertices: &[[f64; 3]; 3]| Facet::new(std::array::from_fn(|vertex| point(&vertices[vertex])));
        let facets = |list: &Vec<[[f64; 3]; 3]>| list.iter().map(facet).collect();
        FluidMesh {
            bounds: (point(&surface.lower), point(&surface.upper)),
            boundaries: surface.facets.iter().map(|(name, list)| (name.clone(), facets(list))).collect(),
        }
    }
}

fn load(part: &Assignment) -> Result<Case, DemError> {
    let overrides = Overrides { set: part.set.clone(), variant: part.variant.clone() };
    Ok(Case::load_run(&part.case, &overrides, part.name.as_deref())?)
}
