//! Inlets, sliding and curved walls.

use crate::support::{advance, box_mesh, flow, given};
use case_io::document::Profile;
use fluid_solver::FluidError;
use fluid_solver::backend::eulerian::{Flow, Properties};
use fluid_solver::boundary::{Boundaries, BoundaryError, Condition, Inflow};
use fluid_solver::mesh::Mesh;
use fluid_solver::mesh::generate::Pipe;

/// −∮u·n over a boundary.
fn inflow<const D: usize, const N: usize>(flow: &Flow<D, N>, name: &str) -> f64 {
    let (mesh, velocity) = (flow.mesh(), &flow.state().velocity);
    let group = mesh.group(name).expect("the boundary");
    let through = |face: &fluid_solver::mesh::BoundaryFace<D>| -> f64 {
        let area = mesh.area_vector(face);
        let corner =
            |point: u32| (0..D).map(|k| velocity[mesh.node_of(point) as usize][k] * area[k]).sum::<f64>();
        -face.points.map(corner).iter().sum::<f64>() / D as f64
    };
    mesh.boundary().iter().filter(|face| face.group == group).map(through).sum()
}

fn kinetic_energy<const D: usize, const N: usize>(flow: &Flow<D, N>) -> f64 {
    let statistics = flow.statistics(1.0);
    statistics.iter().find(|(name, _)| *name == "kinetic-energy[J]").expect("the energy").1
}

fn pipe(viscosity: f64, profile: Profile) -> Flow<3, 4> {
    let properties = Properties { density: 1000.0, viscosity, gravity: [0.0; 3], tolerance: 1e-8 };
    let mesh = Pipe { radius: 0.01, length: 0.04, rings: 5, layers: 16 }.generate().unwrap();
    flow(mesh, properties, move |name| match name {
        "inlet" => Condition::Inlet(Inflow::Speed { mean: 0.02, profile }),
        "outlet" => Condition::Outlet { pressure: 0.0 },
        _ => Condition::NoSlip,
    })
}

#[test]
fn an_inlet_passes_the_mean_speed_that_is_stated_whatever_its_profile() {
    for profile in [Profile::Constant, Profile::Parabolic] {
        let mut flow = pipe(0.01, profile);
        flow.set_velocity(|_| [0.0; 3]);
        let area: f64 = {
            let mesh = flow.mesh();
            let inlet = mesh.group("inlet").unwrap();
            let faces = mesh.boundary().iter().filter(|face| face.group == inlet);
            faces.map(|face| -mesh.area_vector(face)[2]).sum()
        };
        assert!((inflow(&flow, "inlet") / (0.02 * area) - 1.0).abs() < 1e-12);
        // What enters leaves.
        advance(&mut flow, 0.0, 0.05, 4, |_, _| ());
        assert!((inflow(&flow, "outlet") + inflow(&flow, "inlet")).abs() < 1e-7 * 0.02 * area);
    }
}

#[test]
fn developed_pipe_flow_has_the_pressure_drop_of_poiseuille() {
    let mut flow = pipe(0.01, Profile::Parabolic);
    advance(&mut flow, 0.0, 1e3, 3, |_, _| ());
    let axis = |z: f64| {
        let place = |x: &&[f64; 3]| (x[0].hypot(x[1]) + (x[2] - z).abs()) < 1e-9;
        let node = flow.mesh().nodes().iter().position(|x| place(&x)).expect("a node on the axis");
        (flow.state().velocity[node], flow.state().pressure[node])
    };
    let drop = (axis(0.01).1 - axis(0.03).1) / 0.02;
    let exact = 8.0 * 0.01 * 0.02 / 0.01_f64.powi(2);
    // A polygon of 30 corners and five cells across the radius.
    assert!((drop / exact - 1.0).abs() < 0.02, "{drop} {exact}");
    assert!((axis(0.02).0[2] / 0.04 - 1.0).abs() < 0.03, "{:?}", axis(0.02));
}

#[test]
fn fluid_slides_along_a_round_wall_without_loss() {
    let properties = Properties { density: 1.0, viscosity: 1e-2, gravity: [0.0; 3], tolerance: 1e-10 };
    let mesh = Pipe { radius: 1.0, length: 2.0, rings: 3, layers: 6 }.generate().unwrap();
    let mut flow = flow(mesh, properties, |name| match name {
        "inlet" => given(|_, _| [0.0, 0.0, 1.0]),
        "outlet" => Condition::Outlet { pressure: 0.0 },
        _ => Condition::Slip,
    });
    flow.set_velocity(|_| [0.0, 0.0, 1.0]);
    advance(&mut flow, 0.0, 0.1, 5, |_, _| ());
    for u in &flow.state().velocity {
        assert!((u[2] - 1.0).abs() < 1e-9 && u[0].abs() + u[1].abs() < 1e-9, "{u:?}");
    }
}

#[test]
fn fluid_that_turns_round_in_a_sliding_drum_keeps_its_volume_and_its_energy() {
    let properties = Properties { density: 1.0, viscosity: 1e-2, gravity: [0.0; 3], tolerance: 1e-8 };
    let mesh = Pipe { radius: 1.0, length: 1.0, rings: 6, layers: 6 }.generate().unwrap();
    let mut flow = flow(mesh, properties, |_| Condition::Slip);
    flow.set_velocity(|x| [-x[1], x[0], 0.0]);
    let before = kinetic_energy(&flow);
    advance(&mut flow, 0.0, 0.05, 40, |_, _| ());
    let kept = kinetic_energy(&flow) / before;
    assert!((kept - 1.0).abs() < 0.01, "{kept}");
    assert!(inflow(&flow, "wall").abs() < 1e-12);
}

#[test]
fn backflow_through_an_outlet_does_not_blow_up() {
    let properties = Properties { density: 1.0, viscosity: 1e-4, gravity: [0.0; 2], tolerance: 1e-8 };
    let mesh = box_mesh::<2, 3>([0.0; 2], [1.0; 2], [16, 16], [false; 2], None);
    let mut flow = flow(mesh, properties, |name| match name {
        "x-max" => Condition::Outlet { pressure: 0.0 },
        _ => Condition::Slip,
    });
    // A vortex whose half lies outside: fluid leaves below and enters above.
    flow.set_velocity(|x| [-(x[1] - 0.5), x[0] - 1.0]);
    let before = kinetic_energy(&flow);
    advance(&mut flow, 0.0, 0.05, 100, |_, _| ());
    assert!(kinetic_energy(&flow) < before);
}

#[test]
fn boundaries_are_named_exactly_once() {
    let mesh: Mesh<2, 3> = box_mesh([0.0; 2], [1.0; 2], [3, 2], [true, false], None);
    let refused = |names: &[&str]| {
        Boundaries::new(&mesh, names.iter().map(|name| (name.to_string(), Condition::NoSlip)))
            .err()
            .unwrap()
            .to_string()
    };
    assert_eq!(
        refused(&["y-min", "lid"]),
        "fluid.boundary: the mesh has no boundary \"lid\"; allowed: y-min, y-max"
    );
    assert_eq!(
        refused(&["y-min", "y-min", "y-max"]),
        "fluid.boundary: \"y-min\" is named twice; each boundary of the mesh is named exactly once: delete one"
    );
    assert_eq!(
        refused(&["y-min"]),
        "fluid.boundary: boundary \"y-max\" of the mesh has no condition; each is named exactly once: add it to the `on` of \
         a [[fluid.boundary]]"
    );
}

#[test]
fn an_inlet_without_a_free_node_is_refused_and_a_velocity_that_is_not_finite_is_found() {
    let properties = Properties { density: 1.0, viscosity: 1.0, gravity: [0.0; 2], tolerance: 1e-8 };
    let mesh: Mesh<2, 3> = box_mesh([0.0; 2], [1.0; 2], [4, 1], [false; 2], None);
    let condition = |name: &String| match name.as_str() {
        "x-min" => Condition::Inlet(Inflow::Speed { mean: 1.0, profile: Profile::Parabolic }),
        "x-max" => Condition::Outlet { pressure: 0.0 },
        _ => Condition::NoSlip,
    };
    let named: Vec<_> = mesh.groups().iter().map(|name| (name.clone(), condition(name))).collect();
    let boundaries = Boundaries::new(&mesh, named).unwrap();
    let refused = Flow::new(mesh, &boundaries, properties).err().unwrap();
    assert!(matches!(refused, FluidError::Boundary(BoundaryError::NoFreeNode { .. })), "{refused}");

    let mesh = box_mesh::<2, 3>([0.0; 2], [1.0; 2], [4, 4], [false; 2], None);
    let mut flow = flow(mesh, properties, |_| given(|_, t| [if t > 0.0 { f64::NAN } else { 0.0 }, 0.0]));
    let step = fluid_solver::backend::Step { time: 0.0, length: 0.1 };
    let refused = flow.solve(step, &Default::default(), None).unwrap_err();
    assert_eq!(refused.exit_code(), case_io::exit_code::ExitCode::NonFinite, "{refused}");
}
