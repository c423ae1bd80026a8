use fluid_solver::mesh::generate::{BentPipe, BoxMesh, Jitter};
use fluid_solver::mesh::locate::{Location, Locator};
use fluid_solver::mesh::{Mesh, gmsh};
use std::path::Path;

fn random(count: usize, lower: f64, upper: f64) -> Vec<[f64; 3]> {
    let mut state = 88_172_645_463_325_252_u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        lower + (upper - lower) * (state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..count).map(|_| [next(), next(), next()]).collect()
}

fn cube(periodic: [bool; 3], jitter: Option<Jitter>) -> Mesh<3, 4> {
    BoxMesh { lower: [0.0; 3], upper: [1.0; 3], cells: [5; 3], periodic, jitter }.generate().unwrap()
}

fn elbow() -> Mesh<3, 4> {
    let angle = std::f64::consts::PI;
    BentPipe { radius: 0.2, rings: 2, bend_radius: 0.3, angle, legs: [0.7; 2], layers: [4, 8, 4] }
        .generate()
        .unwrap()
}

#[test]
fn the_coordinates_found_reproduce_the_point() {
    let mesh = cube([false; 3], Some(Jitter { fraction: 0.4, seed: 1 }));
    let locator = Locator::new(&mesh);
    for x in random(500, 0.0, 1.0) {
        let Location::Inside { cell, coordinates } = locator.locate(&mesh, &x, None) else { panic!("{x:?}") };
        assert!(coordinates.iter().all(|&c| c >= -1e-12));
        let vertices = mesh.vertices(cell as usize);
        for k in 0..3 {
            let found: f64 = (0..4).map(|i| coordinates[i] * vertices[i][k]).sum();
            assert!((found - x[k]).abs() < 1e-14);
        }
    }
}

/// Points on corners, edges, faces, inside and outside; any remembered cell, even none or a wrong one.
#[test]
fn the_answer_does_not_depend_on_the_remembered_cell() {
    let lattice = (0..216).map(|i| [i % 6, i / 6 % 6, i / 36].map(|k| k as f64 / 5.0));
    let edges =
        (0..216).map(|i| [0.1 + (i % 6) as f64 / 5.0, (i / 6 % 6) as f64 / 5.0, 0.1 + (i / 36) as f64 / 5.0]);
    let points: Vec<[f64; 3]> = lattice.chain(edges).chain(random(200, -0.3, 1.3)).collect();
    for mesh in [cube([false; 3], None), cube([true; 3], None), elbow()] {
        let locator = Locator::new(&mesh);
        let cells = mesh.cells().len() as u32;
        for x in &points {
            let expected = locator.locate(&mesh, x, None);
            for remembered in (0..cells).step_by(41).chain([cells, u32::MAX]) {
                assert_eq!(locator.locate(&mesh, x, Some(remembered)), expected, "{x:?} from {remembered}");
            }
        }
    }
}

#[test]
fn a_point_on_a_shared_corner_belongs_to_the_lowest_of_its_cells() {
    let mesh = cube([false; 3], None);
    let locator = Locator::new(&mesh);
    for (node, x) in mesh.nodes().iter().enumerate() {
        let lowest = mesh.cells().iter().position(|cell| cell.contains(&(node as u32))).unwrap();
        assert!(
            matches!(locator.locate(&mesh, x, None), Location::Inside { cell, .. } if cell == lowest as u32)
        );
    }
}

#[test]
fn a_point_outside_gets_the_nearest_boundary_face() {
    for mesh in [cube([false; 3], None), elbow()] {
        let locator = Locator::new(&mesh);
        let distance = |face: usize, x: &[f64; 3]| {
            let vertices = mesh.face_vertices(&mesh.boundary()[face]);
            let closest = fluid_solver::element::closest_point::on_facet(&vertices, x);
            (0..3).map(|k| (closest[k] - x[k]).powi(2)).sum::<f64>().sqrt()
        };
        let mut outside = 0;
        for x in random(300, -3.0, 4.0) {
            let Location::Outside { nearest_face } = locator.locate(&mesh, &x, None) else { continue };
            let best =
                (0..mesh.boundary().len()).map(|face| distance(face, &x)).fold(f64::INFINITY, f64::min);
            assert_eq!(distance(nearest_face.unwrap() as usize, &x), best, "{x:?}");
            outside += 1;
        }
        assert!(outside > 200);
    }
}

#[test]
fn on_periodic_axes_every_image_of_a_point_has_the_same_host() {
    let mesh = cube([true; 3], None);
    let locator = Locator::new(&mesh);
    let x = [0.28125, 0.53125, 0.84375];
    let expected = locator.locate(&mesh, &x, None);
    assert!(matches!(expected, Location::Inside { .. }));
    for image in [[1.0, 0.0, 0.0], [-3.0, 2.0, 0.0], [0.0, -1.0, 64.0]] {
        assert_eq!(locator.locate(&mesh, &std::array::from_fn(|k| x[k] + image[k]), None), expected);
    }
}

#[test]
fn a_point_that_is_not_finite_is_nowhere_and_one_far_away_is_outside() {
    let mesh = cube([true, false, false], None);
    let locator = Locator::new(&mesh);
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(locator.locate(&mesh, &[bad, 0.5, 0.5], Some(3)), Location::NotFinite);
    }
    let far = locator.locate(&mesh, &[1e300, -1e300, 0.5], None);
    assert!(matches!(far, Location::Outside { nearest_face: Some(_) }));
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/meshes/plate-4-text.msh");
    let plate = gmsh::read::<2, 3>(&file).unwrap();
    let in_the_hole = Locator::new(&plate).locate(&plate, &[0.7, 0.5], Some(0));
    let Location::Outside { nearest_face: Some(face) } = in_the_hole else { panic!() };
    assert_eq!(plate.groups()[plate.boundary()[face as usize].group as usize], "obstacle");
}
