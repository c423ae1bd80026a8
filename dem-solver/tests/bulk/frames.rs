//! Fields of the grains in frames.

use case_io::document::GrainField;
use case_io::output::vtk::{Compression, Format, Frame, Precision};
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hertz;
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Grain, Material, Materials, Scene, Workspace, World, window, write_grains};

const RADIUS: f64 = 1e-3;
const ALL: [GrainField; 10] = [
    GrainField::Id,
    GrainField::Radius,
    GrainField::Mass,
    GrainField::Velocity,
    GrainField::AngularVelocity,
    GrainField::Material,
    GrainField::ContactForce,
    GrainField::ContactTorque,
    GrainField::Coordination,
    GrainField::KineticEnergy,
];

/// The frame of these grains on a floor under gravity, after a while.
fn frame(gravity: [f64; 3], grains: &[Grain<3>], fields: &[GrainField]) -> (Frame, World<3>) {
    let glass = Material { density: 2500.0, youngs_modulus: 1e7, poissons_ratio: 0.3 };
    let floor = Walls::new(vec![Wall::plane("floor", 0, [0.0; 3], [0.0, 0.0, 1.0])]);
    let scene = Scene::<3>::new(
        Materials::new(vec![glass], |_, _| (0.1, 0.5)),
        NormalLaw::Hertz(Hertz { depth: 1.0 }),
    )
    .with_gravity(gravity)
    .with_walls(floor);
    let mut world = World::new();
    grains.iter().for_each(|grain| world.add(&scene, grain));
    window(&scene, &mut world, &mut Workspace::new(), None, 0.05, 10_000).unwrap();
    let format = Format { precision: Precision::Double, compression: Compression::None };
    let path = std::env::temp_dir().join(format!("silt-fields-{}-{}.vtp", std::process::id(), grains.len()));
    write_grains(&path, format, fields, &scene, &world).unwrap();
    let frame = Frame::read(&path).unwrap();
    std::fs::remove_file(path).unwrap();
    (frame, world)
}

#[test]
fn a_grain_that_bears_another_shows_what_its_contacts_do() {
    let grains = [Grain::at([0.0, 0.0, RADIUS], RADIUS), Grain::at([0.0, 0.0, 3.0 * RADIUS], RADIUS)];
    let (frame, world) = frame([0.0, 0.0, -9.81], &grains, &ALL);
    let names: Vec<_> = frame.point_fields.iter().map(|field| field.name.as_str()).collect();
    assert_eq!(names, ALL.map(GrainField::name));
    let field = |name: &str| frame.point_field(name).unwrap().values.as_slice();
    let weight = 9.81 * world.grains.mass[0];
    for lift in [field("contact_force")[2], field("contact_force")[5]] {
        assert!((lift / weight - 1.0).abs() < 1e-6, "all contacts of a grain at rest bear its own weight");
    }
    assert_eq!(field("coordination"), [2.0, 1.0]);
    assert_eq!(field("mass"), world.grains.mass);
    assert_eq!(field("radius"), [RADIUS; 2]);
    assert!(field("contact_torque").iter().all(|torque| torque.abs() < 1e-9 * weight * RADIUS));
}

#[test]
fn a_grain_that_rolls_down_a_slope_is_turned_by_two_sevenths_of_its_weight_along_it() {
    let (along, across) = (1.0, -9.0);
    let (frame, world) = frame([along, 0.0, across], &[Grain::at([0.0, 0.0, RADIUS], RADIUS)], &ALL);
    let field = |name: &str| frame.point_field(name).unwrap().values.as_slice();
    let friction = 2.0 / 7.0 * world.grains.mass[0] * along;
    assert!((field("contact_force")[0] / -friction - 1.0).abs() < 1e-3);
    assert!((field("contact_torque")[1] / (friction * RADIUS) - 1.0).abs() < 1e-3);
    // Rolling: m v²/2 and 2/5 of it, of v = 5/7 g t.
    let speed = field("velocity")[0];
    assert!((speed / (5.0 / 7.0 * along * world.time) - 1.0).abs() < 1e-3);
    assert!((field("kinetic_energy")[0] / (0.7 * world.grains.mass[0] * speed * speed) - 1.0).abs() < 1e-3);
}

#[test]
fn a_frame_holds_the_chosen_fields_alone() {
    let (frame, _) = frame([0.0, 0.0, -9.81], &[], &GrainField::DEFAULT);
    let names: Vec<_> = frame.point_fields.iter().map(|field| field.name.as_str()).collect();
    assert_eq!(names, ["id", "radius", "velocity", "angular_velocity", "material"]);
}
