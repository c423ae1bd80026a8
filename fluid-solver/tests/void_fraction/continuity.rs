use crate::scene::{Scene, unit_box};
use fluid_solver::mesh::Mesh;
use fluid_solver::mesh::generate::Pipe;
use fluid_solver::void_fraction::Grain;

/// Largest change of weights `Σ_a |w_a(x + s) - w_a(x)|` per step over mesh size, along a line from `a` to `b`.
fn steepest<const D: usize, const N: usize>(mesh: Mesh<D, N>, a: [f64; D], b: [f64; D], steps: usize) -> f64 {
    let mut scene = Scene::new(mesh, 0.01, 0.01);
    let mut dense = |t: f64| {
        let position = std::array::from_fn(|k| a[k] + t * (b[k] - a[k]));
        scene.weigh(&[Grain { position, diameter: 0.01 }]).unwrap();
        let mut row = vec![0.0; scene.mesh.node_count()];
        let (nodes, values) = scene.weights.row(0);
        assert!(!nodes.is_empty(), "{position:?} left the mesh");
        nodes.iter().zip(values).for_each(|(&node, &value)| row[node as usize] = value);
        (row, scene.weights.width(0))
    };
    let length = (0..D).map(|k| (b[k] - a[k]).powi(2)).sum::<f64>().sqrt();
    let mut last = dense(0.0);
    let mut steepest: f64 = 0.0;
    for step in 1..=steps {
        let next = dense(step as f64 / steps as f64);
        let change: f64 = last.0.iter().zip(&next.0).map(|(a, b)| (a - b).abs()).sum();
        steepest = steepest.max(change * steps as f64 / length * next.1);
        last = next;
    }
    steepest
}

/// A jump would make the slope grow tenfold with steps ten times as small.
fn assert_lipschitz<const D: usize, const N: usize>(mesh: Mesh<D, N>, a: [f64; D], b: [f64; D]) {
    let (coarse, fine) = (steepest(mesh.clone(), a, b, 700), steepest(mesh, a, b, 7000));
    assert!(fine < 1.1 * coarse && fine < 3.0, "slope {coarse} by large steps, {fine} by small ones");
}

#[test]
fn weights_change_in_proportion_to_the_step_across_faces_edges_and_corners() {
    assert_lipschitz::<3, 4>(unit_box(6, false, 0.35), [0.0; 3], [1.0; 3]);
    assert_lipschitz::<3, 4>(unit_box(6, false, 0.35), [0.01, 0.93, 0.3], [0.98, 0.02, 0.4]);
    assert_lipschitz::<2, 3>(unit_box(9, false, 0.35), [0.0, 0.3], [1.0, 0.4]);
}

#[test]
fn weights_do_not_jump_across_a_periodic_side() {
    assert_lipschitz::<2, 3>(unit_box(9, true, 0.35), [0.55, 0.7], [1.55, 1.6]);
    assert_lipschitz::<3, 4>(unit_box(5, true, 0.3), [0.5; 3], [1.5, 1.4, 1.3]);
}

#[test]
fn weights_do_not_jump_where_a_grain_slides_along_the_facets_of_a_round_wall() {
    let pipe = || Pipe { radius: 0.5, length: 1.0, rings: 4, layers: 8 }.generate().unwrap();
    assert_lipschitz::<3, 4>(pipe(), [0.47, -0.1, 0.31], [0.35, 0.33, 0.32]);
}
