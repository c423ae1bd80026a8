use crate::scenes::{floor, gas, run, scene, stone};
use dem_solver::insertion::{
    Amount, Batch, BoxRegion, ClumpStart, Orientation, Random, RandomFill, Region, Sizes,
};
use dem_solver::lanes::Backend;
use dem_solver::{Grain, Saved, Scene, Spin, Vector, Workspace, World, turn_over, window};

/// Several chunks of stones, and some loose grains, that fall on a floor.
fn rain() -> (Scene<3>, World<3>) {
    let scene = scene(1e7, (0.5, 0.4), vec![stone()]).with_walls(floor()).with_gravity([0.0, 0.0, -9.81]);
    let batch = Batch {
        name: "stones".into(),
        material: 0,
        sizes: Sizes::All(scene.clumps[0].shape.bounding_radius()),
        velocity: Vector::from([0.1, 0.0, -1.0]),
        frozen: false,
        clump: Some(ClumpStart { kind: 0, orientation: Orientation::Random, angular_velocity: Spin::x() }),
    };
    let upper = Vector::from([0.06, 0.06, 0.07]);
    let region = Region::Box(BoxRegion { lower: Vector::zeros(), upper });
    let mut world = World::new();
    let fill = RandomFill { region, amount: Amount::Count(1200) };
    fill.insert(&scene, &mut world, &batch, &mut Random::new(5)).unwrap();
    for k in 0..100 {
        world.add(&scene, &Grain::at([f64::from(k % 10) * 6e-3, f64::from(k / 10) * 6e-3, 0.075], 1e-3));
    }
    (scene, world)
}

#[test]
fn one_two_and_four_threads_give_the_same_bits() {
    let (scene, start) = rain();
    let end = |threads: usize| {
        let mut world = start.clone();
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| {
            for _ in 0..3 {
                turn_over(&scene, &mut world).unwrap();
                run(&scene, &mut world, 2e-3, 100);
            }
        });
        world
    };
    let one = end(1);
    assert!(one.contacts.chunks.len() > 2 && one.contacts.chunks.iter().any(|c| !c.stretches.is_empty()));
    assert!(one == end(2) && one == end(4));
}

#[test]
fn all_lanes_give_the_same_bits() {
    let (scene, start) = gas(0.8, 0.4);
    let end = |backend: Backend| {
        let mut world = start.clone();
        window(&scene, &mut world, &mut Workspace::on(backend), None, 4e-3, 1000).unwrap();
        world
    };
    let best = end(Backend::best());
    for backend in Backend::available() {
        assert!(end(backend) == best, "{backend:?}");
    }
}

#[test]
fn a_restored_and_a_reread_world_go_on_bit_by_bit() {
    let (scene, mut world) = rain();
    run(&scene, &mut world, 4e-3, 200);
    turn_over(&scene, &mut world).unwrap();
    let mut saved = Saved::default();
    world.save(&mut saved);
    let path = std::env::temp_dir().join(format!("silt-clumps-{}", std::process::id()));
    world.write_checkpoint(&path).unwrap();
    let mut reread = World::read_checkpoint(&path, &scene, vec![]).unwrap();
    assert!(reread == world);
    let without = Scene { clumps: vec![], ..scene.clone() };
    let refused = World::read_checkpoint(&path, &without, vec![]).unwrap_err().to_string();
    assert!(refused.contains("its clumps do not fit the grains and kinds"), "{refused}");
    std::fs::remove_file(&path).unwrap();
    let through = run(&scene, &mut world, 4e-3, 200);
    let again = run(&scene, &mut reread, 4e-3, 200);
    assert!(reread == world && through == again);
    let end = world.clone();
    world.restore(&saved);
    run(&scene, &mut world, 4e-3, 200);
    assert!(world == end);
}

#[test]
fn a_clump_in_a_fluid_is_refused() {
    let (scene, mut world) = gas(0.8, 0.4);
    let refused = window(&scene, &mut world, &mut Workspace::new(), Some(&[]), 1e-3, 10).unwrap_err();
    assert!(refused.to_string().starts_with("clump: there are 64 clumps in a fluid"), "{refused}");
}
