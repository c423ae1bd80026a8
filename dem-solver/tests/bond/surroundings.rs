//! Bonds in a fluid, in two dimensions, and across periods.

use dem_solver::bond::{Bond, BondLaw, Bonds};
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hertz;
use dem_solver::{
    Domain, Grain, Material, Materials, Scene, Vector, Workspace, World, critical_time_step, window,
};
use interface::HydroRow;

use crate::assembly::cement;

const RADIUS: f64 = 1e-3;
const DEPTH: f64 = 4e-3;

fn scene<const D: usize>() -> Scene<D> {
    let stone = Material { density: 2500.0, youngs_modulus: 1e7, poissons_ratio: 0.3 };
    let materials = Materials::new(vec![stone], |_, _| (0.5, 0.4));
    let law = NormalLaw::Hertz(Hertz { depth: DEPTH });
    Scene { depth: DEPTH, ..Scene::new(materials, law).with_bond_laws(vec![BondLaw::ParallelBond(cement())]) }
}

/// Elongation of a bond whose grains a fluid at rest, with a drag of its own, draws apart with this force \[N\].
fn elongation<const D: usize>(force: f64, drag: f64) -> f64 {
    let scene = scene::<D>();
    let mut world = World::new();
    let on_axis = |x: f64| {
        let mut at = [0.0; D];
        at[0] = x;
        Grain::at(at, RADIUS)
    };
    [on_axis(0.0), on_axis(2.0 * RADIUS)].iter().for_each(|grain| world.add(&scene, grain));
    world.bonds = Bonds::new(vec![Bond::new([0, 1], 0, Vector::x() * (2.0 * RADIUS))]).unwrap();
    let drawn =
        |force: f64| HydroRow { exchange_coefficient: drag, force: [force, 0.0, 0.0], ..Default::default() };
    let step = 0.5 * critical_time_step(&scene, &world).step;
    let mut workspace = Workspace::new();
    let rows = [drawn(-force), drawn(force)];
    let ledger = window(&scene, &mut world, &mut workspace, Some(&rows), 1000.0 * step, 1000).unwrap();
    assert!(ledger.residual().norm() < 1e-13 * ledger.scale);
    // What each grain received is what the fluid drew it with and the bond held it with.
    for impulse in &workspace.impulse {
        assert!((impulse.other[0] + impulse.drag[0]).abs() < 1e-3 * force * 1000.0 * step);
    }
    let [one, other] = [0, 1].map(|row| world.grains.place[row].centre);
    (other - one).norm() - 2.0 * RADIUS
}

#[test]
fn a_bond_that_a_fluid_draws_apart_stretches_as_a_rod_of_its_cement() {
    let (force, modulus, length) = (1.0, cement().modulus, 2.0 * RADIUS);
    let rod = std::f64::consts::PI * RADIUS * RADIUS;
    let strip = 2.0 * RADIUS * DEPTH;
    for (found, area) in [(elongation::<3>(force, 5.0), rod), (elongation::<2>(force, 20.0), strip)] {
        let expected = force * length / (modulus * area);
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} m, a rod {expected} m");
    }
}

#[test]
fn a_ring_through_a_period_swings_alike_wherever_it_is_struck() {
    const COUNT: usize = 10;
    let spacing = 2.0 * RADIUS;
    let period = COUNT as f64 * spacing;
    let domain = Domain::new([0.0, -1.0, -1.0], [period, 1.0, 1.0]).periodic([true, false, false]);
    let scene = scene::<3>().in_domain(domain);
    let struck = |which: usize| {
        let mut world = World::new();
        for k in 0..COUNT {
            let speed = if k == which { [0.1, 0.3, -0.2] } else { [0.0; 3] };
            world.add(&scene, &Grain::at([(k as f64 + 0.5) * spacing, 0.0, 0.0], RADIUS).moving(speed));
        }
        let bond = |k: usize| Bond::new([k as u64, ((k + 1) % COUNT) as u64], 0, Vector::x() * spacing);
        world.bonds = Bonds::new((0..COUNT).map(bond).collect()).unwrap();
        let step = 0.5 * critical_time_step(&scene, &world).step;
        window(&scene, &mut world, &mut Workspace::new(), None, 500.0 * step, 500).unwrap();
        world.grains.motion
    };
    let (first, last, blow) = (struck(4), struck(COUNT - 1), 0.374);
    for k in 0..COUNT {
        let (a, b) = (&first[k], &last[(k + 5) % COUNT]);
        // Places differ by round-off, 4e-18 m, on which bonds of 1.6e6 N/m pull for the whole time.
        let (off, turned) = (a.velocity - b.velocity, a.angular_velocity - b.angular_velocity);
        assert!(
            off.norm() < 1e-8 * blow && turned.norm() * RADIUS < 1e-8 * blow,
            "{off} m/s, {turned} rad/s"
        );
    }
    // The blow has gone all around.
    assert!(first.iter().all(|motion| motion.velocity.norm() > 1e-4));
}
