//! The seams between triangles: what a sphere must not feel of them. `--nocapture` shows the figures.
#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::scenes::{floor, glass, hertz, run, world};
use dem_solver::wall::{Facet, Wall, Walls};
use dem_solver::{Grain, Scene, Spin, Vector};

/// Place, velocity and spin at one time.
type Instant = (Vector<3>, Vector<3>, Spin);

const RADIUS: f64 = 1e-2;

/// A flat floor of triangles: vertices on a skewed lattice of this size, so that seams lie at any angle to the way, and
/// off the plane by this `noise`.
fn triangulated(size: f64, noise: f64) -> Walls<3> {
    let vertex = |i: i32, j: i32| {
        let (i, j) = (f64::from(i), f64::from(j));
        [
            size * (i + 0.3 * (1.7 * j).sin()),
            size * (j + 0.2 * (2.3 * i).cos()),
            noise * (3.1 * i + 5.3 * j).sin(),
        ]
    };
    let n = (0.12 / size) as i32 + 2;
    let tile = |i: i32, j: i32| {
        let (a, b, c, d) = (vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
        [Facet::new([a, b, c]), Facet::new([a, c, d])]
    };
    let tiles = (-n..n).flat_map(|i| (-n..n).flat_map(move |j| tile(i, j)));
    Walls::new(vec![Wall::facets("floor", 0, tiles.collect())])
}

/// Places, velocities and spins every millisecond.
fn way(walls: Walls<3>, grain: Grain<3>, milliseconds: u32) -> Vec<Instant> {
    let scene = Scene::<3>::new(glass(0.6, 0.5), hertz()).with_gravity([0.0, 0.0, -9.81]).with_walls(walls);
    let mut world = world(&scene, &[grain]);
    let step = |_| {
        run(&scene, &mut world, 1e-3, 100).unwrap();
        let (place, motion) = (&world.grains.place[0], &world.grains.motion[0]);
        (place.centre, motion.velocity, motion.angular_velocity)
    };
    (0..milliseconds).map(step).collect()
}

#[test]
fn a_sphere_rebounds_from_face_edge_and_vertex_as_from_a_plane() {
    // Targets of a floor of two large triangles and more around them: inside a face, on an edge, on a vertex.
    let square = |a: [f64; 2], b: [f64; 2]| {
        let [p, q, r, s] = [[a[0], a[1], 0.0], [b[0], a[1], 0.0], [b[0], b[1], 0.0], [a[0], b[1], 0.0]];
        [Facet::new([p, q, r]), Facet::new([p, r, s])]
    };
    let cuts = [-0.3, 0.0, 0.3];
    let tiles = (0..2).flat_map(|i| (0..2).map(move |j| (i, j)));
    let facets: Vec<_> =
        tiles.flat_map(|(i, j)| square([cuts[i], cuts[j]], [cuts[i + 1], cuts[j + 1]])).collect();
    let end = |walls: Walls<3>, x: f64, y: f64| {
        let velocity = [0.3, 0.1, -0.8];
        let start = [x - 0.02 * 0.3 / 0.8, y - 0.02 * 0.1 / 0.8, RADIUS + 0.02];
        let scene = Scene::<3>::new(glass(0.6, 0.3), hertz()).with_walls(walls);
        let mut world = world(&scene, &[Grain::at(start, RADIUS).moving(velocity)]);
        run(&scene, &mut world, 0.04, 16_000).unwrap();
        (world.grains.motion[0].velocity, world.grains.motion[0].angular_velocity)
    };
    for (target, [x, y]) in
        [("face", [0.2, 0.1]), ("edge", [0.0, 0.15]), ("diagonal edge", [0.15, 0.15]), ("vertex", [0.0, 0.0])]
    {
        let plane = end(floor(), x, y);
        let mesh = end(Walls::new(vec![Wall::facets("floor", 0, facets.clone())]), x, y);
        let (velocity, spin) = ((mesh.0 - plane.0).norm(), (mesh.1 - plane.1).norm() * RADIUS);
        println!("{target}: rebound off by {velocity:.1e} m/s, spin by {spin:.1e} m/s of 0.86 m/s");
        assert!(velocity < 1e-6 * 0.86 && spin < 1e-6 * 0.86, "{target}: {velocity} m/s, {spin} m/s");
    }
}

#[test]
fn rolling_over_seams_neither_lifts_nor_slows_nor_spins() {
    // Pressed in by its weight: nothing moves up or down but for the seams.
    let modulus = 1e7 / (2.0 * (1.0 - 0.09));
    let weight = 2500.0 * 4.0 / 3.0 * std::f64::consts::PI * RADIUS.powi(3) * 9.81;
    let overlap = (0.75 * weight / (modulus * RADIUS.sqrt())).powf(2.0 / 3.0);
    let speed = Vector::from([0.4, 0.13, 0.0]);
    let grain = Grain::at([-0.06, -0.02, RADIUS - overlap], RADIUS).moving(speed.into()).spinning([
        -0.13 / RADIUS,
        0.4 / RADIUS,
        0.0,
    ]);
    let plane = way(floor(), grain, 250);
    // Exact vertices, and such that single precision has rounded a few centimetres from the origin.
    for (size, noise, disturbance) in
        [(3e-2, 0.0, 1e-12), (4e-3, 0.0, 1e-12), (1e-3, 0.0, 1e-12), (4e-3, 3e-9, 1e-5), (1e-3, 3e-9, 1e-5)]
    {
        let mesh = way(triangulated(size, noise), grain, 250);
        let largest = |of: fn(&Instant, &Instant) -> f64| {
            mesh.iter().zip(&plane).map(|(a, b)| of(a, b)).fold(0.0, f64::max)
        };
        let height = largest(|a, b| (a.0.z - b.0.z).abs());
        let velocity = largest(|a, b| (a.1 - b.1).norm());
        let spin = largest(|a, b| (a.2 - b.2).norm() * RADIUS);
        println!(
            "triangles of {size} m, off by {noise} m: height noise {height:.1e} m, velocity {velocity:.1e} m/s, spin {spin:.1e} m/s of {:.2} m/s",
            speed.norm()
        );
        assert!(height < 1e-8 && velocity.max(spin) < disturbance * speed.norm());
    }
}
