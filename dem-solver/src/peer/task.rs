//! What a peer is asked to compute: the scene of a case as set up, in the terms that all peers share.

use case_io::document::{Case, Dimension};

use super::error::PeerError;
use super::own_case::stated;
use super::told::refuse_untold;
use super::wall::{Course, PeerWall, WallShape, walls};
use crate::contact::NormalLaw;
use crate::critical_time_step::{critical_time_step, substeps};
use crate::scene::{Escape, Scene};
use crate::setup::set_up;
use crate::vector::{Spin, Vector};

/// With at most so many grains, trajectories are compared where the formulas are the same: with more, round-off
/// grows from impact to impact until only statistics mean anything.
const FEW: usize = 32;

/// A grain at the start.
#[derive(Clone, Debug, PartialEq)]
pub struct Sphere {
    /// Centre at t = 0 \[m\].
    pub centre: Vector<3>,
    /// Radius \[m\].
    pub radius: f64,
    /// Velocity at t = 0 \[m/s\].
    pub velocity: Vector<3>,
    /// Angular velocity at t = 0 \[rad/s\].
    pub angular_velocity: Spin,
    /// Density \[kg/m³\].
    pub density: f64,
    /// Index of its material.
    pub material: u32,
    /// Whether it is fixed in place.
    pub frozen: bool,
}

/// What the peer writes while it computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recording {
    /// Place, velocity and spin of every grain at every sample.
    Trajectories,
    /// Means over the grains at every sample, and the mean force on each wall since the last one.
    Statistics,
}

/// What a peer is asked to compute.
#[derive(Clone, Debug, PartialEq)]
pub struct Task {
    /// The title of the case.
    pub title: String,
    /// Materials, laws, gravity and domain.
    pub scene: Scene<3>,
    /// The grains; row k is number k + 1 at the peer.
    pub grains: Vec<Sphere>,
    /// The walls.
    pub walls: Vec<PeerWall>,
    /// The time step \[s\].
    pub step: f64,
    /// Steps from sample to sample.
    pub steps_per_sample: u32,
    /// Samples after the start.
    pub samples: u32,
    /// What is written.
    pub recording: Recording,
}

impl Task {
    /// The task of a case for a peer that computes some laws by the very same formulas.
    ///
    /// # Errors
    /// What no peer could be told: the message names the key.
    pub fn new(case: &Case, same_formulas: impl Fn(&NormalLaw) -> bool) -> Result<Self, PeerError> {
        let document = &case.document;
        let refuse = |key: &str, found: &str, advice: &str| Err(case.error(key, found, "", advice).into());
        refuse_untold(case, &stated(case)?)?;
        if document.case.dimension != Dimension::Three {
            return refuse("case.dimension", "a peer has spheres only, no discs", "take a case in 3D");
        }
        let setup = set_up::<3>(case, None)?;
        let (scene, world) = (setup.scene, setup.world);
        if world.grains.is_empty() {
            return refuse("insertion", "no grain to compare", "insert at least one");
        }
        let end = document.time.end.si();
        let interval = document.output.series(document.time.end).min(end);
        let steps_per_sample = substeps(interval, setup.substep, &critical_time_step(&scene, &world))?;
        let rows = 0..world.grains.len();
        let grains = rows.map(|row| {
            let (place, motion) = (&world.grains.place[row], &world.grains.motion[row]);
            let material = world.grains.material[row];
            Sphere {
                centre: place.centre,
                radius: place.radius,
                velocity: motion.velocity,
                angular_velocity: motion.angular_velocity,
                density: scene.materials.get(material).density,
                material,
                frozen: motion.is_frozen(),
            }
        });
        let grains: Vec<Sphere> = grains.collect();
        let walls = walls(case, &scene)?;
        let oscillates = |wall: &PeerWall| matches!(wall.course, Course::Oscillation(..));
        let is_exact = same_formulas(&scene.normal_law) && !walls.iter().any(oscillates);
        let recording =
            if is_exact && grains.len() <= FEW { Recording::Trajectories } else { Recording::Statistics };
        Ok(Self {
            title: document.case.title.clone(),
            grains,
            walls,
            step: interval / f64::from(steps_per_sample),
            steps_per_sample,
            samples: (end / interval + 1e-9).floor() as u32,
            recording,
            scene,
        })
    }

    /// The same with one step more from sample to sample: the same physics, and another chance for every grain in a
    /// crowd.
    pub fn twin(&self) -> Self {
        let steps_per_sample = self.steps_per_sample + 1;
        Self { step: self.interval() / f64::from(steps_per_sample), steps_per_sample, ..self.clone() }
    }

    /// Time from sample to sample \[s\].
    pub fn interval(&self) -> f64 {
        self.step * f64::from(self.steps_per_sample)
    }

    /// Steps of the whole run.
    pub fn steps(&self) -> u64 {
        u64::from(self.steps_per_sample) * u64::from(self.samples)
    }

    /// Where a grain is half a step after the start, where this program finds its first forces: a peer that starts
    /// from there finds its own at the same places.
    pub fn first_place(&self, grain: &Sphere) -> Vector<3> {
        grain.centre + grain.velocity * (0.5 * self.step)
    }

    /// Radius of the largest grain \[m\].
    pub fn largest_radius(&self) -> f64 {
        self.grains.iter().map(|grain| grain.radius).fold(0.0, f64::max)
    }

    /// Whether grains that leave the domain are removed.
    pub fn removes(&self) -> bool {
        self.scene.escape == Escape::Remove && self.scene.domain.lower[0].is_finite()
    }

    /// The corners of the box around grains, triangles and what the domain has of ends.
    pub fn extent(&self) -> (Vector<3>, Vector<3>) {
        let of_grains = self.grains.iter().flat_map(|grain| {
            let reach = Vector::from_element(grain.radius);
            [grain.centre - reach, grain.centre + reach]
        });
        let of_walls = self.walls.iter().flat_map(|wall| match &wall.shape {
            WallShape::Plane(_) => vec![],
            WallShape::Triangles(facets) => facets.iter().flat_map(|facet| facet.vertices).collect(),
        });
        let domain = &self.scene.domain;
        let of_domain =
            [domain.lower, domain.upper].into_iter().filter(|corner| corner.iter().all(|x| x.is_finite()));
        let points = of_grains.chain(of_walls).chain(of_domain).map(|point| (point, point));
        points.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1))).unwrap_or_default()
    }
}
