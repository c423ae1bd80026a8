//! Clumps and scenes that several claims share.

use std::sync::Arc;

use dem_solver::body::{Body, Clump, ClumpKind, MassProperties, Member};
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hertz;
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Ledger, Material, Materials, Scene, Spin, Vector, Workspace, World, window};
use nalgebra::UnitQuaternion;

pub const RADIUS: f64 = 1e-3;

pub fn member(offset: [f64; 3], radius: f64) -> Member {
    Member { offset: Vector::from(offset), radius }
}

pub fn kind(members: &[Member]) -> ClumpKind {
    let volume = MassProperties::of_spheres(members, 1.0).mass;
    ClumpKind { shape: Arc::new(Clump::of_spheres(members, 2500.0).unwrap()), material: 0, volume }
}

/// Two equal spheres whose centres are 1.2 radii apart.
pub fn dumbbell() -> ClumpKind {
    let r = RADIUS;
    kind(&[member([-0.6 * r, 0.0, 0.0], r), member([0.6 * r, 0.0, 0.0], r)])
}

/// A clump of four unlike spheres with three unlike moments.
pub fn stone() -> ClumpKind {
    let r = RADIUS;
    kind(&[
        member([0.0, 0.0, 0.0], r),
        member([1.5 * r, 0.0, 0.0], 0.8 * r),
        member([0.0, 1.3 * r, 0.0], 0.6 * r),
        member([0.1 * r, 0.0, 0.9 * r], 0.5 * r),
    ])
}

/// A scene of one material that knows these kinds.
pub fn scene(modulus: f64, (restitution, friction): (f64, f64), kinds: Vec<ClumpKind>) -> Scene<3> {
    let material = Material { density: 2500.0, youngs_modulus: modulus, poissons_ratio: 0.3 };
    let materials = Materials::new(vec![material], |_, _| (restitution, friction));
    Scene::new(materials, NormalLaw::Hertz(Hertz { depth: 1.0 })).with_clumps(kinds)
}

pub fn floor() -> Walls<3> {
    Walls::new(vec![Wall::plane("floor", 0, [0.0; 3], [0.0, 0.0, 1.0])])
}

/// A clump with this centre of mass, turned by this rotation vector.
pub fn placed(
    kind: &ClumpKind,
    centre: [f64; 3],
    turn: [f64; 3],
    velocity: [f64; 3],
    spin: [f64; 3],
) -> Body {
    let rotation = UnitQuaternion::from_scaled_axis(Spin::from(turn));
    let body = kind.shape.body(Spin::zeros(), rotation, Spin::from(velocity), Spin::from(spin));
    Body { centre: Spin::from(centre), ..body }
}

/// Runs a dry window in fresh scratch.
pub fn run<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    duration: f64,
    substeps: u32,
) -> Ledger<D> {
    window(scene, world, &mut Workspace::new(), None, duration, substeps).unwrap()
}

pub fn body<const D: usize>(world: &World<D>, clump: usize) -> Body {
    world.bodies.as_slice()[clump].body
}

/// Momentum and angular momentum about the origin of all clumps.
pub fn momenta(world: &World<3>) -> (Spin, Spin) {
    let one = |clump: &dem_solver::body::Rigid| {
        let linear = clump.body.velocity * clump.shape.mass();
        (linear, clump.body.centre.cross(&linear) + clump.body.angular_momentum)
    };
    let all = world.bodies.as_slice().iter().map(one);
    all.fold((Spin::zeros(), Spin::zeros()), |(p, l), (dp, dl)| (p + dp, l + dl))
}

pub fn kinetic_energy<const D: usize>(world: &World<D>) -> f64 {
    world.bodies.as_slice().iter().map(|clump| clump.kinetic_energies().iter().sum::<f64>()).sum()
}

/// A periodic box of 64 stones and dumbbells, turned at random, that fly at random at about 1 m/s and spin.
pub fn gas(restitution: f64, friction: f64) -> (Scene<3>, World<3>) {
    let side = 0.02;
    let domain = dem_solver::Domain::new([0.0; 3], [side; 3]).periodic([true; 3]);
    let scene = scene(1e7, (restitution, friction), vec![stone(), dumbbell()]).in_domain(domain);
    let mut random = dem_solver::insertion::Random::new(3);
    let mut toss = |size: f64| -> [f64; 3] { std::array::from_fn(|_| random.between(-size, size)) };
    let mut world = World::new();
    for k in 0..64 {
        let at = [k % 4, k / 4 % 4, k / 16].map(|index| (f64::from(index) + 0.5) * side / 4.0);
        let which = (k % 2) as u32;
        let body = placed(&scene.clumps[which as usize], at, toss(3.0), toss(1.0), toss(300.0));
        world.add_clump(&scene, which, body);
    }
    (scene, world)
}
