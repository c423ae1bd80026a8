//! The scenes, as cases: E 5 MPa, ν 0.3, e 0.5, μ 0.5, ρ 2500 kg/m³, R 1 mm, Δt 10 µs, Hertz–Mindlin.

use std::f64::consts::TAU;

use clap::ValueEnum;

use super::drum::{Drum, RATE, STEADY};
use crate::grains::Grain;
use crate::insertion::Random;
use crate::peer::File;
use crate::vector::Vector;

/// Time step \[s\].
pub const STEP: f64 = 1e-5;
/// Of the places and velocities at the start.
pub const SEED: u64 = 1;
/// The file of the grains.
pub const GRAINS: &str = "grains.csv";
/// How much the settled bed is dilated to be loose.
pub const DILATION: f64 = 1.12;

/// Largest bed that settles as a whole, and about the largest tower of a larger one.
const LARGEST_BED: usize = 100_000;
const LARGEST_TOWER: f64 = 40_000.0;

/// Radius R \[m\].
const RADIUS: f64 = 1e-3;
/// Share of the gas that is solid.
const GAS_SOLID: f64 = 0.12;
/// Speed of all grains of the gas \[m/s\].
const GAS_SPEED: f64 = 0.3;

/// A scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BenchScene {
    /// A settled bed, as high as wide, in an open box.
    Dense,
    /// The settled bed dilated 1.12 and thrown down at 0.5 m/s.
    Loose,
    /// Grains that fly about at 0.3 m/s in a periodic box, 12 % of it solid.
    Gas,
    /// A settled bed of radii from 0.5 to 2.5 mm.
    Polydisperse,
    /// A drum of triangles, half full, at 20 turns a minute.
    Drum,
}

/// When a state is one to measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Settling {
    /// At once.
    Never,
    /// When its grains are at rest.
    UntilRest,
    /// After so many seconds.
    For(f64),
}

impl BenchScene {
    /// Name in tables and paths.
    pub fn word(self) -> &'static str {
        match self {
            Self::Dense => "dense",
            Self::Loose => "loose",
            Self::Gas => "gas",
            Self::Polydisperse => "polydisperse",
            Self::Drum => "drum",
        }
    }

    /// Numbers of grains that are measured unless others are asked for.
    pub fn sizes(self) -> &'static [usize] {
        match self {
            Self::Dense => &[10_000, 50_000],
            Self::Loose | Self::Gas => &[50_000],
            Self::Polydisperse | Self::Drum => &[20_000],
        }
    }

    /// Steps of a run: about 16 million particle-steps, but as many as lists live for.
    pub fn steps(self, grains: usize) -> u32 {
        match self {
            Self::Loose => 400,
            Self::Gas => 800,
            Self::Dense | Self::Polydisperse | Self::Drum => (16_000_000 / grains as u32).clamp(200, 2000),
        }
    }

    /// How its state comes about.
    pub fn settling(self) -> Settling {
        match self {
            Self::Dense | Self::Polydisperse => Settling::UntilRest,
            Self::Loose | Self::Gas => Settling::Never,
            Self::Drum => Settling::For(STEADY),
        }
    }

    /// The largest radius \[m\].
    fn largest_radius(self) -> f64 {
        if self == Self::Polydisperse { 2.5 * RADIUS } else { RADIUS }
    }

    /// Towers along each side of a bed that is too large to settle as a whole in minutes: each settles as they all do.
    pub fn towers(self, grains: usize) -> usize {
        match self {
            Self::Dense | Self::Polydisperse if grains > LARGEST_BED => {
                (grains as f64 / LARGEST_TOWER).sqrt().ceil() as usize
            }
            _ => 1,
        }
    }

    /// Side of the box \[m\].
    pub fn width(self, grains: usize) -> f64 {
        let count = grains as f64;
        match self {
            Self::Dense => 1.95 * RADIUS * count.cbrt(),
            Self::Loose => DILATION * Self::Dense.width(grains),
            Self::Polydisperse => 3.3 * RADIUS * count.cbrt(),
            Self::Gas => (count * crate::volume::<3>(RADIUS, 1.0) / GAS_SOLID).cbrt(),
            Self::Drum => 2.0 * Drum::half_full(grains, RADIUS).radius,
        }
    }

    /// The grains before they settle, in a box of this side \[m\]; those of the loose scene are the dense one's.
    pub fn start(self, count: usize, width: f64) -> Vec<Grain<3>> {
        let mut random = Random::new(SEED);
        match self {
            Self::Dense | Self::Loose | Self::Polydisperse => self.columns(count, width, &mut random),
            Self::Gas => self.flying(count, width, &mut random),
            Self::Drum => {
                let drum = Drum::half_full(count, RADIUS);
                let cells = (2.0 * drum.radius / (2.1 * RADIUS)) as usize;
                let corner = Vector::from([-drum.radius, 0.0, -drum.radius]);
                let all = (0..cells.pow(3)).map(|k| corner + cell(k, cells) * (2.1 * RADIUS));
                let inside = all.filter(|centre| drum.holds(centre, 1.05 * RADIUS)).take(count);
                inside.map(|centre| Grain::at(centre.into(), RADIUS).moving(jolt(&mut random))).collect()
            }
        }
    }

    /// Grains in columns, 5 % of a diameter apart, each a little aside and on its way.
    fn columns(self, count: usize, width: f64, random: &mut Random) -> Vec<Grain<3>> {
        let pitch = 2.1 * self.largest_radius();
        let per_side = ((width / pitch) as usize).max(1);
        let mut tops = vec![0.0; per_side * per_side];
        let grains = (0..count).map(|k| {
            let radius = match self {
                Self::Polydisperse => RADIUS * random.between(0.5, 2.5),
                _ => RADIUS,
            };
            let column = k % tops.len();
            let aside = |cell: usize, random: &mut Random| {
                (cell as f64 + 0.5) * pitch + RADIUS * random.between(0.0, 0.04)
            };
            let (x, y) = (aside(column % per_side, random), aside(column / per_side, random));
            let z = tops[column] + 1.05 * radius;
            tops[column] = z + 1.05 * radius;
            Grain::at([x, y, z], radius).moving(jolt(random))
        });
        grains.collect()
    }

    /// Grains of one speed in all directions, each anywhere in a cell of its own.
    fn flying(self, count: usize, width: f64, random: &mut Random) -> Vec<Grain<3>> {
        let per_side = (count as f64).cbrt().ceil() as usize;
        let pitch = width / per_side as f64;
        let grains = (0..count).map(|k| {
            let room = pitch - 2.05 * RADIUS;
            let centre = cell(k, per_side).map(|n| n * pitch + room * random.between(-0.5, 0.5));
            let (cosine, angle) = (random.between(-1.0, 1.0), random.between(0.0, TAU));
            let sine = (1.0 - cosine * cosine).sqrt();
            let direction = [sine * angle.cos(), sine * angle.sin(), cosine];
            Grain::at(centre.into(), RADIUS).moving(direction.map(|u| GAS_SPEED * u))
        });
        grains.collect()
    }

    /// The files of its case in a box of this side \[m\], but for the grains.
    pub fn case(self, count: usize, width: f64) -> Vec<File> {
        let word = self.word();
        let gravity = if self == Self::Gas { 0.0 } else { -9.81 };
        let run = f64::from(self.steps(count)) * STEP;
        // A rounding longer, lest the run get one step more.
        let step = STEP * (1.0 + 1e-9);
        let surroundings = match self {
            Self::Dense | Self::Loose | Self::Polydisperse => open_box(width),
            Self::Gas => "periodic = [\"x\", \"y\", \"z\"]\n".to_string() + &domain([0.0; 3], [width; 3]),
            Self::Drum => {
                let reach = 0.5 * width + RADIUS;
                domain([-reach; 3], [reach; 3]) + &drum()
            }
        };
        let text = format!(
            r#"[case]
title = "bench: {word}, {count} grains"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "{gravity} m/s^2"]

[time]
end = "{run} s"
substep = "{step} s"

[output]
series = "{run} s"
frames = "none"
restart = "none"

[materials.glass]
density = "2500 kg/m^3"
youngs-modulus = "5 MPa"
poissons-ratio = 0.3

[pairs.glass-glass]
restitution = 0.5
sliding-friction = 0.5

[[insertion]]
name = "grains"
material = "glass"
file = {{ path = "{GRAINS}" }}

[grains]
normal-law = "hertz"
start-overlap = 0.1
{surroundings}"#
        );
        let mut files = vec![File::new("case.toml", text)];
        if self == Self::Drum {
            files.push(File::new("drum.stl", crate::peer::stl(&Drum::half_full(count, RADIUS).facets())));
        }
        files
    }
}

/// The middle of a cell of a cubic lattice, in units of its pitch, layer by layer.
fn cell(k: usize, per_side: usize) -> Vector<3> {
    Vector::from([k % per_side, k / per_side % per_side, k / per_side / per_side].map(|n| n as f64 + 0.5))
}

/// A velocity to start with, up to 0.1 m/s along each axis.
fn jolt(random: &mut Random) -> [f64; 3] {
    [0; 3].map(|_| random.between(-0.1, 0.1))
}

fn domain(lower: [f64; 3], upper: [f64; 3]) -> String {
    let [lower, upper] = [lower, upper].map(|corner| corner.map(|x| format!("{x} m")));
    format!("domain = {{ lower = {lower:?}, upper = {upper:?} }}\n")
}

/// A floor and four walls.
fn open_box(width: f64) -> String {
    let wall = |name: &str, [x, y]: [f64; 2], normal: [i32; 3]| {
        format!(
            "\n[[wall]]\nname = \"{name}\"\nmaterial = \"glass\"\nplane = {{ point = [\"{x} m\", \"{y} m\", \"0 m\"], normal = {normal:?} }}\n"
        )
    };
    [
        wall("floor", [0.0, 0.0], [0, 0, 1]),
        wall("west", [0.0, 0.0], [1, 0, 0]),
        wall("east", [width, 0.0], [-1, 0, 0]),
        wall("south", [0.0, 0.0], [0, 1, 0]),
        wall("north", [0.0, width], [0, -1, 0]),
    ]
    .concat()
}

fn drum() -> String {
    let rate = TAU * RATE;
    format!(
        "\n[[wall]]\nname = \"drum\"\nmaterial = \"glass\"\nstl = {{ path = \"drum.stl\", rims = 0 }}\nmotion = {{ rotation = {{ axis = [0, 1, 0], point = [\"0 m\", \"0 m\", \"0 m\"], rate = \"{rate} rad/s\" }} }}\n"
    )
}
