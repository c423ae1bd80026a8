//! The grains: packed rows, one per grain, near neighbours near in memory.

use crate::body::Carried;
use crate::lanes::{Row4, Row8};
use crate::vector::{Spin, Vector, embed, restrict};

/// Where a grain is and how large, `[x y z r]`; z = 0 in 2D.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(32))]
pub struct Place {
    /// Centre x \[m\].
    pub centre: Spin,
    /// Radius r \[m\].
    pub radius: f64,
}

/// 1/I of a member of a clump: no torque turns it, its clump does. The sign tells it from a grain that does not turn.
pub const CARRIED_INERTIA: f64 = -0.0;

/// How a grain moves, and how it resists, `[v 1/m | ω 1/I]`; in 2D only v_x, v_y and ω_z are not 0. A member of a clump
/// moves as the clump carries it, and resists with the clump's mass.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Motion {
    /// Velocity v \[m/s\].
    pub velocity: Spin,
    /// 1/m \[1/kg\]; 0 for a frozen grain.
    pub inverse_mass: f64,
    /// Angular velocity ω \[rad/s\].
    pub angular_velocity: Spin,
    /// 1/I \[1/(kg m²)\]; 0 for a frozen grain and for a micro grain, which does not turn, [`CARRIED_INERTIA`] for a member
    /// of a clump.
    pub inverse_inertia: f64,
}

impl Place {
    /// The centre in the space of the scene.
    #[inline]
    pub fn at<const D: usize>(&self) -> Vector<D> {
        restrict(&self.centre)
    }
}

impl Motion {
    /// That of a grain fixed in place: no velocity, and no force gives it one.
    pub fn frozen() -> Self {
        Self {
            velocity: Spin::zeros(),
            inverse_mass: 0.0,
            angular_velocity: Spin::zeros(),
            inverse_inertia: 0.0,
        }
    }

    /// That of a member of a clump of this mass \[kg\].
    pub fn carried(carried: &Carried, mass: f64) -> Self {
        Self {
            velocity: carried.velocity,
            inverse_mass: 1.0 / mass,
            angular_velocity: carried.angular_velocity,
            inverse_inertia: CARRIED_INERTIA,
        }
    }

    /// m v²/2 + I ω²/2 of a grain that moves by itself \[J\], else 0.
    pub fn kinetic_energy(&self) -> f64 {
        if !self.is_loose() {
            return 0.0;
        }
        0.5 * self.velocity.norm_squared() / self.inverse_mass + self.rotational_energy()
    }

    /// I ω²/2 of a grain that turns by itself \[J\], else 0.
    pub fn rotational_energy(&self) -> f64 {
        if self.inverse_inertia == 0.0 {
            return 0.0;
        }
        0.5 * self.angular_velocity.norm_squared() / self.inverse_inertia
    }

    /// Whether the grain is fixed in place.
    #[inline]
    pub fn is_frozen(&self) -> bool {
        self.inverse_mass == 0.0
    }

    /// Whether the grain is a member of a clump, which moves it.
    #[inline]
    pub fn is_carried(&self) -> bool {
        self.inverse_inertia.is_sign_negative()
    }

    /// Whether the grain moves by itself.
    #[inline]
    pub fn is_loose(&self) -> bool {
        !self.is_frozen() && !self.is_carried()
    }
}

/// A grain about to be born.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grain<const D: usize> {
    /// Centre x \[m\].
    pub centre: Vector<D>,
    /// Radius r \[m\].
    pub radius: f64,
    /// Velocity v \[m/s\].
    pub velocity: Vector<D>,
    /// Angular velocity ω \[rad/s\].
    pub angular_velocity: Spin,
    /// Index of its material.
    pub material: u32,
    /// Whether it is fixed in place.
    pub frozen: bool,
}

impl<const D: usize> Grain<D> {
    /// A free grain at rest.
    pub fn at(centre: [f64; D], radius: f64) -> Self {
        Self {
            centre: Vector::from(centre),
            radius,
            velocity: Vector::zeros(),
            angular_velocity: Spin::zeros(),
            material: 0,
            frozen: false,
        }
    }

    /// The grain with this velocity.
    pub fn moving(self, velocity: [f64; D]) -> Self {
        Self { velocity: Vector::from(velocity), ..self }
    }

    /// The grain with this angular velocity.
    pub fn spinning(self, angular_velocity: [f64; 3]) -> Self {
        Self { angular_velocity: Spin::from(angular_velocity), ..self }
    }

    /// The grain fixed in place.
    pub fn frozen(self) -> Self {
        Self { frozen: true, ..self }
    }
}

/// All grains. Row `i` of every array is the same grain.
#[derive(Clone, Debug, PartialEq)]
pub struct Grains {
    /// Identity: 0, 1, 2, … in order of birth, never reused.
    pub id: Vec<u64>,
    /// Places.
    pub place: Vec<Place>,
    /// Motions.
    pub motion: Vec<Motion>,
    /// Masses m \[kg\], of frozen grains too; of members of a clump the clump's.
    pub mass: Vec<f64>,
    /// Materials, as indices.
    pub material: Vec<u32>,
}

/// Moment of inertia of a homogeneous body of mass m: 2/5 m r² for a sphere, 1/2 m r² for a disc.
pub fn inertia<const D: usize>(mass: f64, radius: f64) -> f64 {
    let shape = if D == 2 { 0.5 } else { 0.4 };
    shape * mass * radius * radius
}

/// Volume of a sphere, 4/3 π r³, or of a disc of the slab's depth b, π r² b.
pub fn volume<const D: usize>(radius: f64, depth: f64) -> f64 {
    use std::f64::consts::PI;
    if D == 2 { PI * radius * radius * depth } else { 4.0 / 3.0 * PI * radius.powi(3) }
}

impl Grains {
    /// No grain.
    pub fn new() -> Self {
        Self { id: vec![], place: vec![], motion: vec![], mass: vec![], material: vec![] }
    }

    /// Number of grains.
    pub fn len(&self) -> usize {
        self.id.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.id.is_empty()
    }

    /// Adds a grain of this identity and mass as the last row; a micro grain does not turn.
    pub fn push<const D: usize>(&mut self, id: u64, grain: &Grain<D>, mass: f64, micro: bool) {
        let free = Motion {
            velocity: embed(&grain.velocity),
            inverse_mass: 1.0 / mass,
            angular_velocity: if micro { Spin::zeros() } else { grain.angular_velocity },
            inverse_inertia: if micro { 0.0 } else { 1.0 / inertia::<D>(mass, grain.radius) },
        };
        self.id.push(id);
        self.place.push(Place { centre: embed(&grain.centre), radius: grain.radius });
        self.motion.push(if grain.frozen { Motion::frozen() } else { free });
        self.mass.push(mass);
        self.material.push(grain.material);
    }

    /// Adds a member, of this identity and radius \[m\], of a clump of this mass \[kg\] as the last row.
    pub fn push_member(&mut self, id: u64, carried: &Carried, radius: f64, mass: f64, material: u32) {
        self.id.push(id);
        self.place.push(Place { centre: carried.centre, radius });
        self.motion.push(Motion::carried(carried, mass));
        self.mass.push(mass);
        self.material.push(material);
    }

    /// Keeps the rows `order`, in that order.
    pub fn reorder(&mut self, order: &[u32]) {
        fn pick<T: Copy>(rows: &mut Vec<T>, order: &[u32]) {
            *rows = order.iter().map(|&row| rows[row as usize]).collect();
        }
        pick(&mut self.id, order);
        pick(&mut self.place, order);
        pick(&mut self.motion, order);
        pick(&mut self.mass, order);
        pick(&mut self.material, order);
    }

    /// Largest radius \[m\]; 0 without grains.
    pub fn largest_radius(&self) -> f64 {
        self.place.iter().map(|place| place.radius).fold(0.0, f64::max)
    }

    /// Mean diameter \[m\]; 0 without grains.
    pub fn mean_diameter(&self) -> f64 {
        2.0 * self.place.iter().map(|place| place.radius).sum::<f64>() / self.len().max(1) as f64
    }

    /// Copies `other` into memory that is already here.
    pub fn copy_from(&mut self, other: &Self) {
        self.id.clone_from(&other.id);
        self.place.clone_from(&other.place);
        self.motion.clone_from(&other.motion);
        self.mass.clone_from(&other.mass);
        self.material.clone_from(&other.material);
    }
}

impl Default for Grains {
    fn default() -> Self {
        Self::new()
    }
}

/// Rows as lanes load them.
pub trait AsRows {
    /// What a row is to lanes.
    type Row;

    /// The same numbers.
    fn as_rows(&self) -> &[Self::Row];

    /// The same numbers.
    fn as_rows_mut(&mut self) -> &mut [Self::Row];
}

macro_rules! as_rows {
    ($one:ty, $row:ty) => {
        const _: () =
            assert!(size_of::<$one>() == size_of::<$row>() && align_of::<$one>() == align_of::<$row>());

        impl AsRows for [$one] {
            type Row = $row;

            fn as_rows(&self) -> &[$row] {
                // SAFETY: both are `repr(C)`, f64 throughout, of one size and alignment.
                unsafe { std::slice::from_raw_parts(self.as_ptr().cast(), self.len()) }
            }

            fn as_rows_mut(&mut self) -> &mut [$row] {
                // SAFETY: as above.
                unsafe { std::slice::from_raw_parts_mut(self.as_mut_ptr().cast(), self.len()) }
            }
        }
    };
}
as_rows!(Place, Row4);
as_rows!(Motion, Row8);
