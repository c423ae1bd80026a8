//! Small scenes that several claims share.

use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::{Hertz, Hooke, Onate};
use dem_solver::wall::{Wall, Walls};
use dem_solver::{DemError, Domain, Grain, Ledger, Material, Materials, Scene, Workspace, World, window};

/// A rather soft glass, of 2500 kg/m³.
pub const GLASS: Material = Material { density: 2500.0, youngs_modulus: 1e7, poissons_ratio: 0.3 };

pub fn glass(restitution: f64, sliding_friction: f64) -> Materials {
    Materials::new(vec![GLASS], |_, _| (restitution, sliding_friction))
}

pub fn hertz() -> NormalLaw {
    NormalLaw::Hertz(Hertz { depth: 1.0 })
}

pub fn partial_slip() -> NormalLaw {
    NormalLaw::HertzPartialSlip(Hertz { depth: 1.0 })
}

pub fn onate() -> NormalLaw {
    NormalLaw::Onate(Onate { area_factor: 1.0, depth: 1.0 })
}

pub fn hooke() -> NormalLaw {
    NormalLaw::Hooke(Hooke { characteristic_velocity: 1.0, depth: 1.0 })
}

pub fn floor<const D: usize>() -> Walls<D> {
    let mut up = [0.0; D];
    up[D - 1] = 1.0;
    Walls::new(vec![Wall::plane("floor", 0, [0.0; D], up)])
}

pub fn world<const D: usize>(scene: &Scene<D>, grains: &[Grain<D>]) -> World<D> {
    let mut world = World::new();
    grains.iter().for_each(|grain| world.add(scene, grain));
    world
}

/// Runs a dry window in fresh scratch.
pub fn run<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    duration: f64,
    substeps: u32,
) -> Result<Ledger<D>, DemError> {
    window(scene, world, &mut Workspace::new(), None, duration, substeps)
}

/// A periodic box of 7³ grains of two sizes, 1 to 1.4 mm, that fly at random at about 1 m/s and rub.
pub fn gas(law: NormalLaw, restitution: f64, friction: f64, side: f64) -> (Scene<3>, World<3>) {
    let domain = Domain::new([0.0; 3], [side; 3]).periodic([true; 3]);
    let scene = Scene::new(glass(restitution, friction), law).in_domain(domain);
    let mut random = dem_solver::insertion::Random::new(3);
    let mut toss = || random.between(-1.0, 1.0);
    let mut grains = Vec::new();
    for k in 0..343 {
        let at = [k % 7, k / 7 % 7, k / 49].map(|index| (f64::from(index) + 0.5) * side / 7.0);
        let radius = if k % 2 == 0 { 5e-4 } else { 7e-4 };
        let spin = [300.0 * toss(), 300.0 * toss(), 300.0 * toss()];
        grains.push(Grain::at(at, radius).moving([toss(), toss(), toss()]).spinning(spin));
    }
    let world = world(&scene, &grains);
    (scene, world)
}

/// Translational and rotational energy of all grains.
pub fn kinetic_energy<const D: usize>(world: &World<D>) -> f64 {
    let motions = world.grains.motion.iter();
    motions.map(|m| 0.5 * m.velocity.norm_squared() / m.inverse_mass + m.rotational_energy()).sum()
}
