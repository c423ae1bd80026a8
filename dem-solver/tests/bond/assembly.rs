//! Bonded spheres with an integrator of their own.

use dem_solver::bond::{Bond, BondLaw, Bonds, End, Links, ParallelBond, Positions, Profile};
use dem_solver::{Vector, inertia, volume};

pub const DENSITY: f64 = 2500.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    pub centre: Vector<3>,
    pub velocity: Vector<3>,
    pub spin: Vector<3>,
    pub radius: f64,
    pub fixed: bool,
}

impl Sphere {
    pub fn at(centre: [f64; 3], radius: f64) -> Self {
        let none = Vector::zeros();
        Self { centre: Vector::from(centre), velocity: none, spin: none, radius, fixed: false }
    }

    pub fn mass(&self) -> f64 {
        DENSITY * volume::<3>(self.radius, 1.0)
    }

    pub fn inertia(&self) -> f64 {
        inertia::<3>(self.mass(), self.radius)
    }

    pub fn end(&self) -> End {
        let free = if self.fixed { 0.0 } else { 1.0 };
        End { radius: self.radius, inverse_mass: free / self.mass(), inverse_inertia: free / self.inertia() }
    }

    pub fn kinetic_energy(&self) -> f64 {
        0.5 * (self.mass() * self.velocity.norm_squared() + self.inertia() * self.spin.norm_squared())
    }
}

pub struct Spheres(pub Vec<Sphere>);

impl Positions for Spheres {
    fn separation(&self, i: usize, j: usize) -> Vector<3> {
        self.0[j].centre - self.0[i].centre
    }

    fn angular_velocity(&self, row: usize) -> Vector<3> {
        self.0[row].spin
    }
}

pub struct Assembly {
    pub laws: Vec<BondLaw>,
    pub spheres: Spheres,
    pub bonds: Bonds,
    pub links: Links,
}

/// Cement of 1 GPa that never breaks.
pub fn cement() -> ParallelBond {
    ParallelBond {
        modulus: 1e9,
        stiffness_ratio: 2.5,
        radius_multiplier: 1.0,
        tensile_strength: f64::INFINITY,
        shear_strength: f64::INFINITY,
        damping_ratio: 0.0,
    }
}

impl Assembly {
    /// Spheres, those that touch bonded.
    pub fn new(law: BondLaw, spheres: Vec<Sphere>) -> Self {
        let bonds = between_touching(&spheres);
        Self::bonded(law, spheres, bonds)
    }

    /// Spheres with these bonds.
    pub fn bonded(law: BondLaw, spheres: Vec<Sphere>, bonds: Vec<Bond>) -> Self {
        let bonds = Bonds::new(bonds).unwrap();
        let identities: Vec<u64> = (0..spheres.len() as u64).collect();
        let laws = vec![law];
        let links = Links::new(&laws, Profile::Round, &bonds, &identities, |row| spheres[row].end()).unwrap();
        Self { laws, spheres: Spheres(spheres), bonds, links }
    }

    fn fly(&mut self, time: f64) {
        self.bonds.fly(time);
        self.spheres.0.iter_mut().for_each(|sphere| sphere.centre += sphere.velocity * time);
    }

    /// One step: half a flight, forces, half a flight; `push` is another force on a row, `drag` a rate at which all
    /// motion fades. Returns how many bonds broke.
    pub fn step(&mut self, step: f64, push: impl Fn(usize) -> Vector<3>, drag: f64) -> usize {
        self.fly(0.5 * step);
        let broke = self.links.pull(&self.laws, &mut self.bonds, &self.spheres).unwrap();
        for (row, sphere) in self.spheres.0.iter_mut().enumerate().filter(|(_, sphere)| !sphere.fixed) {
            let (force, torque) = self.links.load(row);
            let keeps = 1.0 - drag * step;
            sphere.velocity = sphere.velocity * keeps + (force + push(row)) * (step / sphere.mass());
            sphere.spin = sphere.spin * keeps + torque * (step / sphere.inertia());
        }
        self.fly(0.5 * step);
        broke
    }

    /// One step without any other force.
    pub fn step_alone(&mut self, step: f64) {
        self.step(step, |_| Vector::zeros(), 0.0);
    }

    /// The longest stable step, by the bounds of all rows.
    pub fn critical_step(&self) -> f64 {
        let of_row = |(row, sphere): (usize, &Sphere)| {
            self.links.resistance(row, sphere.mass() / sphere.inertia()).critical_step(1.0 / sphere.mass())
        };
        self.spheres.0.iter().enumerate().map(of_row).fold(f64::INFINITY, f64::min)
    }

    pub fn kinetic_energy(&self) -> f64 {
        self.spheres.0.iter().map(Sphere::kinetic_energy).sum()
    }

    pub fn stored_energy(&self) -> f64 {
        self.bonds.iter().zip(self.links.beams()).map(|(bond, beam)| bond.stored_energy(beam)).sum()
    }
}

pub fn between_touching(spheres: &[Sphere]) -> Vec<Bond> {
    let mut bonds = vec![];
    for (i, one) in spheres.iter().enumerate() {
        for (j, other) in spheres.iter().enumerate().skip(i + 1) {
            let separation = other.centre - one.centre;
            if separation.norm() < 1.0001 * (one.radius + other.radius) {
                bonds.push(Bond::new([i as u64, j as u64], 0, separation));
            }
        }
    }
    bonds
}

/// `count` spheres of this radius in a row along x, the first at the origin.
pub fn row(count: usize, radius: f64) -> Vec<Sphere> {
    (0..count).map(|k| Sphere::at([2.0 * radius * k as f64, 0.0, 0.0], radius)).collect()
}

/// `n`³ spheres of this radius in a cube.
pub fn cube(n: usize, radius: f64) -> Vec<Sphere> {
    let place = |k: usize| 2.0 * radius * k as f64;
    (0..n * n * n).map(|k| Sphere::at([place(k % n), place(k / n % n), place(k / n / n)], radius)).collect()
}

/// A number in -1..1 that looks random.
pub fn noise(seed: usize) -> f64 {
    let mixed = (seed as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mixed = (mixed ^ (mixed >> 31)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    (mixed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

pub fn noise3(seed: usize) -> Vector<3> {
    Vector::from([noise(3 * seed), noise(3 * seed + 1), noise(3 * seed + 2)])
}
