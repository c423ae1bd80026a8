//! Steady flows that the elements hold exactly, and the lid-driven cavity.

use crate::support::{advance, box_mesh, flow, given};
use fluid_solver::backend::eulerian::Properties;
use fluid_solver::boundary::Condition;
use fluid_solver::mesh::locate::{Location, Locator};

/// A periodic channel, 0 ≤ y ≤ 1, one step so long that the flow is steady at its end.
fn steady_channel(viscosity: f64, force: f64, wall_speed: f64) -> Vec<(f64, [f64; 2])> {
    let properties = Properties { density: 2.0, viscosity, gravity: [0.0; 2], tolerance: 1e-10 };
    let mesh = box_mesh::<2, 3>([0.0; 2], [1.0; 2], [6, 10], [true, false], None);
    let mut flow = flow(mesh, properties, |name| match name {
        "y-max" => Condition::MovingWall(std::sync::Arc::new(move |_, _| [wall_speed, 0.0])),
        _ => Condition::NoSlip,
    });
    flow.set_body_force(|_| [force, 0.0]);
    advance(&mut flow, 0.0, 1e12, 2, |_, _| ());
    let nodes = flow.mesh().nodes().iter();
    nodes.zip(&flow.state().velocity).map(|(x, &u)| (x[1], u)).collect()
}

#[test]
fn plane_poiseuille_flow_is_exact_at_the_nodes() {
    let (viscosity, force) = (0.7, 3.0);
    for (y, u) in steady_channel(viscosity, force, 0.0) {
        let exact = 2.0 * force * y * (1.0 - y) / (2.0 * viscosity);
        assert!((u[0] - exact).abs() < 1e-8 && u[1].abs() < 1e-8, "y = {y}: {u:?}, exact {exact}");
    }
}

#[test]
fn plane_couette_flow_is_exact() {
    for (y, u) in steady_channel(0.7, 0.0, 1.5) {
        assert!((u[0] - 1.5 * y).abs() < 1e-8 && u[1].abs() < 1e-8, "y = {y}: {u:?}");
    }
}

#[test]
fn uniform_flow_passes_a_jump_of_void_fraction_along_it_unchanged() {
    let velocity = [0.8, 0.0];
    let properties = Properties { density: 1.2, viscosity: 1e-3, gravity: [0.0; 2], tolerance: 1e-10 };
    let mesh = box_mesh::<2, 3>([0.0; 2], [1.0; 2], [8, 8], [false; 2], None);
    let mut flow = flow(mesh, properties, |name| match name {
        "x-min" => given(move |_, _| velocity),
        "x-max" => Condition::Outlet { pressure: 0.0 },
        _ => Condition::Slip,
    });
    let void: Vec<f64> = flow.mesh().nodes().iter().map(|x| if x[1] < 0.55 { 0.4 } else { 1.0 }).collect();
    flow.state_mut().reset_void_fraction(&void);
    flow.set_velocity(|_| velocity);
    advance(&mut flow, 0.0, 0.05, 10, |_, _| ());
    for u in &flow.state().velocity {
        assert!((u[0] - velocity[0]).abs() < 1e-12 && u[1].abs() < 1e-12, "{u:?}");
    }
}

/// A column of a csv file with comment lines, by header.
fn column(text: &str, name: &str) -> Vec<f64> {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let place = lines
        .next()
        .and_then(|header| header.split(',').position(|other| other == name))
        .expect("the column");
    lines
        .map(|line| line.split(',').nth(place).and_then(|value| value.parse().ok()).expect("a number"))
        .collect()
}

#[test]
fn the_lid_driven_cavity_agrees_with_ghia_at_reynolds_100() {
    let properties = Properties { density: 1.0, viscosity: 0.01, gravity: [0.0; 2], tolerance: 1e-8 };
    let mesh = box_mesh::<2, 3>([0.0; 2], [1.0; 2], [32, 32], [false; 2], None);
    let mut flow = flow(mesh, properties, |name| match name {
        "y-max" => Condition::MovingWall(std::sync::Arc::new(|_, _| [1.0, 0.0])),
        _ => Condition::NoSlip,
    });
    advance(&mut flow, 0.0, 0.1, 200, |_, _| ());
    let text = include_str!("../reference/cavity/cavity2d_ghia1982_u.csv");
    let locator = Locator::new(flow.mesh());
    for (y, reference) in column(text, "y").into_iter().zip(column(text, "u_Re100")) {
        let Location::Inside { cell, coordinates } = locator.locate(flow.mesh(), &[0.5, y], None) else {
            panic!("the line is in the cavity")
        };
        let nodes = flow.mesh().cell_nodes(cell as usize);
        let u: f64 = (0..3).map(|i| coordinates[i] * flow.state().velocity[nodes[i] as usize][0]).sum();
        assert!((u - reference).abs() < 0.015, "u(0.5, {y}) = {u}, Ghia {reference}");
    }
}
