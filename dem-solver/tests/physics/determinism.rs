use std::path::Path;

use crate::scenes::{glass, hertz, partial_slip, run};
use dem_solver::contact::NormalLaw;
use dem_solver::insertion::{Amount, Batch, BoxRegion, Random, RandomFill, Region, Sizes, Uniform};
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Domain, Saved, Scene, Vector, Workspace, World, turn_over, window};
use interface::HydroRow;

/// A few thousand grains of two to one in size that fall into a box: several chunks, contacts with walls.
pub fn collapse(law: NormalLaw) -> (Scene<3>, World<3>) {
    let side = 0.03;
    let wall = |name: &str, point: [f64; 3], normal: [f64; 3]| Wall::plane(name, 0, point, normal);
    let walls = Walls::new(vec![
        wall("floor", [0.0; 3], [0.0, 0.0, 1.0]),
        wall("west", [0.0; 3], [1.0, 0.0, 0.0]),
        wall("east", [side, 0.0, 0.0], [-1.0, 0.0, 0.0]),
        wall("south", [0.0; 3], [0.0, 1.0, 0.0]),
        wall("north", [0.0, side, 0.0], [0.0, -1.0, 0.0]),
    ]);
    let scene = Scene::<3>::new(glass(0.6, 0.4), law).with_gravity([0.0, 0.0, -9.81]).with_walls(walls);
    let batch = Batch {
        name: "bed".into(),
        material: 0,
        sizes: Sizes::Uniform(Uniform { smallest: 0.5e-3, largest: 1e-3 }),
        velocity: Vector::from([0.2, 0.0, -1.0]),
        frozen: false,
        clump: None,
    };
    let region = Region::Box(BoxRegion { lower: Vector::zeros(), upper: Vector::from([side, side, 0.03]) });
    let fill = RandomFill { region, amount: Amount::Count(3000) };
    let mut world = World::new();
    fill.insert(&scene, &mut world, &batch, &mut Random::new(5)).unwrap();
    (scene, world)
}

fn on_threads<R: Send>(threads: usize, work: impl FnOnce() -> R + Send) -> R {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

#[test]
fn one_two_and_four_threads_give_the_same_bits() {
    let (scene, start) = collapse(hertz());
    let end = |threads: usize| {
        let mut world = start.clone();
        on_threads(threads, || {
            for _ in 0..4 {
                turn_over(&scene, &mut world).unwrap();
                run(&scene, &mut world, 2e-3, 250).unwrap();
            }
        });
        world
    };
    let one = end(1);
    let chunks = &one.contacts.chunks;
    assert!(chunks.len() > 2 && chunks.iter().any(|chunk| chunk.planes.count > 0));
    assert!(chunks.iter().any(|chunk| !chunk.stretches.is_empty()), "pairs reach from chunk to chunk");
    assert!(one == end(2));
    assert!(one == end(4));
}

#[test]
fn a_restored_world_repeats_every_bit() {
    let (scene, mut world) = collapse(hertz());
    run(&scene, &mut world, 4e-3, 500).unwrap();
    let mut saved = Saved::default();
    world.save(&mut saved);
    let mut workspace = Workspace::new();
    let first = window(&scene, &mut world, &mut workspace, None, 2e-3, 250).unwrap();
    let end = world.clone();
    world.restore(&saved);
    assert!(world.contacts.counters.inner < end.contacts.counters.inner, "lists were made between");
    let again = window(&scene, &mut world, &mut workspace, None, 2e-3, 250).unwrap();
    assert!(world == end && first == again);
}

#[test]
fn the_order_of_rows_does_not_matter_to_the_physics() {
    shuffle(hertz());
    shuffle(partial_slip());
}

fn shuffle(law: NormalLaw) {
    let (scene, mut world) = collapse(law);
    run(&scene, &mut world, 8e-3, 1000).unwrap();
    let mut shuffled = world.clone();
    let mut random = Random::new(11);
    let mut order: Vec<u32> = (0..world.grains.len() as u32).collect();
    for k in (1..order.len()).rev() {
        order.swap(k, (random.bits() % (k as u64 + 1)) as usize);
    }
    shuffled.reorder(&order);
    run(&scene, &mut world, 5e-5, 10).unwrap();
    run(&scene, &mut shuffled, 5e-5, 10).unwrap();
    let mut largest = 0.0_f64;
    for (row, &old) in order.iter().enumerate() {
        let (a, b) = (&shuffled.grains.motion[row], &world.grains.motion[old as usize]);
        assert_eq!(shuffled.grains.id[row], world.grains.id[old as usize]);
        largest = largest
            .max((a.velocity - b.velocity).norm() + 1e-3 * (a.angular_velocity - b.angular_velocity).norm());
    }
    assert!(largest < 1e-12, "largest difference {largest} m/s: springs went with their pairs");
}

#[test]
fn a_stale_list_would_be_seen() {
    // Against a list built anew in every substep: the skin hides no contact.
    let (scene, start) = collapse(hertz());
    let (mut with_skin, mut anew) = (start.clone(), start);
    for _ in 0..400 {
        anew.contacts.expire();
        run(&scene, &mut anew, 1e-5, 1).unwrap();
        run(&scene, &mut with_skin, 1e-5, 1).unwrap();
    }
    assert!(anew.grains == with_skin.grains);
}

#[test]
fn a_stale_list_would_be_seen_in_a_fluid_and_across_periods() {
    // Grains that a gust takes along within a few substeps, one more willingly than the other, so that each relaxes by
    // much of its slip in one of them: the skin must know how far they catch up.
    let domain = Domain::new([0.0; 3], [0.025; 3]).periodic([true; 3]);
    let scene = Scene::<3>::new(glass(0.6, 0.4), hertz()).in_domain(domain);
    let batch = Batch {
        name: "cloud".into(),
        material: 0,
        sizes: Sizes::Uniform(Uniform { smallest: 0.5e-3, largest: 1e-3 }),
        velocity: Vector::zeros(),
        frozen: false,
        clump: None,
    };
    let region = Region::Box(BoxRegion { lower: Vector::zeros(), upper: Vector::from([0.025; 3]) });
    let fill = RandomFill { region, amount: Amount::SolidFraction(0.25) };
    let mut start = World::new();
    fill.insert(&scene, &mut start, &batch, &mut Random::new(5)).unwrap();
    let step = 1e-5;
    let gust = |row: usize, time: f64| {
        let (sine, cosine) = (2e3 * time + row as f64).sin_cos();
        HydroRow {
            exchange_coefficient: start.grains.mass[row] / step
                * if row.is_multiple_of(2) { 1.0 } else { 0.2 },
            fluid_velocity: [4.0 * sine, 4.0 * cosine, -2.0 * sine],
            ..Default::default()
        }
    };
    let (mut with_skin, mut anew) = (start.clone(), start.clone());
    for _ in 0..60 {
        let rows: Vec<_> = (0..start.grains.len()).map(|row| gust(row, with_skin.time)).collect();
        let go = |world: &mut World<3>| {
            drop(window(&scene, world, &mut Workspace::new(), Some(&rows), 2.0 * step, 2).unwrap());
        };
        anew.contacts.expire();
        go(&mut anew);
        go(&mut with_skin);
    }
    let [seldom, often] = [&with_skin, &anew].map(|world| world.contacts.counters);
    assert!(seldom.outer > 1 && 2 * seldom.outer < often.outer, "{seldom:?} {often:?}");
    let touching = with_skin.contacts.chunks.iter().flat_map(|chunk| &chunk.inner.blocks).count();
    assert!(touching > 100, "they meet");
    // Places are wrapped at other times: round-off apart.
    let off = with_skin.grains.motion.iter().zip(&anew.grains.motion);
    let largest = off.map(|(a, b)| (a.velocity - b.velocity).norm()).fold(0.0, f64::max);
    assert!(largest < 1e-9, "off by {largest} m/s");
}

/// Writes a world in the middle of a collapse under this law and reads it again, once as a window leaves it, once with a
/// new order and springs on their way; both go on with the same bits.
fn resume(law: NormalLaw, path: &Path) {
    let (scene, mut world) = collapse(law);
    run(&scene, &mut world, 4e-3, 500).unwrap();
    world.contacts.built_since_order = u32::MAX;
    for sorted in [false, true] {
        if sorted {
            assert!(turn_over(&scene, &mut world).unwrap().order_changed);
        }
        world.write_checkpoint(path).unwrap();
        let mut resumed = World::read_checkpoint(path, &scene, vec![]).unwrap();
        assert!(resumed == world);
        let mut through = world.clone();
        run(&scene, &mut through, 2e-3, 250).unwrap();
        run(&scene, &mut resumed, 2e-3, 250).unwrap();
        assert!(resumed == through);
    }
}

#[test]
fn a_resumed_world_goes_on_with_the_same_bits() {
    let path = std::env::temp_dir().join(format!("dem-solver-{}.checkpoint", std::process::id()));
    resume(partial_slip(), &path);
    resume(hertz(), &path);
    let other = Scene::<3>::new(glass(0.6, 0.4), hertz());
    let error = World::read_checkpoint(&path, &other, vec![]).unwrap_err().to_string();
    assert!(
        error.ends_with(
            "do not fit the grains and walls; resume with the case, and the program, that wrote it"
        ),
        "{error}"
    );
    let flat = Scene::<2>::new(glass(0.6, 0.4), hertz());
    assert!(
        World::read_checkpoint(&path, &flat, vec![]).unwrap_err().to_string().contains("another dimension")
    );
    std::fs::remove_file(&path).unwrap();
}
