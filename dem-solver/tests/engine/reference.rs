//! Against a reference that tries every pair in every step: no cells, no lists, no chunks, no lanes.

use dem_solver::contact::normal::{Hertz, Hooke, Normal};
use dem_solver::contact::tangential::{Coulomb, Frictionless, PartialSlip, Tangential};
use dem_solver::contact::{Annuli, Coefficients, Spring, Touch, touch_force};
use dem_solver::lanes::Vec3;
use dem_solver::wall::Shape;
use dem_solver::{Grains, Scene, Vector, Workspace, World, window};

use super::scenes::{HERTZ, HOOKE, PARTIAL_SLIP, STEP, boxed, one_to_twenty, periodic};

const STEPS: u32 = 150;

fn vec3(v: &Vector<3>) -> Vec3<f64> {
    Vec3::new(v.x, v.y, v.z)
}

/// What a contact remembers.
type History = (Spring, Annuli);

fn relaxed() -> History {
    (Spring::relaxed(), Annuli::relaxed())
}

struct Reference<'a> {
    scene: &'a Scene<3>,
    grains: Grains,
    /// Springs of each grain with each grain, then with each wall.
    springs: Vec<Vec<History>>,
}

impl Reference<'_> {
    fn step<N: Normal<3>, T: Tangential>(&mut self, flight: f64) {
        let count = self.grains.len();
        let mut loads = vec![(Vector::zeros(), Vector::zeros()); count];
        for i in 0..count {
            for j in i + 1..count {
                let mut separation = self.grains.place[j].centre - self.grains.place[i].centre;
                for axis in (0..3).filter(|&axis| self.scene.domain.periodic[axis]) {
                    let period = self.scene.domain.period(axis);
                    separation[axis] -= period * (separation[axis] / period).round();
                }
                let (a, b) = (self.grains.place[i].radius, self.grains.place[j].radius);
                let overlap = a + b - separation.norm();
                if overlap <= 0.0 {
                    self.springs[i][j] = relaxed();
                    continue;
                }
                let normal = separation.normalize();
                let arms = (normal * arm::<N>(a, overlap, a + b), normal * arm::<N>(b, overlap, a + b));
                let (m, n) = (self.grains.motion[i], self.grains.motion[j]);
                let (one, other) = (self.grains.material[i], self.grains.material[j]);
                if m.is_frozen() && n.is_frozen() {
                    continue;
                }
                let mass = 1.0 / (m.inverse_mass + n.inverse_mass);
                let constants = self.scene.coefficients((one, other), a * b / (a + b), mass).unwrap();
                let velocity = m.velocity - n.velocity
                    + m.angular_velocity.cross(&arms.0)
                    + n.angular_velocity.cross(&arms.1);
                let force = force::<N, T>(&constants, &normal, overlap, &velocity, &mut self.springs[i][j]);
                loads[i].0 += force;
                loads[j].0 -= force;
                loads[i].1 += arms.0.cross(&force);
                loads[j].1 += arms.1.cross(&force);
            }
            for (k, surface) in self.scene.walls.surfaces.iter().enumerate() {
                let Shape::Plane(plane) = surface.shape else { unreachable!("only planes here") };
                let radius = self.grains.place[i].radius;
                let distance = (self.grains.place[i].centre - plane.point).dot(&plane.normal);
                let spring = &mut self.springs[i][count + k];
                if distance >= radius {
                    *spring = relaxed();
                    continue;
                }
                let arm = -plane.normal * arm::<N>(radius, radius - distance, f64::INFINITY);
                let motion = self.grains.motion[i];
                let materials = (self.grains.material[i], self.scene.walls.materials[surface.wall as usize]);
                let constants = self.scene.coefficients(materials, radius, self.grains.mass[i]).unwrap();
                let velocity = motion.velocity + motion.angular_velocity.cross(&arm);
                let force = force::<N, T>(&constants, &-plane.normal, radius - distance, &velocity, spring);
                loads[i].0 += force;
                loads[i].1 += arm.cross(&force);
            }
        }
        for (i, (force, torque)) in loads.into_iter().enumerate() {
            let motion = &mut self.grains.motion[i];
            if !motion.is_frozen() {
                motion.velocity += (force * motion.inverse_mass + self.scene.gravity) * STEP;
                motion.angular_velocity += torque * (motion.inverse_inertia * STEP);
                self.grains.place[i].centre += motion.velocity * flight;
            }
        }
    }
}

/// The lever arm of a body of this radius where two touch that reach so far.
fn arm<N: Normal<3>>(radius: f64, overlap: f64, reach: f64) -> f64 {
    N::arm(radius, overlap, radius / reach)
}

fn force<N: Normal<3>, T: Tangential>(
    constants: &Coefficients,
    normal: &Vector<3>,
    overlap: f64,
    velocity: &Vector<3>,
    history: &mut History,
) -> Vector<3> {
    let touch = Touch { normal: vec3(normal), overlap, velocity: vec3(velocity) };
    let force =
        touch_force::<3, N, T, f64>(constants, &touch, 0.0, (&mut history.0, &mut history.1), STEP).force;
    Vector::from([force.x, force.y, force.z])
}

/// Holds the engine against the reference: velocities, spins and places to `within` of the largest change.
fn check<N: Normal<3>, T: Tangential>((scene, start): (Scene<3>, World<3>), within: f64) {
    let grains = &start.grains;
    let springs = vec![vec![relaxed(); grains.len() + scene.walls.surfaces.len()]; grains.len()];
    let mut reference = Reference { scene: &scene, grains: grains.clone(), springs };
    for place in 0..grains.len() {
        let half = reference.grains.motion[place].velocity * (0.5 * STEP);
        reference.grains.place[place].centre += half;
    }
    for k in 1..=STEPS {
        reference.step::<N, T>(if k < STEPS { STEP } else { 0.5 * STEP });
    }
    let mut found = start.clone();
    let mut workspace = Workspace::new();
    for _ in 0..3 {
        // Half a flight at the end of a window and half a one at the start of the next are a whole one.
        window(&scene, &mut found, &mut workspace, None, f64::from(STEPS / 3) * STEP, STEPS / 3).unwrap();
        found.contacts.expire();
    }
    let counters = found.contacts.counters;
    assert!(counters.outer > 1 && counters.inner > counters.outer);
    let (mut differences, mut changes) = ([0.0_f64; 3], [0.0_f64; 3]);
    let state = |grains: &Grains, row: usize, axis: usize| {
        let (place, motion) = (&grains.place[row], &grains.motion[row]);
        [place.centre[axis], motion.velocity[axis], motion.angular_velocity[axis]]
    };
    for (row, axis) in (0..start.grains.len()).flat_map(|row| (0..3).map(move |axis| (row, axis))) {
        let [here, there, before] =
            [&found.grains, &reference.grains, &start.grains].map(|grains| state(grains, row, axis));
        for k in 0..3 {
            let mut off = here[k] - there[k];
            if k == 0 && scene.domain.periodic[axis] {
                off -= scene.domain.period(axis) * (off / scene.domain.period(axis)).round();
            }
            differences[k] = differences[k].max(off.abs());
            changes[k] = changes[k].max((there[k] - before[k]).abs());
        }
    }
    for k in 0..3 {
        // Smooth grains keep their spin: 1 rad/s is the scale then.
        let scale = if k == 2 && !T::REMEMBERS { 1.0 } else { changes[k] };
        let relative = differences[k] / scale;
        assert!(relative < within, "{}: {relative:.1e}", ["place", "velocity", "spin"][k]);
    }
}

#[test]
fn like_grains_in_a_box_move_as_the_reference_says() {
    check::<Hertz, Coulomb>(boxed(3, false, HERTZ, 0.5), 1e-11);
    check::<Hooke, Coulomb>(boxed(3, false, HOOKE, 0.5), 1e-11);
    check::<Hertz, Frictionless>(boxed(3, false, HERTZ, 0.0), 1e-11);
}

#[test]
fn mixed_and_frozen_grains_in_a_box_move_as_the_reference_says() {
    check::<Hertz, Coulomb>(boxed(3, true, HERTZ, 0.5), 1e-11);
    check::<Hertz, PartialSlip>(boxed(3, true, PARTIAL_SLIP, 0.5), 1e-11);
}

#[test]
fn grains_of_one_to_twenty_in_size_move_as_the_reference_says() {
    check::<Hertz, Coulomb>(one_to_twenty(), 1e-11);
}

#[test]
fn grains_meet_the_images_of_others_as_the_reference_says() {
    check::<Hertz, Coulomb>(periodic(3, false), 1e-11);
    check::<Hertz, Coulomb>(periodic(3, true), 1e-11);
}
