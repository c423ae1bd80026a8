//! One impact: a sphere on a wall, or two spheres head on, from the first touch until they part.

use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hertz;
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Grain, Material, Materials, Motion, Scene, Workspace, World, volume, window};

/// Substeps in Hertz's time of an elastic contact.
const SUBSTEPS: f64 = 1000.0;

pub const GLASS: Material = Material { density: 2800.0, youngs_modulus: 4.8e10, poissons_ratio: 0.2 };
pub const LIMESTONE: Material = Material { density: 2500.0, youngs_modulus: 2e10, poissons_ratio: 0.25 };
pub const MAGNESIUM_ALLOY: Material =
    Material { density: 1800.0, youngs_modulus: 4e10, poissons_ratio: 0.35 };
pub const ALUMINIUM_OXIDE: Material =
    Material { density: 4000.0, youngs_modulus: 3.8e11, poissons_ratio: 0.23 };
pub const CAST_IRON: Material = Material { density: 7000.0, youngs_modulus: 1e11, poissons_ratio: 0.25 };
pub const STEEL: Material = Material { density: 7850.0, youngs_modulus: 2.08e11, poissons_ratio: 0.3 };
pub const POLYETHYLENE: Material = Material { density: 1400.0, youngs_modulus: 1e9, poissons_ratio: 0.4 };
pub const ALUMINIUM_ALLOY: Material =
    Material { density: 2700.0, youngs_modulus: 7e10, poissons_ratio: 0.33 };
pub const NYLON: Material = Material { density: 1000.0, youngs_modulus: 2.5e9, poissons_ratio: 0.4 };
pub const COPPER: Material = Material { density: 8900.0, youngs_modulus: 1.2e11, poissons_ratio: 0.35 };

/// The material, as stiff as a wall that does not give way.
pub fn rigid(material: Material) -> Material {
    Material { youngs_modulus: 1e4 * material.youngs_modulus, ..material }
}

/// How two bodies rebound: restitution e and friction μ.
#[derive(Clone, Copy)]
pub struct Surface {
    pub restitution: f64,
    pub friction: f64,
}

/// An impact under way, and its substep.
pub struct Impact {
    pub scene: Scene<3>,
    pub world: World<3>,
    pub step: f64,
}

impl Impact {
    /// A sphere just above a rigid wall z = 0.
    pub fn on_wall(material: Material, surface: Surface, radius: f64, velocity: [f64; 3], spin: f64) -> Self {
        let materials =
            Materials::new(vec![material, rigid(material)], |_, _| (surface.restitution, surface.friction));
        let mass = material.density * volume::<3>(radius, 1.0);
        let step = step(&materials, radius, mass, -velocity[2]);
        let walls = Walls::new(vec![Wall::plane("wall", 1, [0.0; 3], [0.0, 0.0, 1.0])]);
        let scene = Scene::<3>::new(materials, LAW).with_walls(walls);
        let centre = [0.0, 0.0, radius - 0.3 * velocity[2] * step];
        Self::begin(scene, &[Grain::at(centre, radius).moving(velocity).spinning([0.0, spin, 0.0])], step)
    }

    /// Two spheres about to touch, their speeds along x and their spins about z.
    pub fn of_two(
        materials: [Material; 2],
        surface: Surface,
        radius: [f64; 2],
        speed: [f64; 2],
        spin: [f64; 2],
    ) -> Self {
        let mass = [0, 1].map(|k| materials[k].density * volume::<3>(radius[k], 1.0));
        let materials = Materials::new(materials.to_vec(), |_, _| (surface.restitution, surface.friction));
        let both = |a: f64, b: f64| a * b / (a + b);
        let closing = speed[0] - speed[1];
        let step = step(&materials, both(radius[0], radius[1]), both(mass[0], mass[1]), closing);
        let gap = 0.3 * closing * step;
        let grains = [0, 1].map(|k| {
            let side = [-1.0, 1.0][k];
            let grain = Grain::at([side * (radius[k] + 0.5 * gap), 0.0, 0.0], radius[k]);
            Grain { material: k as u32, ..grain.moving([speed[k], 0.0, 0.0]).spinning([0.0, 0.0, spin[k]]) }
        });
        Self::begin(Scene::<3>::new(materials, LAW), &grains, step)
    }

    fn begin(scene: Scene<3>, grains: &[Grain<3>], step: f64) -> Self {
        let mut world = World::new();
        grains.iter().for_each(|grain| world.add(&scene, grain));
        Self { scene, world, step }
    }

    /// Moves on by so many substeps.
    pub fn advance(&mut self, substeps: u32) {
        let duration = f64::from(substeps) * self.step;
        window(&self.scene, &mut self.world, &mut Workspace::new(), None, duration, substeps).unwrap();
    }

    /// How each sphere moves when they have parted.
    pub fn end(mut self) -> Vec<Motion> {
        // The most damped contact here lasts twice as long as an elastic one.
        self.advance(3 * SUBSTEPS as u32);
        self.world.grains.motion
    }
}

const LAW: NormalLaw = NormalLaw::Hertz(Hertz { depth: 1.0 });

/// A part of 2.94 (m*²/(R* E*² v))^(1/5), which an elastic impact at closing speed v lasts.
fn step(materials: &Materials, radius: f64, mass: f64, speed: f64) -> f64 {
    let modulus = materials.pair(0, 1).effective_modulus;
    2.94 * (mass * mass / (radius * modulus * modulus * speed)).powf(0.2) / SUBSTEPS
}
