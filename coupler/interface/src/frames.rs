//! The frames: `#[repr(C)]` rows that cross between the programs, one row per grain.
//!
//! All numbers are f64 in SI units and every vector has three components; in two dimensions the scene is a
//! slab of stated depth, z = 0, and mass, volume and force are those of the slab. Row `i` is the same grain
//! in every frame of a window. Rows are written in place in loaned memory and read in place.

use bytemuck::{Pod, Zeroable};
use iceoryx2::prelude::ZeroCopySend;

/// Version of frames and messages; programs of different versions refuse each other.
pub const PROTOCOL: u32 = 4;

/// Which frame a row belongs to. From → to: `grains` dem → coupler and fluid, `impulse` dem → coupler,
/// `samples` fluid → coupler, `hydro` coupler → dem, `reaction` coupler → fluid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameKind {
    /// Where the grains are and how they move.
    Grains,
    /// What the grains received in a window.
    Impulse,
    /// The fluid at the grains.
    Samples,
    /// What the fluid does to the grains.
    Hydro,
    /// What the grains do to the fluid.
    Reaction,
}

impl FrameKind {
    /// The frame's name in services and messages.
    pub fn name(self) -> &'static str {
        match self {
            FrameKind::Grains => "grains",
            FrameKind::Impulse => "impulse",
            FrameKind::Samples => "samples",
            FrameKind::Hydro => "hydro",
            FrameKind::Reaction => "reaction",
        }
    }
}

/// A record that may cross the wall.
pub trait Row: Pod + ZeroCopySend + std::fmt::Debug + Send + Sync {
    /// The frame made of such rows.
    const KIND: FrameKind;
}

/// Header of every frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, ZeroCopySend)]
#[repr(C)]
pub struct Header {
    /// [`PROTOCOL`] of the writer.
    pub protocol: u32,
    /// Coupling iteration, from 1; 0 for what is published before the first iteration.
    pub iteration: u32,
    /// The run that the frame belongs to.
    pub run: u64,
    /// Window number, from 0.
    pub window: u64,
    /// Counts the frames of this kind in this run.
    pub sequence: u64,
    /// Number of rows.
    pub rows: u64,
    /// 1 if grains were born, removed or re-sorted since the last window, else 0.
    pub order_changed: u64,
    /// The instant that the rows describe \[s\].
    pub time: f64,
    /// Length of the window \[s\].
    pub step: f64,
}

/// A grain: place, motion, size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable, ZeroCopySend)]
#[repr(C)]
pub struct GrainRow {
    /// Identity: 0, 1, 2, … in order of birth, never reused.
    pub id: u64,
    /// Centre x \[m\].
    pub position: [f64; 3],
    /// Velocity v \[m/s\].
    pub velocity: [f64; 3],
    /// Angular velocity ω \[rad/s\].
    pub angular_velocity: [f64; 3],
    /// Radius \[m\].
    pub radius: f64,
    /// Inertia against acceleration \[kg\]; infinite for a grain that is frozen in place.
    pub mass: f64,
}

/// What a grain received in a window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable, ZeroCopySend)]
#[repr(C)]
pub struct ImpulseRow {
    /// Drag impulse J = ∫β(u − v)dt \[N s\].
    pub drag: [f64; 3],
    /// Mean over the window of all other forces \[N\].
    pub other: [f64; 3],
}

/// The fluid at a grain, Σ_a w_a f_a with the kernel weights of the last deposit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable, ZeroCopySend)]
#[repr(C)]
pub struct SampleRow {
    /// Fluid velocity u \[m/s\].
    pub velocity: [f64; 3],
    /// Pressure gradient ∇p \[Pa/m\], lumped nodal recovery.
    pub pressure_gradient: [f64; 3],
    /// Divergence of the viscous stress ∇·τ \[Pa/m\], lumped nodal recovery.
    pub viscous_stress_divergence: [f64; 3],
    /// Material acceleration Du/Dt \[m/s²\].
    pub acceleration: [f64; 3],
    /// Vorticity ∇×u \[1/s\].
    pub vorticity: [f64; 3],
    /// Void fraction n_f \[-\].
    pub void_fraction: f64,
    /// Share of the grain's volume that is in the fluid \[-\]: 1 below a free surface, 0 outside.
    pub wetted_fraction: f64,
    /// Standard deviation σ of the kernel per direction \[m\].
    pub kernel_width: f64,
    /// The grain's own share of the solid fraction at its place φ_own = V Σ_a w_a²/|N_a| \[-\].
    pub own_share: f64,
    /// Fluid density ρ_f \[kg/m³\]; 0 outside the fluid.
    pub density: f64,
    /// Apparent dynamic viscosity μ \[Pa s\].
    pub viscosity: f64,
    /// R(∇p − ∇p′) \[N\]: drag that the fluid's last solution holds because the grain hands the new pressure gradient on;
    /// p′ is the pressure that was sampled before, R the reaction's `relayed_volume`.
    pub relayed_force: [f64; 3],
}

/// What the fluid does to a grain during a window: F + β(u_f − v), on the inertia m + m_A.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable, ZeroCopySend)]
#[repr(C)]
pub struct HydroRow {
    /// Explicit force F \[N\]: all but drag.
    pub force: [f64; 3],
    /// Torque T \[N m\].
    pub torque: [f64; 3],
    /// Exchange coefficient β \[kg/s\].
    pub exchange_coefficient: f64,
    /// Fluid velocity u_f that the drag relaxes to \[m/s\].
    pub fluid_velocity: [f64; 3],
    /// Added mass m_A \[kg\].
    pub added_mass: f64,
}

/// What a grain does to the fluid: F − β_e(u − v*) − R∇(p − p′), p′ the pressure that the grain felt.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable, ZeroCopySend)]
#[repr(C)]
pub struct ReactionRow {
    /// Force on the fluid \[N\]: all but drag and the stress forces, whose reaction the model A equations hold.
    pub force: [f64; 3],
    /// Effective exchange coefficient β_e \[kg/s\] of the window.
    pub exchange_coefficient: f64,
    /// Added mass m_A \[kg\] already inside β_e and v*.
    pub added_mass: f64,
    /// Target velocity v* \[m/s\].
    pub target_velocity: [f64; 3],
    /// R \[m³\]: of the force −V∇p on the grain, the part −R∇p goes on to the fluid within the window by drag and added
    /// mass. 0 where iterations tell the fluid of it.
    pub relayed_volume: f64,
    /// 1/m \[1/kg\]: what an impulse that is owed to the grain will change its velocity by; 0 as above.
    pub inverse_mass: f64,
}

impl Row for GrainRow {
    const KIND: FrameKind = FrameKind::Grains;
}
impl Row for ImpulseRow {
    const KIND: FrameKind = FrameKind::Impulse;
}
impl Row for SampleRow {
    const KIND: FrameKind = FrameKind::Samples;
}
impl Row for HydroRow {
    const KIND: FrameKind = FrameKind::Hydro;
}
impl Row for ReactionRow {
    const KIND: FrameKind = FrameKind::Reaction;
}
