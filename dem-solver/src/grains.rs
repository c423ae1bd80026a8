//! The grains: packed rows, one per grain, near neighbours near in memory.

use crate::vector::{Spin, Vector};

/// Where a grain is and how large: `[x y z r]`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Place<const D: usize> {
    /// Centre x \[m\].
    pub centre: Vector<D>,
    /// Radius r \[m\].
    pub radius: f64,
}

/// How a grain moves, and how it resists: `[v 1/m | ω 1/I]`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Motion<const D: usize> {
    /// Velocity v \[m/s\].
    pub velocity: Vector<D>,
    /// 1/m \[1/kg\]; 0 for a frozen grain.
    pub inverse_mass: f64,
    /// Angular velocity ω \[rad/s\].
    pub angular_velocity: Spin,
    /// 1/I \[1/(kg m²)\]; 0 for a frozen grain.
    pub inverse_inertia: f64,
}

impl<const D: usize> Motion<D> {
    /// That of a grain fixed in place: no velocity, and no force gives it one.
    pub fn frozen() -> Self {
        Self {
            velocity: Vector::zeros(),
            inverse_mass: 0.0,
            angular_velocity: Spin::zeros(),
            inverse_inertia: 0.0,
        }
    }

    /// Whether the grain is fixed in place.
    #[inline]
    pub fn is_frozen(&self) -> bool {
        self.inverse_mass == 0.0
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
pub struct Grains<const D: usize> {
    /// Identity: 0, 1, 2, … in order of birth, never reused.
    pub id: Vec<u64>,
    /// Places.
    pub place: Vec<Place<D>>,
    /// Motions.
    pub motion: Vec<Motion<D>>,
    /// Masses m \[kg\], of frozen grains too.
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

impl<const D: usize> Grains<D> {
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

    /// Adds a grain of this identity and mass as the last row.
    pub fn push(&mut self, id: u64, grain: &Grain<D>, mass: f64) {
        let free = Motion {
            velocity: grain.velocity,
            inverse_mass: 1.0 / mass,
            angular_velocity: grain.angular_velocity,
            inverse_inertia: 1.0 / inertia::<D>(mass, grain.radius),
        };
        self.id.push(id);
        self.place.push(Place { centre: grain.centre, radius: grain.radius });
        self.motion.push(if grain.frozen { Motion::frozen() } else { free });
        self.mass.push(mass);
        self.material.push(grain.material);
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

    /// Copies `other` into memory that is already here.
    pub fn copy_from(&mut self, other: &Self) {
        self.id.clone_from(&other.id);
        self.place.clone_from(&other.place);
        self.motion.clone_from(&other.motion);
        self.mass.clone_from(&other.mass);
        self.material.clone_from(&other.material);
    }
}

impl<const D: usize> Default for Grains<D> {
    fn default() -> Self {
        Self::new()
    }
}
