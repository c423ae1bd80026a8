//! Tests 4 and 5 under Mindlin & Deresiewicz's contact, which slips in part.

use crate::compare::{Peers, peers};
use crate::curve::Curve;
use crate::impact::{ALUMINIUM_ALLOY, ALUMINIUM_OXIDE, Impact, POLYETHYLENE, STEEL, Surface};
use dem_solver::Material;
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hertz;

/// A sphere on a rigid wall.
#[derive(Clone, Copy)]
struct Test {
    material: Material,
    surface: Surface,
    radius: f64,
}

const fn test_4(material: Material) -> Test {
    Test { material, surface: Surface { restitution: 0.98, friction: 0.092 }, radius: 2.5e-3 }
}

const fn test_5(material: Material) -> Test {
    Test { material, surface: Surface { restitution: 1.0, friction: 0.3 }, radius: 1e-5 }
}

impl Test {
    /// Tangential velocity and spin after an impact at these speeds along and against the normal.
    fn rebound(&self, tangential: f64, normal: f64) -> [f64; 2] {
        let velocity = [tangential, 0.0, -normal];
        let mut impact = Impact::on_wall(self.material, self.surface, self.radius, velocity, 0.0);
        impact.scene.normal_law = NormalLaw::HertzPartialSlip(Hertz { depth: 1.0 });
        let end = &impact.end()[0];
        [end.velocity.x, end.angular_velocity.y]
    }

    /// Tangential restitution at this angle from the normal and 3.9 m/s.
    fn restitution(&self, degrees: f64) -> f64 {
        let (sin, cos) = degrees.to_radians().sin_cos();
        self.rebound(3.9 * sin, 3.9 * cos)[0] / (3.9 * sin)
    }

    /// Speed of the surface and spin after an impact at 5 m/s along the normal and x μ 5 m/s across, as parts of μ 5 m/s.
    fn surface_and_spin(&self, x: f64) -> [f64; 2] {
        let unit = self.surface.friction * 5.0;
        let [velocity, spin] = self.rebound(x * unit, 5.0).map(|value| value / unit);
        [velocity - self.radius * spin, -self.radius * spin]
    }

    /// The same surface speed by 400 springs in a row that slip one by one, without damping, in fine steps of a plain
    /// integrator: Mindlin & Deresiewicz's contact by the method of dimensionality reduction.
    fn row_of_springs(&self, x: f64) -> f64 {
        const SPRINGS: usize = 400;
        let Test { material, surface, radius } = *self;
        let (modulus, nu) = (material.youngs_modulus, material.poissons_ratio);
        let normal_modulus = modulus / (1.0 - nu * nu);
        let tangential_modulus = 4.0 * modulus / (2.0 * (2.0 - nu) * (1.0 + nu));
        let mass = material.density * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
        let deepest = (15.0 * mass * 25.0 / (16.0 * normal_modulus * radius.sqrt())).powf(0.4);
        let width = 1.01 * (radius * deepest).sqrt() / SPRINGS as f64;
        let step = 2.94 * deepest / 5.0 / 4000.0;
        let (mut overlap, mut closing, mut sliding) = (0.0, 5.0, x * surface.friction * 5.0);
        let mut held = [0.0_f64; SPRINGS];
        loop {
            overlap += 0.5 * step * closing;
            if overlap < 0.0 {
                return sliding / (surface.friction * 5.0);
            }
            for (k, held) in held.iter_mut().enumerate() {
                let at = (k as f64 + 0.5) * width;
                let limit =
                    (surface.friction * 2.0 * normal_modulus * width * (overlap - at * at / radius)).max(0.0);
                *held = (*held + 2.0 * tangential_modulus * width * sliding * step).clamp(-limit, limit);
            }
            closing -= 4.0 / 3.0 * normal_modulus * radius.sqrt() * overlap.powf(1.5) / mass * step;
            sliding -= 3.5 * held.iter().sum::<f64>() / mass * step;
            overlap += 0.5 * step * closing;
        }
    }
}

#[test]
fn eight_annuli_give_the_surface_speed_of_400_springs() {
    for material in [STEEL, POLYETHYLENE] {
        let test = test_5(material);
        for x in (1..=14).map(|half| 0.5 * f64::from(half)) {
            let (found, exact) = (test.surface_and_spin(x)[0], test.row_of_springs(x));
            println!("row of springs, {x}: {found:.4}, {exact:.4}");
            assert!((found - exact).abs() < 0.04, "{x}: {found}, {exact}");
        }
    }
}

/// Column of the three programs at x, linear between their rows.
fn at(peers: &Peers, column: usize, x: f64) -> [f64; 3] {
    [0, 1, 2].map(|peer| {
        let pair = peers[peer].windows(2).find(|pair| pair[0][0] <= x && x <= pair[1][0]).unwrap();
        let share = (x - pair[0][0]) / (pair[1][0] - pair[0][0]);
        pair[0][column] + share * (pair[1][column] - pair[0][column])
    })
}

/// Root mean squares of errors here and of LIGGGHTS, LAMMPS and YADE.
fn root_mean_squares(errors: &[[f64; 4]]) -> [f64; 4] {
    [0, 1, 2, 3]
        .map(|k| (errors.iter().map(|error| error[k] * error[k]).sum::<f64>() / errors.len() as f64).sqrt())
}

fn compare(title: &str, points: &[(f64, f64)], peers: &Peers, column: usize, found: impl Fn(f64) -> f64) {
    println!("{title}: x, answer | errors here, LIGGGHTS, LAMMPS, YADE");
    let errors: Vec<[f64; 4]> = points
        .iter()
        .map(|&(x, answer)| {
            let [liggghts, lammps, yade] = at(peers, column, x);
            let errors = [found(x), liggghts, lammps, yade].map(|value| value - answer);
            println!("{x:8.3} {answer:10.4} | {errors:+.4?}");
            errors
        })
        .collect();
    let [here, others @ ..] = root_mean_squares(&errors);
    println!("    root mean square | {here:.4} {others:.4?}");
    assert!(others.iter().all(|other| here < *other), "{title}: {here}, {others:?}");
}

#[test]
fn test_4_below_10_degrees_is_nearer_to_the_experiment_than_three_other_programs() {
    let text = include_str!("reference/test4_tangential_restitution.csv");
    let experiment = Curve::published(text, "experiment_kharaz").up_to(10.0);
    let (oxide, alloy) = (test_4(ALUMINIUM_OXIDE), test_4(ALUMINIUM_ALLOY));
    compare(
        "test 4, aluminium oxide, Kharaz et al.",
        &experiment,
        &peers!("test4_al_oxide.csv"),
        1,
        |angle| oxide.restitution(angle),
    );
    for degrees in [8.0, 9.0, 10.0, 11.0] {
        println!("test 4, {degrees}°: {:.4} {:.4}", oxide.restitution(degrees), alloy.restitution(degrees));
    }
}

#[test]
fn test_5_below_5_is_nearer_to_finite_elements_than_three_other_programs() {
    let [rebound, spin] =
        [include_str!("reference/test5_rebound.csv"), include_str!("reference/test5_spin.csv")].map(|text| {
            Curve::published(text, "fem")
                .up_to(5.0)
                .into_iter()
                .filter(|point| point.0 > 0.066)
                .collect::<Vec<_>>()
        });
    for (name, material, peers) in [
        ("steel", STEEL, peers!("test5_steel.csv")),
        ("polyethylene", POLYETHYLENE, peers!("test5_polyethylene.csv")),
    ] {
        let test = test_5(material);
        compare(&format!("test 5, rebound, {name}"), &rebound, &peers, 1, |x| test.surface_and_spin(x)[0]);
        compare(&format!("test 5, spin, {name}"), &spin, &peers, 2, |x| test.surface_and_spin(x)[1]);
    }
}
