//! What walls and weight do is all that changes the momentum.

use crate::support::{G, WATER, add_drop, advance, block, flow, gravity, tank, touch};
use fluid_solver::backend::pfem::wall::Grip;

fn momentum<const D: usize>(mass: &[f64], velocity: &[[f64; D]], k: usize) -> f64 {
    mass.iter().zip(velocity).map(|(m, v)| m * v[k]).sum()
}

/// A column between walls that collapses, with a drop above it that falls on the floor.
fn collapse<const D: usize, const N: usize>(cells: [usize; D], grip: Grip) {
    let (mut cloud, mut size) = (block::<D, N>([0.1; D], cells, 0.25), [0.1; D]);
    size[0] = 0.4;
    let walls = tank(size, grip);
    let mut place = [0.05; D];
    (place[0], place[D - 1]) = (0.3, 0.002);
    add_drop(&mut cloud, place, 1e-6);
    touch(&mut cloud, &walls);
    let length = 2e-3;
    // A tolerance as loose as this one would show in the sum if it were not taken out.
    let mut before = cloud.velocity.clone();
    advance(&mut flow(WATER, 1e-3), &mut cloud, &walls, &gravity(), length, 0..15, |cloud, solution| {
        for k in 0..D {
            let weight: f64 = if k == D - 1 { -G * solution.mass.iter().sum::<f64>() } else { 0.0 };
            let reaction: f64 = solution.reaction.iter().map(|force| force[k]).sum();
            let change = momentum(&solution.mass, &cloud.velocity, k) - momentum(&solution.mass, &before, k)
                + length * solution.exchange[k];
            let size: f64 = solution.reaction.iter().map(|force| force[k].abs()).sum::<f64>() + weight.abs();
            let defect = change - length * (weight + reaction);
            assert!(defect.abs() <= 1e-12 * length * size, "{k}: {defect:e} of {size:e}");
        }
        before.clone_from(&cloud.velocity);
    });
    let drop = cloud.velocity.len() - 1;
    assert!(cloud.contacts[drop].contains(if D == 2 { 2 } else { 4 }));
    assert!(cloud.place[drop][D - 1].abs() < 1e-15 && cloud.velocity[drop][D - 1] == 0.0);
}

#[test]
fn momentum_changes_by_weight_and_walls_alone_to_round_off() {
    for grip in [Grip::Slip, Grip::NoSlip, Grip::WallFunction] {
        collapse::<2, 3>([8, 8], grip);
        collapse::<3, 4>([4, 4, 4], grip);
    }
}
