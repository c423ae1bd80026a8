use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU32, Ordering};

use case_io::document::{Case, Overrides};
use dem_solver::contact::cohesion::CohesionLaw;
use dem_solver::contact::lubrication::Lubrication;
use dem_solver::contact::normal::{Hertz, Onate};
use dem_solver::contact::twisting::TwistingLaw;
use dem_solver::contact::{Extras, NormalLaw};
use dem_solver::wall::Facet;
use dem_solver::{FluidMesh, Setup, SleepBound, Substep, set_up};

const CASE: &str = r#"
[case]
title = "grains in a box"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[time]
end = "1 s"
substep = "10 us"
[materials.glass]
density = "2500 kg/m^3"
youngs-modulus = "10 MPa"
poissons-ratio = 0.3
[pairs.glass-glass]
restitution = 0.9
sliding-friction = 0.3
[grains]
normal-law = "hertz"
domain = { lower = ["0 m", "0 m", "0 m"], upper = ["1 m", "1 m", "2 m"] }
escape = "remove"
periodic = ["x"]
[[insertion]]
name = "two"
material = "glass"
diameter = "2 mm"
velocity = ["1 m/s", "0 m/s", "0 m/s"]
at = [["10 cm", "0.5 m", "0.5 m"], ["20 cm", "0.5 m", "0.5 m"]]
[[insertion]]
name = "bed"
material = "glass"
diameter = "10 mm"
frozen = true
lattice = { lower = ["0.3 m", "0.3 m", "0.3 m"], upper = ["0.34 m", "0.34 m", "0.34 m"], spacing = "1 cm" }
[[insertion]]
name = "read"
material = "glass"
file = { path = "grains.csv" }
[[insertion]]
name = "fed"
material = "glass"
diameter-range = ["1 mm", "2 mm"]
rate = { lower = ["0.5 m", "0.5 m", "1.5 m"], upper = ["0.6 m", "0.6 m", "1.6 m"], number-rate = "100 1/s" }
[[wall]]
name = "floor"
material = "glass"
plane = { point = ["0 m", "0 m", "0 m"], normal = [0, 0, 2] }
"#;

struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("dem-solver-{name}-{}-{count}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        fs::write(path.join("grains.csv"), "x[m],y[m],z[m],vx[m/s],diameter[m]\n0.9,0.9,0.9,0.5,4e-3\n")
            .unwrap();
        Self(path)
    }

    fn set_up(&self, text: &str, mesh: Option<&FluidMesh<3>>) -> Result<Setup<3>, String> {
        fs::write(self.0.join("case.toml"), text).unwrap();
        let case = Case::load(&self.0, &Overrides::default()).map_err(|error| error.to_string())?.remove(0);
        set_up(&case, mesh).map_err(|error| error.to_string())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        drop(fs::remove_dir_all(&self.0));
    }
}

#[test]
fn a_case_becomes_a_scene_and_a_world() {
    let Setup { scene, world, substep } = Folder::new("whole").set_up(CASE, None).unwrap();
    assert_eq!((world.grains.len(), world.feeds.len(), substep), (2 + 64 + 1, 1, Substep::Given(1e-5)));
    assert_eq!(world.grains.motion[0].velocity.x, 1.0);
    assert!(world.grains.motion[2].is_frozen() && !world.grains.motion[66].is_frozen());
    assert_eq!((world.grains.place[66].radius, world.grains.motion[66].velocity.x), (2e-3, 0.5));
    assert!((world.grains.mass[0] - 2500.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-9).abs() < 1e-20);
    assert_eq!((scene.domain.periodic, scene.gravity.z, scene.walls.len()), ([true, false, false], -9.81, 1));
}

#[test]
fn the_laws_and_micro_grains_are_those_of_the_case() {
    let folder = Folder::new("laws");
    let with = |changes: &[(&str, &str)]| {
        let text = changes.iter().fold(CASE.to_string(), |text, (from, to)| text.replace(from, to));
        folder.set_up(&text, None).unwrap()
    };
    let law = "normal-law = \"hertz\"";
    let slips = with(&[(law, "normal-law = \"hertz\"\ntangential-law = \"partial-slip\"")]);
    assert_eq!(slips.scene.normal_law, NormalLaw::HertzPartialSlip(Hertz { depth: 1.0 }));
    let linear = with(&[(law, "normal-law = \"onate\"\narea-factor = 0.9"), ("10 MPa", "0.1 MPa")]);
    assert_eq!(linear.scene.normal_law, NormalLaw::Onate(Onate { area_factor: 0.9, depth: 1.0 }));
    let smooth = ("sliding-friction = 0.3", "sliding-friction = 0");
    let micro = with(&[("poissons-ratio = 0.3", "poissons-ratio = 0.3\nmicro = true"), smooth]);
    assert!(micro.scene.materials.is_micro(0));
    assert!(micro.world.grains.motion.iter().all(|motion| motion.inverse_inertia == 0.0));
}

#[test]
fn what_cannot_be_is_refused_with_its_key() {
    let folder = Folder::new("refused");
    let refusal = |from: &str, to: &str| folder.set_up(&CASE.replace(from, to), None).unwrap_err();
    let twice = refusal("\"20 cm\", \"0.5 m\"", "\"10 cm\", \"0.5 m\"");
    assert!(
        twice.contains("insertion[0]: grains 0 and 1 both have their centre at (0.1, 0.5, 0.5) m"),
        "{twice}"
    );
    let outside = refusal("\"20 cm\", \"0.5 m\"", "\"20 cm\", \"5 m\"");
    assert!(
        outside
            .contains("insertion[0]: the centre of grain 1 is at (0.2, 5, 0.5) m; allowed: from (0, 0, 0) m"),
        "{outside}"
    );
    let many = refusal("spacing = \"1 cm\"", "spacing = \"1 um\"");
    assert!(many.contains("insertion[1].lattice.spacing: about 6.4e13 grains"), "{many}");
    let mesh = refusal(
        "plane = { point = [\"0 m\", \"0 m\", \"0 m\"], normal = [0, 0, 2] }",
        "mesh = { boundary = [\"z-min\"] }",
    );
    assert!(mesh.contains("wall[0].mesh"), "{mesh}");
}

#[test]
fn the_laws_beside_normal_and_tangential_force_come_with_their_numbers() {
    let folder = Folder::new("laws");
    let set_up = |laws: &str, said: &str| {
        let text = CASE
            .replace("normal-law = \"hertz\"", &format!("normal-law = \"hertz\"\n{laws}"))
            .replace("sliding-friction = 0.3", &format!("sliding-friction = 0.3\n{said}"));
        folder.set_up(&text, None).unwrap().scene
    };
    let film = r#"lubrication = { viscosity = "1 mPa s", roughness = "1 um", cut-off = "0.1 mm" }"#;
    let wet = set_up(
        &format!("twisting-law = \"marshall\"\ncohesion-law = \"capillary\"\n{film}"),
        "surface-tension = \"72 mN/m\"\ncontact-angle = \"30 deg\"\nbridge-volume-ratio = 0.01",
    );
    let Extras { rolling: None, twisting, lubrication, cohesion } = wet.extras else { panic!("no rolling") };
    assert_eq!((twisting, cohesion), (Some(TwistingLaw::Marshall), Some(CohesionLaw::Capillary)));
    assert_eq!(lubrication, Some(Lubrication { viscosity: 1e-3, roughness: 1e-6, cut_off: 1e-4 }));
    let pair = wet.materials.pair(0, 0);
    assert_eq!((pair.surface_tension, pair.bridge_volume_ratio), (0.072, 0.01));
    assert!((pair.contact_angle - std::f64::consts::FRAC_PI_6).abs() < 1e-15);
    for (law, key) in [(CohesionLaw::Jkr, "jkr"), (CohesionLaw::Dmt, "dmt")] {
        let scene = set_up(&format!("cohesion-law = \"{key}\""), "work-of-adhesion = \"50 mJ/m^2\"");
        assert_eq!((scene.extras.cohesion, scene.materials.pair(0, 0).work_of_adhesion), (Some(law), 0.05));
    }
}

#[test]
fn boundary_faces_of_the_fluid_mesh_become_walls_and_the_mesh_bounds_the_domain() {
    let text = CASE
        .replace("substep = \"10 us\"", "window = \"1 ms\"")
        .replace(
            "plane = { point = [\"0 m\", \"0 m\", \"0 m\"], normal = [0, 0, 2] }",
            "mesh = { boundary = [\"z-min\"] }",
        )
        .replace("domain = { lower = [\"0 m\", \"0 m\", \"0 m\"], upper = [\"1 m\", \"1 m\", \"2 m\"] }", "")
        .replace("periodic = [\"x\"]", "")
        .replace("[[insertion]]\nname = \"two\"", FLUID);
    let faces = vec![Facet::new([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])];
    let mesh = FluidMesh {
        bounds: ([0.0; 3], [1.0, 1.0, 3.0]),
        boundaries: BTreeMap::from([("z-min".to_string(), faces)]),
    };
    let folder = Folder::new("mesh");
    let setup = folder.set_up(&text, Some(&mesh)).unwrap();
    assert_eq!((setup.scene.walls.surfaces.len(), setup.scene.domain.upper.z), (1, 3.0));
    let missing = FluidMesh { boundaries: BTreeMap::new(), ..mesh };
    let error = folder.set_up(&text, Some(&missing)).unwrap_err();
    assert!(error.contains("wall[0].mesh.boundary: the fluid mesh has no boundary \"z-min\""), "{error}");
}

#[test]
fn every_shape_of_wall_motion_region_and_size_is_set_up() {
    let text = CASE.replace("[[wall]]\nname = \"floor\"", SHAPES);
    let folder = Folder::new("shapes");
    fs::write(folder.0.join("curve.csv"), "diameter[m],passing[-]\n1e-3,0\n2e-3,1\n").unwrap();
    fs::write(folder.0.join("turn.csv"), "t[s],angle[rad]\n0,0\n1,3\n").unwrap();
    let tile = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    fs::write(folder.0.join("tile.obj"), tile).unwrap();
    let Setup { scene, world, .. } = folder.set_up(&text, None).unwrap();
    let walls = &scene.walls;
    assert_eq!(walls.names, ["drum", "ball", "can", "tile", "floor"]);
    // A can is a shell and two discs, the tile two triangles.
    assert_eq!(walls.surfaces.len(), 1 + 1 + 3 + 2 + 1);
    // The drum turns by its table about its axis; the can sinks by its own.
    let poses = walls.poses(0.5, &[]);
    let drum = poses.of(0).unwrap().moved(&[0.7, 0.0, 0.5].into());
    assert!(
        (drum - dem_solver::Vector::from([0.5 + 0.2 * 1.5_f64.cos(), 0.0, 0.5 - 0.2 * 1.5_f64.sin()])).norm()
            < 1e-12
    );
    let can = poses.of(2).unwrap();
    assert!((can.moved(&[0.0; 3].into()).z + 0.05).abs() < 1e-15);
    assert!((can.velocity_at(&[0.0; 3].into()).z + 0.1).abs() < 1e-15);
    let mixed: Vec<f64> = world.grains.place[67..97].iter().map(|place| place.radius).collect();
    assert!(mixed.contains(&2e-3) && mixed.contains(&3e-3) && mixed.iter().all(|r| [2e-3, 3e-3].contains(r)));
    let sieved = &world.grains.place[97..];
    assert!(sieved.len() > 10 && sieved.iter().all(|place| (5e-4..=1e-3).contains(&place.radius)));
    assert_eq!(scene.deletions.len(), 2);
}

/// A box from 0 to 10 with every face of two triangles that face outwards, as an STL file; `without` so many of the last.
fn stl_box(without: usize) -> String {
    let mut text = String::from("solid box\n");
    for k in 0..12 - without {
        let (axis, side, half) = (k / 4, k / 2 % 2, k % 2);
        let corner = |u: usize, v: usize| {
            let mut at = [0; 3];
            (at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]) = (10 * side, 10 * u, 10 * v);
            format!("vertex {} {} {}\n", at[0], at[1], at[2])
        };
        let mut corners = [
            corner(0, 0),
            if half == 0 { corner(1, 0) } else { corner(1, 1) },
            if half == 0 { corner(1, 1) } else { corner(0, 1) },
        ];
        if side == 0 {
            corners.swap(1, 2);
        }
        text += &format!("facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n", corners.concat());
    }
    text + "endsolid box\n"
}

#[test]
fn grains_fill_the_inside_of_a_closed_surface_and_only_of_that() {
    let folder = Folder::new("inside");
    fs::write(folder.0.join("box.stl"), stl_box(0)).unwrap();
    let at = "at = [[\"10 cm\", \"0.5 m\", \"0.5 m\"], [\"20 cm\", \"0.5 m\", \"0.5 m\"]]";
    let fill = |scale: f64| {
        CASE.replace(
            at,
            &format!("random-stl = {{ path = \"box.stl\", scale = {scale}, solid-fraction = 0.2 }}"),
        )
    };
    let Setup { world, .. } = folder.set_up(&fill(0.002), None).unwrap();
    // A fifth of (20 mm)³ in spheres of 2 mm.
    let of_two = world.grains.place.iter().filter(|place| place.radius == 1e-3);
    let centres: Vec<_> = of_two.map(|place| place.centre).collect();
    assert_eq!(centres.len(), 382);
    assert!(centres.iter().all(|c| c.iter().all(|x| (1e-3..=19e-3).contains(x))));
    let narrow = fill(0.0001).replace("solid-fraction = 0.2", "count = 1");
    let narrow = folder.set_up(&narrow, None).unwrap_err();
    assert!(narrow.contains("insertion[0].random-stl: 0 of 1 grains fitted: the next, of diameter 0.0020 m, is wider than the region"), "{narrow}");
    let rate = "rate = { stl = { path = \"box.stl\", scale = 0.01 }, number-rate = \"100 1/s\" }";
    let fed = CASE.replace(at, rate)
        + "\n[[deletion]]\nname = \"out\"\nstl = { path = \"box.stl\", scale = 0.01 }\n";
    let Setup { scene, world, .. } = folder.set_up(&fed, None).unwrap();
    assert_eq!((scene.deletions.len(), world.feeds.len()), (1, 2));
    let [inside, outside] = [0.05, 0.15].map(|x| scene.deletions[0].takes(&[x, 0.05, 0.05].into()));
    assert!(inside && !outside);
    fs::write(folder.0.join("box.stl"), stl_box(1)).unwrap();
    let holed = folder.set_up(&fill(0.002), None).unwrap_err();
    assert!(
        holed.contains("insertion[0].random-stl.path")
            && holed.contains("has 1 holes (the smallest of 3 edges, near (")
            && holed.contains("only a closed surface has an inside"),
        "{holed}"
    );
}

/// Walls, insertions and deletions, and the first lines of the wall they stand before.
const SHAPES: &str = r#"
[[insertion]]
name = "mixture"
material = "glass"
diameter-distribution = { mixture = [{ diameter = "4 mm", mass-fraction = 0.4 }, { diameter = "6 mm", mass-fraction = 0.6 }] }
random-sphere = { centre = ["0.5 m", "0.5 m", "1 m"], radius = "5 cm", count = 30 }
[[insertion]]
name = "sieved"
material = "glass"
diameter-distribution = { sieve = { path = "curve.csv" } }
random-cylinder = { from = ["0.5 m", "0.5 m", "1.2 m"], to = ["0.5 m", "0.5 m", "1.22 m"], radius = "1 cm", solid-fraction = 0.1 }
[[insertion]]
name = "spray"
material = "glass"
diameter-distribution = { lognormal = { median = "1 mm", deviation = 0.3, smallest = "0.5 mm", largest = "2 mm" } }
rate = { sphere = { centre = ["0.5 m", "0.5 m", "1.8 m"], radius = "5 cm" }, mass-rate = "1 g/s" }
[[deletion]]
name = "out"
box = { lower = ["0 m", "0 m", "0 m"], upper = ["0.01 m", "0.01 m", "0.01 m"] }
[[deletion]]
name = "below"
beyond = { point = ["0 m", "0 m", "-0.1 m"], normal = [0, 0, 1] }
[[wall]]
name = "drum"
material = "glass"
cylinder = { point = ["0.5 m", "0 m", "0.5 m"], axis = [0, 1, 0], radius = "10 m", grains = "inside" }
motion = { table = { path = "turn.csv", axis = [0, 1, 0], point = ["0.5 m", "0 m", "0.5 m"] } }
[[wall]]
name = "ball"
material = "glass"
sphere = { centre = ["0.8 m", "0.1 m", "0.1 m"], radius = "5 cm", grains = "outside" }
[[wall]]
name = "can"
material = "glass"
cylinder = { point = ["0.8 m", "0.8 m", "0.1 m"], axis = [0, 0, 3], radius = "5 cm", length = "10 cm", closed = true }
motion = { table = { time = ["0 s", "1 s"], place = [["7 m", "0 m", "0 m"], ["7 m", "0 m", "-10 cm"]] } }
[[wall]]
name = "tile"
material = "glass"
obj = { path = "tile.obj", scale = 0.01, rims = 1 }
[[wall]]
name = "floor""#;

/// A fluid side, and the first lines of the insertion it stands before.
const FLUID: &str = r#"
[fluid]
backend = "eulerian"
density = "1000 kg/m^3"
viscosity = "1 mPa s"
[fluid.mesh]
box = { lower = ["0 m", "0 m", "0 m"], upper = ["1 m", "1 m", "3 m"], cells = [2, 2, 2] }
[[fluid.boundary]]
on = ["x-min", "x-max", "y-min", "y-max", "z-min", "z-max"]
kind = "no-slip"
[coupling]
scheme = "serial-explicit"
drag = "stokes"
[[insertion]]
name = "two""#;

/// Clumps by a random box, at a place and by a rate, and the first lines of the insertion they stand before.
const CLUMPS: &str = r#"
[[clump]]
name = "pair"
spheres = [{ centre = ["0 mm", "0 mm", "0 mm"], radius = "2 mm" }, { centre = ["3 mm", "0 mm", "0 mm"], radius = "1 mm" }]
[[insertion]]
name = "tossed"
material = "glass"
clump = "pair"
random-orientation = true
spin = { axis = [0, 2, 0], rate = "3 rad/s" }
random-box = { lower = ["0.5 m", "0.5 m", "1 m"], upper = ["0.55 m", "0.55 m", "1.05 m"], count = 20 }
[[insertion]]
name = "upright"
material = "glass"
clump = "pair"
orientation = { axis = [0, -1, 0], angle = "90 deg" }
at = [["0.6 m", "0.6 m", "1 m"]]
[[insertion]]
name = "rain"
material = "glass"
clump = "pair"
rate = { lower = ["0.5 m", "0.5 m", "1.5 m"], upper = ["0.6 m", "0.6 m", "1.6 m"], number-rate = "100 1/s" }
[[insertion]]
name = "two""#;

#[test]
fn clumps_are_set_up_with_the_mass_of_the_union_or_their_own() {
    let text = CASE.replace("[[insertion]]\nname = \"two\"", CLUMPS);
    let folder = Folder::new("clumps");
    let Setup { scene, world, .. } = folder.set_up(&text, None).unwrap();
    let clumps = world.bodies.as_slice();
    assert_eq!((clumps.len(), scene.clumps.len(), clumps[20].kind), (21, 3, 1));
    let apart = std::f64::consts::PI * 4.0 / 3.0 * (8e-9 + 1e-9);
    let mass = scene.clumps[0].shape.mass();
    assert!((mass / 2500.0 / apart - 1.0).abs() < 1e-12, "the spheres touch: {mass}");
    let upright = &world.grains.place[40..42];
    assert!((upright[1].centre - upright[0].centre - dem_solver::Spin::new(0.0, 0.0, 3e-3)).norm() < 1e-15);
    let centre = (upright[0].centre * 8.0 + upright[1].centre) / 9.0;
    assert!((centre - dem_solver::Spin::new(0.6, 0.6, 1.0)).norm() < 1e-12);
    let spin = clumps[3].body.angular_velocity(&clumps[3].shape);
    assert!((spin - dem_solver::Spin::new(0.0, 3.0, 0.0)).norm() < 1e-12);
    let heavy =
        folder.set_up(&text.replace("name = \"pair\"", "name = \"pair\"\nmass = \"1 g\""), None).unwrap();
    assert!((heavy.scene.clumps[0].shape.mass() - 1e-3).abs() < 1e-15);
    let narrow = text.replace("\"1 m\", \"1 m\", \"2 m\"", "\"6 mm\", \"1 m\", \"2 m\"");
    let error = folder.set_up(&narrow, None).unwrap_err();
    assert!(
        error.contains("grains.periodic: the domain is 0.006 m long in x; allowed: more than"),
        "{error}"
    );
}

#[test]
fn grains_sleep_where_the_case_says_so_by_its_gravity_and_smallest_grain_or_as_stated() {
    let folder = Folder::new("sleep");
    let bound = |said: &str| {
        let text = CASE.replace("escape = \"remove\"", &format!("escape = \"remove\"\n{said}"));
        folder.set_up(&text, None).unwrap().scene.sleep
    };
    assert_eq!(bound(""), None);
    // The smallest are fed, of 1 mm.
    let speed = 1e-4 * (9.81_f64 * 1e-3).sqrt();
    let default = bound("sleep = {}").unwrap();
    assert!((default.speed / speed - 1.0).abs() < 1e-12);
    assert!((default.acceleration / 9.81e-3 - 1.0).abs() < 1e-12);
    let stated = bound("sleep = { speed = \"20 um/s\", acceleration = \"0.05 m/s^2\" }");
    assert_eq!(stated, Some(SleepBound { speed: 2e-5, acceleration: 0.05 }));
}
