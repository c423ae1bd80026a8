//! The ends of the wires between the programs, over shared memory or inside one process.

mod control;
mod frame;
pub mod in_process;
pub mod shared_memory;

pub use control::{CommandReceiver, CommandSender, Deadlines};
pub use frame::{FrameReader, FrameView, FrameWriter, Stamp};

use crate::frames::{GrainRow, HydroRow, ImpulseRow, ReactionRow, SampleRow};

/// The coupler's ends.
pub struct CouplerEnds {
    /// From the DEM.
    pub grains: FrameReader<GrainRow>,
    /// From the DEM.
    pub impulse: FrameReader<ImpulseRow>,
    /// From the fluid.
    pub samples: FrameReader<SampleRow>,
    /// To the DEM.
    pub hydro: FrameWriter<HydroRow>,
    /// To the fluid.
    pub reaction: FrameWriter<ReactionRow>,
    /// Commands to the DEM.
    pub dem: CommandSender,
    /// Commands to the fluid.
    pub fluid: CommandSender,
}

/// The DEM's ends.
pub struct DemEnds {
    /// Commands of the coupler.
    pub control: CommandReceiver,
    /// To the coupler and the fluid.
    pub grains: FrameWriter<GrainRow>,
    /// To the coupler.
    pub impulse: FrameWriter<ImpulseRow>,
    /// From the coupler.
    pub hydro: FrameReader<HydroRow>,
}

/// The fluid's ends.
pub struct FluidEnds {
    /// Commands of the coupler.
    pub control: CommandReceiver,
    /// From the DEM.
    pub grains: FrameReader<GrainRow>,
    /// To the coupler.
    pub samples: FrameWriter<SampleRow>,
    /// From the coupler.
    pub reaction: FrameReader<ReactionRow>,
}
