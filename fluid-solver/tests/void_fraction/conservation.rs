use crate::scene::{Scene, random, random_grains, sphere, unit_box};
use fluid_solver::deposit::Deposit;
use fluid_solver::mesh::Mesh;
use fluid_solver::sample::sample;
use fluid_solver::void_fraction::{Grain, VoidFractionError, own_share};

fn scenes() -> Vec<Scene<3, 4>> {
    let meshes = [unit_box(6, false, 0.3), unit_box(8, true, 0.3), unit_box(4, true, 0.0)];
    meshes.into_iter().map(|mesh| Scene::new(mesh, 0.05, 0.3)).collect()
}

#[test]
fn weights_are_non_negative_sum_to_one_and_name_each_node_once() {
    for mut scene in scenes() {
        scene.weigh(&random_grains(700, 0.05, 0.3)).unwrap();
        for grain in 0..700 {
            let (nodes, values) = scene.weights.row(grain);
            assert!(values.iter().all(|&w| w >= 0.0));
            assert!((values.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            let mut sorted = nodes.to_vec();
            sorted.sort_unstable();
            sorted.dedup();
            assert_eq!(sorted.len(), nodes.len());
        }
    }
}

#[test]
fn the_solid_volume_on_the_nodes_is_that_of_the_grains() {
    for mut scene in scenes() {
        let grains = random_grains(700, 0.05, 0.3);
        let volumes: Vec<f64> = grains.iter().map(|grain| sphere(grain.diameter) / 50.0).collect();
        let void = scene.void_fraction(&grains, &volumes, 0.0).unwrap();
        let on_nodes: f64 =
            scene.mesh.measure().iter().zip(&void).map(|(measure, void)| measure * (1.0 - void)).sum();
        let of_grains: f64 = volumes.iter().sum();
        assert!((on_nodes / of_grains - 1.0).abs() < 1e-13, "{on_nodes} {of_grains}");
    }
}

#[test]
fn sampling_and_deposition_are_adjoint() {
    for mut scene in scenes() {
        let grains = random_grains(20_000, 0.05, 0.1);
        scene.weigh(&grains).unwrap();
        let mut next = random(3);
        let mut vectors = |count: usize| {
            (0..count).map(|_| [next() - 0.5, next() - 0.5, next() - 0.5]).collect::<Vec<[f64; 3]>>()
        };
        let (forces, field) = (vectors(grains.len()), vectors(scene.mesh.node_count()));
        let (mut sampled, mut deposited) = (vec![[0.0; 3]; grains.len()], vec![[f64::NAN; 3]; field.len()]);
        sample(&scene.weights, &field, &mut sampled);
        Deposit::default().apply(&scene.weights, &forces, &mut deposited);
        let product = |a: &[[f64; 3]], b: &[[f64; 3]]| -> f64 {
            a.iter().zip(b).map(|(a, b)| (0..3).map(|k| a[k] * b[k]).sum::<f64>()).sum()
        };
        let scale: f64 = forces.iter().flatten().map(|f| f.abs()).sum();
        assert!((product(&forces, &sampled) - product(&deposited, &field)).abs() < 1e-14 * scale);
        let total = |rows: &[[f64; 3]]| rows.iter().map(|row| row[0]).sum::<f64>();
        assert!((total(&deposited) - total(&forces)).abs() < 1e-13 * scale);
    }
}

#[test]
fn a_constant_field_is_sampled_exactly_and_a_linear_one_inside_to_two_per_cent_of_the_mesh_size() {
    let mut scene = Scene::<3, 4>::new(unit_box(12, false, 0.0), 0.01, 0.01);
    let mut grains = random_grains::<3>(300, 0.01, 0.01);
    grains.iter_mut().for_each(|grain| grain.position = grain.position.map(|c| 0.35 + 0.3 * c));
    scene.weigh(&grains).unwrap();
    let field: Vec<[f64; 2]> = scene.mesh.nodes().iter().map(|x| [7.0, x[0]]).collect();
    let mut samples = vec![[0.0; 2]; grains.len()];
    sample(&scene.weights, &field, &mut samples);
    for (grain, value) in grains.iter().zip(&samples) {
        assert!((value[0] - 7.0).abs() < 1e-13);
        assert!((value[1] - grain.position[0]).abs() < 0.02 / 12.0);
    }
}

#[test]
fn the_own_share_is_what_a_lone_grain_samples_of_itself() {
    let mut scene = Scene::<3, 4>::new(unit_box(8, false, 0.2), 0.1, 0.1);
    let grain = Grain { position: [0.4, 0.5, 0.3], diameter: 0.1 };
    let volume = sphere(0.1);
    let void = scene.void_fraction(&[grain], &[volume], 0.0).unwrap();
    let mut sampled = [[0.0]];
    sample(&scene.weights, void.as_chunks().0, &mut sampled);
    let own = own_share(&scene.weights, 0, volume, scene.mesh.measure());
    assert!((own - (1.0 - sampled[0][0])).abs() < 1e-14 && own > 1e-3, "{own} {}", 1.0 - sampled[0][0]);
}

#[test]
fn a_grain_outside_has_no_weights_samples_zero_and_gives_nothing() {
    let mut scene = Scene::<2, 3>::new(unit_box(5, false, 0.0), 0.1, 0.1);
    let outside = Grain { position: [1.5, 0.5], diameter: 0.1 };
    let void = scene.void_fraction(&[outside], &[0.01], 0.0).unwrap();
    assert!(void.iter().all(|&void| void == 1.0));
    assert!(scene.weights.row(0).0.is_empty() && scene.weights.width(0) == 0.0 && scene.hosts == [None]);
    let mut sampled = [[1.0]];
    sample(&scene.weights, &vec![[3.0]; scene.mesh.node_count()], &mut sampled);
    assert_eq!(sampled, [[0.0]]);
    assert!(scene.void_fraction(&[], &[], 0.0).unwrap().iter().all(|&void| void == 1.0), "no grains at all");
}

#[test]
fn faulty_grains_and_crowds_are_reported_with_place_and_value() {
    use VoidFractionError::*;
    let mesh: Mesh<3, 4> = unit_box(4, false, 0.0);
    for (smallest, largest) in [(0.0, 1.0), (0.2, 0.1), (f64::NAN, 1.0), (1.0, f64::INFINITY)] {
        let refused = fluid_solver::void_fraction::NodeKernel::new(&mesh, smallest..=largest);
        assert!(matches!(refused, Err(Range { .. })));
    }
    let mut scene = Scene::new(mesh, 0.1, 0.2);
    let mut grains = random_grains(600, 0.1, 0.2);
    grains[555].position[1] = f64::NAN;
    grains[599].diameter = 0.3;
    assert!(matches!(scene.weigh(&grains), Err(Position { grain: 555, .. })));
    grains[300].diameter = f64::NAN;
    assert!(matches!(scene.weigh(&grains), Err(Diameter { grain: 300, .. })));
    let crowd = vec![Grain { position: [0.5; 3], diameter: 0.1 }; 50];
    let Err(BelowFloor { node, value, floor }) = scene.void_fraction(&crowd, &[0.01; 50], 0.3) else {
        panic!()
    };
    assert_eq!((scene.mesh.nodes()[node], floor), ([0.5; 3], 0.3));
    assert!(value < 0.3 && value.is_finite());
    assert!(matches!(scene.void_fraction(&crowd[..1], &[f64::NAN], 0.3), Err(BelowFloor { .. })));
}
