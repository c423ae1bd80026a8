//! What remeshing must not change.

use super::Seeds;
use crate::support::tank;
use fluid_solver::backend::pfem::wall::Grip;

#[test]
fn a_tank_of_water_on_an_exact_grid_stays_as_it_is_bit_by_bit() {
    let walls = tank::<2>([1.0, 1.0], Grip::Slip);
    let mut seeds = Seeds::new(&walls);
    for i in 0..=20 {
        for j in 0..=10 {
            seeds.add([0.05 * f64::from(i), 0.05 * f64::from(j)], [0.0; 2]);
        }
    }
    let mut fluid = seeds.mesh(0.05, 1.2);
    let start = fluid.cloud.clone();
    for step in 0..50 {
        // Round-off of a flow at rest: the grid's squares have two diagonals that are equally good.
        for (node, x) in fluid.cloud.place.iter_mut().enumerate() {
            let noise = 1e-15 * ((node * 31 + step * 17) % 13) as f64;
            if fluid.cloud.contacts[node].is_empty() {
                x[0] = start.place[node][0] + noise;
            }
        }
        assert!(fluid.remesh().none());
        assert_eq!(fluid.cloud.cells, start.cells, "no diagonal flickers");
    }
    assert_eq!(fluid.cloud.birth, start.birth);
    assert!(fluid.volume_error().abs() < 1e-14);
}

#[test]
fn a_front_that_slides_along_the_floor_keeps_its_contact_node() {
    let walls = tank::<2>([10.0, 10.0], Grip::Slip);
    let mut seeds = Seeds::new(&walls);
    seeds.add_box([0.2, 0.2], 0.02, 1, |x| x);
    let mut fluid = seeds.mesh(0.02, 1.2);
    // Stagnation flow: the box becomes a long flat one of the same area.
    let mut front = 0.2;
    for _ in 0..100 {
        fluid.carry(0.01, |x, _| [x[0], -x[1]]);
        front *= f64::exp(0.01);
        let floor = (0..fluid.cloud.place.len()).filter(|&node| fluid.cloud.contacts[node].contains(2));
        let foremost = floor.map(|node| fluid.cloud.place[node][0]).fold(0.0, f64::max);
        assert!((foremost / front - 1.0).abs() < 1e-6, "{foremost} {front}");
    }
    fluid.check();
    let on_floor: Vec<_> =
        (0..fluid.cloud.place.len()).filter(|&n| fluid.cloud.contacts[n].contains(2)).collect();
    assert!(on_floor.iter().all(|&node| fluid.cloud.place[node][1] == 0.0));
    assert!(on_floor.len() > 20, "the floor got nodes as it became longer");
    assert!(fluid.volume_error().abs() < 1e-6, "{}", fluid.volume_error());
}
