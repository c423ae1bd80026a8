use crate::scene::{Scene, sphere, unit_box};
use fluid_solver::mesh::Mesh;
use fluid_solver::mesh::generate::{BoxMesh, Pipe};
use fluid_solver::void_fraction::Grain;
use std::f64::consts::PI;

/// Grains of diameter one on a simple cubic lattice of spacing one in a periodic box of 20, aligned or turned about z by
/// atan(3/4), with which it is periodic in 5.
fn lattice(turned: bool) -> Vec<Grain<3>> {
    let (cosine, sine) = if turned { (0.8, 0.6) } else { (1.0, 0.0) };
    let mut grains = Vec::new();
    for i in -40..40 {
        for j in -40..40 {
            let (u, v) = (f64::from(i) + 0.123, f64::from(j) + 0.377);
            let (x, y) = (cosine * u - sine * v, sine * u + cosine * v);
            if (0.0..20.0).contains(&x) && (0.0..20.0).contains(&y) {
                grains
                    .extend((0..20).map(|k| Grain { position: [x, y, f64::from(k) + 0.21], diameter: 1.0 }));
            }
        }
    }
    grains
}

#[test]
fn a_lattice_of_grains_has_a_uniform_void_fraction_at_any_mesh_size() {
    for turned in [false, true] {
        let grains = lattice(turned);
        assert_eq!(grains.len(), 8000);
        // h/d = 4, 2.86, 2, 1.54, 1, 0.69
        for cells in [5, 7, 10, 13, 20, 29] {
            let (lower, upper) = ([0.0; 3], [20.0; 3]);
            let mesh: Mesh<3, 4> =
                BoxMesh { lower, upper, cells: [cells; 3], periodic: [true; 3], jitter: None }
                    .generate()
                    .unwrap();
            let void = Scene::new(mesh, 1.0, 1.0).void_fraction(&grains, &[sphere(1.0); 8000], 0.0).unwrap();
            let worst = void.iter().map(|void| (void - (1.0 - PI / 6.0)).abs()).fold(0.0, f64::max);
            let allowed = if cells == 29 { 8e-4 } else { 5e-4 };
            assert!(worst < allowed, "turned {turned}, {cells} cells: {worst}");
        }
    }
}

/// Solid fraction of a bed over its mean, extreme over the nodes that `take`: a fine lattice of small grains.
fn extremes(mesh: Mesh<3, 4>, diameter: f64, spacing: f64, take: impl Fn(&[f64; 3]) -> bool) -> (f64, f64) {
    let steps = |k: usize| ((mesh.bounds().1[k] - mesh.bounds().0[k]) / spacing).round() as usize;
    let mut grains = Vec::new();
    for i in 0..steps(0) * steps(1) * steps(2) {
        let index = [i % steps(0), i / steps(0) % steps(1), i / (steps(0) * steps(1))];
        let position = std::array::from_fn(|k| mesh.bounds().0[k] + (index[k] as f64 + 0.5) * spacing);
        grains.push(Grain { position, diameter });
    }
    let volumes = vec![0.3 * spacing.powi(3); grains.len()];
    let mut scene = Scene::new(mesh, diameter, diameter);
    let void = scene.void_fraction(&grains, &volumes, 0.0).unwrap();
    let taken =
        scene.mesh.nodes().iter().zip(&void).filter(|(x, _)| take(x)).map(|(_, void)| (1.0 - void) / 0.3);
    taken.fold((f64::INFINITY, 0.0), |(low, high), phi| (phi.min(low), phi.max(high)))
}

fn assert_within((low, high): (f64, f64), deviation: f64) {
    assert!(low > 1.0 - deviation && high < 1.0 + deviation, "{low} to {high}");
}

fn sides(x: &[f64; 3]) -> usize {
    x.iter().filter(|&&c| c == 0.0 || c == 1.0).count()
}

#[test]
fn a_uniform_bed_keeps_its_solid_fraction_up_to_walls_edges_and_corners() {
    for diameter in [0.01, 0.15] {
        let extremes =
            |take: fn(&[f64; 3]) -> bool| extremes(unit_box(10, false, 0.0), diameter, 0.025, take);
        assert_within(extremes(|x| sides(x) <= 1), 0.01);
        assert_within(extremes(|x| sides(x) == 2), 0.02);
        assert_within(extremes(|x| sides(x) == 3), 0.04);
    }
    assert_within(extremes(unit_box(10, false, 0.3), 0.01, 0.025, |_| true), 0.04);
}

#[test]
fn a_uniform_bed_keeps_its_solid_fraction_up_to_a_round_wall() {
    let pipe = Pipe { radius: 0.5, length: 1.0, rings: 6, layers: 12 }.generate().unwrap();
    assert_within(extremes(pipe, 0.01, 0.02, |_| true), 0.06);
}

#[test]
fn the_spread_of_the_weights_per_direction_is_the_kernel_width() {
    let mut scene = Scene::<2, 3>::new(unit_box(40, false, 0.0), 0.06, 0.06);
    scene.weigh(&[Grain { position: [0.503, 0.491], diameter: 0.06 }]).unwrap();
    assert_eq!(scene.weights.width(0), 0.06);
    let (nodes, values) = scene.weights.row(0);
    for k in 0..2 {
        let moment = |power: i32, about: f64| -> f64 {
            let terms = nodes.iter().zip(values);
            terms.map(|(&node, w)| w * (scene.mesh.nodes()[node as usize][k] - about).powi(power)).sum()
        };
        let deviation = moment(2, moment(1, 0.0)).sqrt();
        assert!((deviation / 0.06 - 1.0).abs() < 2e-3, "{deviation}");
    }
}
