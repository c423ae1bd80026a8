//! Waves over grains.

use super::scene::Tank;
use crate::flow::waves::Wave;
use crate::support::{G, WATER, flow};
use fluid_solver::backend::pfem::grains::GrainsInCloud;
use fluid_solver::grains::Spreading;
use interface::frames::{GrainRow, ReactionRow};

/// Largest amplitude in the fifth period of a standing wave over grains that are held, relative to the first; `packing`
/// scales their size.
fn kept(packing: f64) -> f64 {
    let wave = Wave { depth: 0.5, cells: [20, 10], grading: 1.0, amplitude: 5e-3 };
    let (cloud, walls) = wave.at_rest(WATER, G);
    let grains = GrainsInCloud::new(WATER, 1.0, cloud.place.len(), Spreading::Kernel);
    let mut tank = Tank { flow: flow(WATER, 1e-8), cloud, walls, grains, time: 0.0 };
    let rows: Vec<GrainRow> = (0..19)
        .map(|n| GrainRow {
            id: n,
            position: [0.05 + 0.05 * n as f64, 0.03, 0.0],
            radius: 0.025 * packing,
            mass: f64::INFINITY,
            ..GrainRow::default()
        })
        .collect();
    tank.grains.populate(&tank.cloud, &rows).unwrap();
    let steps = 40;
    let mut last: f64 = 0.0;
    for n in 0..5 * steps {
        let length = wave.period(G) / f64::from(steps);
        let (solution, _) = tank.window(length, &rows, 1, |_| vec![ReactionRow::default(); rows.len()]);
        tank.commit(length, &solution);
        if n >= 4 * steps {
            last = last.max(wave.coefficient(&tank.cloud).abs());
        }
    }
    last
}

#[test]
fn grains_on_the_floor_damp_no_wave_but_by_their_drag() {
    for packing in [0.1, 0.5, 0.9] {
        let kept = kept(packing);
        println!("amplitude after five periods over grains of {packing} spacings: {kept:.4}");
        assert!((kept - 1.0).abs() <= 0.02, "{packing}: {kept}");
    }
}
