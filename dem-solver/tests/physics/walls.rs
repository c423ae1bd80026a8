use crate::scenes::{floor, glass, hertz, run, world};
use dem_solver::engine::Periods;
use dem_solver::wall::{Facet, Wall, Walls};
use dem_solver::{Domain, Grain, Scene, Spin, Vector};

/// A floor of right triangles of this size, from -n to n.
fn tiled(size: f64, n: i32, origin: [f64; 2]) -> Walls<3> {
    let mut facets = Vec::new();
    for i in -n..n {
        for j in -n..n {
            let at = |di: i32, dj: i32| {
                [origin[0] + size * f64::from(i + di), origin[1] + size * f64::from(j + dj), 0.0]
            };
            facets.push(Facet::new([at(0, 0), at(1, 0), at(1, 1)]));
            facets.push(Facet::new([at(0, 0), at(1, 1), at(0, 1)]));
        }
    }
    Walls::new(vec![Wall::facets("floor", 0, facets)])
}

fn end_state(walls: Walls<3>, grain: Grain<3>) -> (Vector<3>, Vector<3>, Spin) {
    let scene = Scene::<3>::new(glass(0.6, 0.4), hertz()).with_gravity([0.0, 0.0, -9.81]).with_walls(walls);
    let mut world = world(&scene, &[grain]);
    run(&scene, &mut world, 0.06, 12_000).unwrap();
    (world.grains.place[0].centre, world.grains.motion[0].velocity, world.grains.motion[0].angular_velocity)
}

#[test]
fn a_sphere_bounces_and_rolls_on_triangles_as_on_a_plane() {
    let throws = [
        Grain::at([0.0, 0.0, 0.99995e-2], 1e-2).moving([0.4, 0.13, 0.0]),
        Grain::at([-1e-2, 3e-3, 1.2e-2], 1e-2).moving([0.5, -0.1, -0.4]).spinning([20.0, -10.0, 5.0]),
    ];
    for grain in throws {
        let (centre, velocity, spin) = end_state(floor(), grain);
        // Triangles much larger and much smaller than the sphere, edges and corners on its way.
        for (size, n, origin) in [(3e-2, 3, [0.0, 0.0]), (2e-3, 30, [0.0, 0.0]), (2.3e-3, 30, [1e-4, 7e-4])] {
            let (c, v, s) = end_state(tiled(size, n, origin), grain);
            assert!((c - centre).norm() < 1e-9, "size {size}: off by {} m", (c - centre).norm());
            assert!(
                (v - velocity).norm() < 1e-7 && (s - spin).norm() < 1e-5,
                "size {size}: {v:?} {velocity:?}"
            );
        }
    }
}

#[test]
fn a_sphere_bounces_off_an_edge_and_off_a_corner_once() {
    // Head on to the edge or the corner of a tent: the contact is that of a plane with the same normal.
    let up = |walls: Walls<3>| {
        let scene = Scene::<3>::new(glass(0.6, 0.0), hertz()).with_walls(walls);
        let mut world = world(&scene, &[Grain::at([0.0, 0.0, 1.01e-2], 1e-2).moving([0.0, 0.0, -0.5])]);
        run(&scene, &mut world, 0.02, 8000).unwrap();
        world.grains.motion[0].velocity
    };
    let plane = up(floor());
    let side = |a: [f64; 3], b: [f64; 3]| Facet::new([[0.0, 0.0, 0.0], a, b]);
    let corner = [[1.0, 0.0, -1.0], [0.0, 1.0, -1.0], [-1.0, 0.0, -1.0], [0.0, -1.0, -1.0]]
        .map(|p| p.map(|x| x * 0.1));
    let pyramid = (0..4).map(|k| side(corner[k], corner[(k + 1) % 4])).collect();
    let edge =
        [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [1.0, 0.0, -1.0], [-1.0, 0.0, -1.0]].map(|p| p.map(|x| x * 0.1));
    let roof = vec![Facet::new([edge[0], edge[1], edge[2]]), Facet::new([edge[0], edge[1], edge[3]])];
    for facets in [pyramid, roof] {
        let velocity = up(Walls::new(vec![Wall::facets("tent", 0, facets)]));
        assert!((velocity - plane).norm() < 1e-12, "{velocity:?} {plane:?}");
    }
}

#[test]
fn a_sphere_in_a_groove_rests_on_both_sides() {
    let slope = |s: f64| Wall::plane("side", 0, [0.0; 3], [s, 0.0, 1.0]);
    let scene = Scene::<3>::new(glass(0.3, 0.0), hertz())
        .with_gravity([0.0, 0.0, -9.81])
        .with_walls(Walls::new(vec![slope(1.0), slope(-1.0)]));
    let mut world = world(&scene, &[Grain::at([1e-4, 0.0, 1.42e-2], 1e-2)]);
    run(&scene, &mut world, 0.6, 60_000).unwrap();
    let ledger = run(&scene, &mut world, 0.01, 1000).unwrap();
    let weight = world.grains.mass[0] * 9.81 * 0.01;
    for impulse in &ledger.wall_impulse {
        assert!((impulse.linear.norm() / (weight / 2.0_f64.sqrt()) - 1.0).abs() < 1e-2, "{impulse:?}");
    }
    assert!((ledger.walls.z / weight - 1.0).abs() < 1e-3);
}

#[test]
fn a_disc_rolls_over_segments_as_on_a_line() {
    let segments =
        (-20..20).map(|k| Facet::new([[2e-3 * f64::from(k), 0.0], [2e-3 * f64::from(k + 1), 0.0]])).collect();
    let end = |walls: Walls<2>| {
        let scene = Scene::<2>::new(glass(0.6, 0.4), hertz()).with_gravity([0.0, -9.81]).with_walls(walls);
        let mut world = world(&scene, &[Grain::at([0.0, 1.02e-2], 1e-2).moving([0.3, 0.0])]);
        run(&scene, &mut world, 0.06, 12_000).unwrap();
        (world.grains.place[0].centre, world.grains.motion[0].angular_velocity.z)
    };
    let (plane, tiled) = (end(floor()), end(Walls::new(vec![Wall::facets("floor", 0, segments)])));
    assert!((plane.0 - tiled.0).norm() < 1e-9 && (plane.1 - tiled.1).abs() < 1e-5, "{plane:?} {tiled:?}");
}

#[test]
fn a_facet_is_felt_across_a_periodic_boundary() {
    let domain = Domain::new([0.0, 0.0, -1.0], [0.1, 0.1, 1.0]).periodic([true, true, false]);
    let corners = [[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.1, 0.1, 0.0], [0.0, 0.1, 0.0]];
    let facets = vec![
        Facet::new([corners[0], corners[1], corners[2]]),
        Facet::new([corners[0], corners[2], corners[3]]),
    ];
    // Once across the boundary, and four times through the domain.
    for speed in [0.4, 4.0] {
        let end = |walls: Walls<3>| {
            let scene = Scene::<3>::new(glass(0.6, 0.4), hertz())
                .with_gravity([0.0, 0.0, -9.81])
                .in_domain(domain)
                .with_walls(walls);
            let grain = Grain::at([0.09, 0.05, 1.02e-2], 1e-2).moving([speed, 0.0, 0.0]);
            let mut world = world(&scene, &[grain]);
            run(&scene, &mut world, 0.1, 20_000).unwrap();
            let mut inside = world.grains.place[0].centre;
            Periods::new(&domain).wrap(&mut inside);
            (inside, world.grains.motion[0].angular_velocity)
        };
        let mesh = end(Walls::new(vec![Wall::facets("floor", 0, facets.clone())]));
        let plane = end(floor());
        assert!(plane.0.x < 0.09, "it crossed");
        let (off, spin) = ((plane.0 - mesh.0).norm(), (plane.1 - mesh.1).norm());
        assert!(off < 1e-9 && spin < 1e-5, "{speed} m/s: {plane:?} {mesh:?}");
    }
}

#[test]
fn a_plane_that_is_there_twice_is_felt_once() {
    let end = |walls: Walls<3>| {
        let scene =
            Scene::<3>::new(glass(0.6, 0.4), hertz()).with_gravity([0.0, 0.0, -9.81]).with_walls(walls);
        let mut world = world(&scene, &[Grain::at([0.0, 0.0, 1.2e-2], 1e-2).moving([0.1, 0.0, 0.0])]);
        run(&scene, &mut world, 0.1, 20_000).unwrap();
        world.grains
    };
    let plane = |name| Wall::plane(name, 0, [0.0; 3], [0.0, 0.0, 1.0]);
    assert!(end(Walls::new(vec![plane("floor")])) == end(Walls::new(vec![plane("floor"), plane("again")])));
}
