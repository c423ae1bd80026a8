use crate::scenes::{floor, glass, hertz, world};
use dem_solver::{Grain, Scene, Vector, Workspace, window};
use interface::HydroRow;

const RADIUS: f64 = 1e-3;

fn falling() -> Scene<3> {
    Scene::new(glass(0.9, 0.3), hertz()).with_gravity([0.0, 0.0, -9.81])
}

#[test]
fn a_grain_relaxes_to_its_terminal_velocity_along_the_exact_exponential() {
    let scene = falling();
    let hydro = HydroRow {
        exchange_coefficient: 4e-4,
        fluid_velocity: [0.3, 0.0, 0.1],
        force: [0.0, 1e-5, 0.0],
        ..Default::default()
    };
    for substeps in [1, 7, 1000] {
        let mut world = world(&scene, &[Grain::at([0.0; 3], RADIUS).moving([0.0, 0.5, 1.0])]);
        let (mass, beta, t) = (world.grains.mass[0], 4e-4, 0.05);
        let rate = beta / mass;
        let terminal = Vector::from([0.3, 1e-5 / beta, 0.1 - 9.81 / rate]);
        let start = Vector::from([0.0, 0.5, 1.0]) - terminal;
        window(&scene, &mut world, &mut Workspace::new(), Some(&[hydro]), t, substeps).unwrap();
        let velocity = terminal + start * (-rate * t).exp();
        let centre = terminal * t - start * ((-rate * t).exp_m1() / rate);
        assert!((world.grains.motion[0].velocity - velocity).norm() < 1e-14, "{substeps}");
        assert!((world.grains.place[0].centre - centre).norm() < 1e-15, "{substeps}");
    }
}

#[test]
fn drag_of_any_strength_is_stable_and_its_impulse_accounts_for_the_motion() {
    let scene = falling();
    for exponent in [0.0, 1e-12, 1e-3, 0.5, 1.0, 30.0, 1e4, 1e8] {
        let mut world = world(&scene, &[Grain::at([0.0; 3], RADIUS).moving([1.0, 0.0, 0.0])]);
        let (mass, t) = (world.grains.mass[0], 1e-3);
        let added_mass = 0.5 * mass;
        let beta = exponent * (mass + added_mass) / (t / 10.0);
        let hydro = HydroRow {
            exchange_coefficient: beta,
            fluid_velocity: [-2.0, 3.0, 0.5],
            force: [1e-6, 0.0, 2e-6],
            added_mass,
            ..Default::default()
        };
        let mut workspace = Workspace::new();
        for _ in 0..5 {
            let before = world.grains.motion[0].velocity;
            let ledger = window(&scene, &mut world, &mut workspace, Some(&[hydro]), t, 10).unwrap();
            let gained = (world.grains.motion[0].velocity - before) * (mass + added_mass);
            let impulse = workspace.impulse[0];
            let scale = impulse.drag.norm() + impulse.other.norm();
            assert!(
                (gained - impulse.drag - impulse.other).norm() < 1e-14 * (scale + mass),
                "x = {exponent}"
            );
            assert!(ledger.residual().norm() < 1e-14 * (scale + mass), "x = {exponent}");
            assert!(world.grains.motion[0].velocity.norm() < 5.0);
        }
        if exponent >= 1e4 {
            let slip = world.grains.motion[0].velocity - Vector::from([-2.0, 3.0, 0.5]);
            assert!(slip.norm() < 1e-3, "x = {exponent}: the grain goes with the fluid");
        }
    }
}

#[test]
fn the_drag_impulse_of_weak_drag_is_that_of_the_slip() {
    // Far from rounding even where other forces are 1e9 times larger.
    let scene = falling();
    let mut world = world(&scene, &[Grain::at([0.0; 3], RADIUS)]);
    let beta = 1e-14;
    let hydro =
        HydroRow { exchange_coefficient: beta, fluid_velocity: [2.0, 0.0, 0.0], ..Default::default() };
    let mut workspace = Workspace::new();
    window(&scene, &mut world, &mut workspace, Some(&[hydro]), 1e-3, 50).unwrap();
    assert!((workspace.impulse[0].drag.x / (beta * 2.0 * 1e-3) - 1.0).abs() < 1e-9);
}

#[test]
fn added_mass_slows_the_fall_of_a_bubble_like_grain() {
    // (m + m_A) dv/dt = m g + buoyancy, exactly.
    let scene = falling();
    let mut world = world(&scene, &[Grain::at([0.0; 3], RADIUS)]);
    let mass = world.grains.mass[0];
    let hydro =
        HydroRow { force: [0.0, 0.0, 3.0 * mass * 9.81], added_mass: 1.5 * mass, ..Default::default() };
    window(&scene, &mut world, &mut Workspace::new(), Some(&[hydro]), 0.1, 13).unwrap();
    assert!((world.grains.motion[0].velocity.z - 2.0 * 9.81 * 0.1 / 2.5).abs() < 1e-14);
}

#[test]
fn a_frozen_grain_feels_the_fluid_and_its_support_takes_it() {
    let scene = falling();
    let mut world =
        world(&scene, &[Grain::at([0.0; 3], RADIUS).frozen(), Grain::at([0.0, 0.0, 1.9e-3], RADIUS)]);
    let hydro = HydroRow {
        exchange_coefficient: 2e-3,
        fluid_velocity: [0.5, 0.0, 0.0],
        force: [0.0, 1e-4, 0.0],
        ..Default::default()
    };
    let mut workspace = Workspace::new();
    let ledger =
        window(&scene, &mut world, &mut workspace, Some(&[hydro, HydroRow::default()]), 1e-3, 100).unwrap();
    assert_eq!(world.grains.place[0].centre.norm(), 0.0);
    assert!((ledger.supports - Vector::from([1e-6, 1e-7, 0.0])).norm() < 1e-19);
    assert!((workspace.impulse[0].drag.x - 1e-6).abs() < 1e-19);
    assert!(ledger.frozen.z > 0.0 && ledger.residual().norm() < 1e-14 * ledger.scale);
}

#[test]
fn a_torque_spins_a_grain_up_evenly() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz()).with_walls(floor());
    let mut world = world(&scene, &[Grain::at([0.0, 0.0, 1.0], RADIUS)]);
    let hydro = HydroRow { torque: [0.0, 0.0, 1e-9], ..Default::default() };
    window(&scene, &mut world, &mut Workspace::new(), Some(&[hydro]), 0.1, 10).unwrap();
    let inertia = 0.4 * world.grains.mass[0] * RADIUS * RADIUS;
    assert!((world.grains.motion[0].angular_velocity.z / (1e-9 * 0.1 / inertia) - 1.0).abs() < 1e-13);
}

#[test]
fn hydro_rows_that_do_not_fit_the_grains_are_refused() {
    let scene = falling();
    let mut world = world(&scene, &[Grain::at([0.0; 3], RADIUS)]);
    let mut run = |rows: &[HydroRow]| {
        window(&scene, &mut world, &mut Workspace::new(), Some(rows), 1e-3, 1).unwrap_err()
    };
    assert!(run(&[]).to_string().contains("0 rows for 1 grains"));
    let driving = HydroRow { exchange_coefficient: -1.0, ..Default::default() };
    assert!(run(&[driving]).to_string().contains("grain 0: exchange coefficient -1 kg/s"));
    let unknown = HydroRow { force: [f64::NAN, 0.0, 0.0], ..Default::default() };
    assert!(run(&[unknown]).to_string().contains("grain 0: its velocity or spin is not finite"));
}
