//! The grains' books of one window.

use interface::HydroRow;
use interface::ledger::GrainLedger;

use crate::body::Rigid;
use crate::kinetic_energy::kinetic_energies;
use crate::scene::Scene;
use crate::vector::{Spin, Vector, embed, restrict};
use crate::wall::WallImpulse;
use crate::workspace::Workspace;
use crate::world::World;

/// What moving grains had, got and have; impulses in N s, momenta in kg m/s, energies in J.
///
/// `momentum` - `momentum_before` + `added_mass` = `gravity` + `walls` + `frozen` + `asleep` + `drag` + `explicit`.
#[derive(Clone, Debug, PartialEq)]
pub struct Ledger<const D: usize> {
    /// Number of grains, frozen ones and members of clumps included.
    pub count: u64,
    /// Mass of the moving grains \[kg\].
    pub mass: f64,
    /// Momentum at the start.
    pub momentum_before: Vector<D>,
    /// Momentum at the end.
    pub momentum: Vector<D>,
    /// Momentum Σ m_A Δv that the added mass took, which the fluid holds.
    pub added_mass: Vector<D>,
    /// Impulse of gravity.
    pub gravity: Vector<D>,
    /// Impulse of all walls.
    pub walls: Vector<D>,
    /// Impulse of frozen grains, through contacts and bonds.
    pub frozen: Vector<D>,
    /// Impulse that stopped idle grains and holds them asleep.
    pub asleep: Vector<D>,
    /// Drag impulse.
    pub drag: Vector<D>,
    /// Impulse of the fluid's explicit forces.
    pub explicit: Vector<D>,
    /// Drag and explicit impulse on frozen grains, which their supports take.
    pub supports: Vector<D>,
    /// Σ|impulse| over entries plus Σ m|v| over grains: the scale of the residual.
    pub scale: f64,
    /// Kinetic energy of translation and rotation.
    pub kinetic_energy: f64,
    /// Potential energy -Σ m g·x.
    pub potential_energy: f64,
    /// What each wall received.
    pub wall_impulse: Vec<WallImpulse<D>>,
}

impl<const D: usize> Ledger<D> {
    /// Opens the books at the start of a window.
    pub(crate) fn open(world: &World<D>, workspace: &Workspace<D>) -> Self {
        let mut ledger = Self {
            count: 0,
            mass: 0.0,
            momentum_before: momentum(world),
            momentum: Vector::zeros(),
            added_mass: Vector::zeros(),
            gravity: Vector::zeros(),
            walls: Vector::zeros(),
            frozen: Vector::zeros(),
            asleep: Vector::zeros(),
            drag: Vector::zeros(),
            explicit: Vector::zeros(),
            supports: Vector::zeros(),
            scale: 0.0,
            kinetic_energy: 0.0,
            potential_energy: 0.0,
            wall_impulse: vec![],
        };
        for (row, relaxation) in workspace.relaxation.iter().enumerate() {
            let motion = &world.grains.motion[row];
            if !motion.is_frozen() {
                ledger.added_mass -=
                    restrict::<D>(&motion.velocity) * (relaxation.inertia - world.grains.mass[row]);
            }
        }
        ledger
    }

    /// Closes the books after `duration` \[s\].
    pub(crate) fn close(
        &mut self,
        scene: &Scene<D>,
        world: &World<D>,
        workspace: &Workspace<D>,
        hydro: Option<&[HydroRow]>,
        duration: f64,
    ) {
        let grains = &world.grains;
        self.count = grains.len() as u64;
        self.momentum = momentum(world);
        self.kinetic_energy = kinetic_energies(world).iter().sum();
        for Rigid { shape, body, .. } in world.bodies.as_slice() {
            self.weigh(scene, shape.mass(), (&body.centre, &body.velocity), duration);
        }
        for (row, motion) in grains.motion.iter().enumerate() {
            let mass = grains.mass[row];
            if motion.is_loose() {
                self.weigh(scene, mass, (&grains.place[row].centre, &motion.velocity), duration);
            }
            if let Some(hydro) = hydro {
                let explicit: Vector<D> = restrict(&Spin::from(hydro[row].force)) * duration;
                let drag = workspace.impulse[row].drag;
                self.scale += explicit.norm() + drag.norm();
                if motion.is_frozen() {
                    self.supports += drag + explicit;
                } else {
                    self.drag += drag;
                    self.explicit += explicit;
                    self.added_mass +=
                        restrict::<D>(&motion.velocity) * (workspace.relaxation[row].inertia - mass);
                }
            }
        }
        self.wall_impulse = workspace.wall_impulse(scene.walls.len());
        self.frozen = -workspace.chunks.iter().map(|chunk| chunk.frozen_impulse).sum::<Vector<D>>();
        self.walls = -self.wall_impulse.iter().map(|wall| wall.linear).sum::<Vector<D>>();
        self.asleep = workspace.chunks.iter().map(|chunk| chunk.asleep_impulse).sum();
        self.scale += self.walls.norm() + self.frozen.norm() + self.asleep.norm();
    }

    /// Books a body of this mass \[kg\], centre and velocity that moved under gravity for `duration` \[s\].
    fn weigh(&mut self, scene: &Scene<D>, mass: f64, (centre, velocity): (&Spin, &Spin), duration: f64) {
        self.mass += mass;
        self.gravity += scene.gravity * (mass * duration);
        self.scale += mass * (scene.gravity.norm() * duration + velocity.norm());
        self.potential_energy -= mass * scene.gravity.dot(&restrict(centre));
    }

    /// What the books fail to close by \[N s\].
    pub fn residual(&self) -> Vector<D> {
        self.momentum - self.momentum_before + self.added_mass
            - (self.gravity + self.walls + self.frozen + self.asleep + self.drag + self.explicit)
    }

    /// The row as it crosses to the coupler: what holds frozen and sleeping grains counts as a wall, the
    /// reaction of the added mass as an explicit force.
    pub fn row(&self) -> GrainLedger {
        let vector = |v: &Vector<D>| embed(v).into();
        GrainLedger {
            count: self.count,
            mass: self.mass,
            momentum_before: vector(&self.momentum_before),
            momentum: vector(&self.momentum),
            gravity: vector(&self.gravity),
            walls: vector(&(self.walls + self.frozen + self.asleep)),
            drag: vector(&self.drag),
            explicit: vector(&(self.explicit - self.added_mass)),
            supports: vector(&self.supports),
            scale: self.scale,
            kinetic_energy: self.kinetic_energy,
        }
    }
}

/// Momentum Σ m v of the moving grains and clumps.
pub fn momentum<const D: usize>(world: &World<D>) -> Vector<D> {
    let grains = &world.grains;
    let moving = grains.motion.iter().zip(&grains.mass).filter(|(motion, _)| motion.is_loose());
    let of_grains: Vector<D> = moving.map(|(motion, &mass)| restrict::<D>(&motion.velocity) * mass).sum();
    let clumps = world.bodies.as_slice().iter();
    let of_clumps: Vector<D> =
        clumps.map(|clump| restrict::<D>(&clump.body.velocity) * clump.shape.mass()).sum();
    of_grains + of_clumps
}
