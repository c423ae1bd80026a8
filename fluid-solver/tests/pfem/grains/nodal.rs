//! Grains that have a node of their own.

use super::scene::Tank;
use crate::support::{WATER, block, tank, touch};
use fluid_solver::backend::Step;
use fluid_solver::backend::pfem::Renewal;
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::remesh::{Books, Recognition, Remesher, SpaceRemesher, TargetSize};
use fluid_solver::backend::pfem::seats::seat;
use fluid_solver::backend::pfem::wall::Grip;
use fluid_solver::element::simplex::{Vector, distance, dot, volume_and_areas};
use fluid_solver::grains::Spreading;
use interface::frames::GrainRow;

const SIZE: f64 = 0.1;

/// v of a shear flow.
fn shear<const D: usize>(x: &Vector<D>) -> Vector<D> {
    std::array::from_fn(|k| if k == 0 { 0.3 * x[D - 1] } else { 0.0 })
}

/// The number of the node at a place.
fn node_at<const D: usize, const N: usize>(cloud: &Cloud<D, N>, x: &Vector<D>) -> Option<usize> {
    cloud.place.iter().position(|place| distance(place, x) == 0.0)
}

/// Two grains cross a tank that rests, a tenth of a cell a window.
fn has_its_node_all_the_way<const D: usize, const N: usize>(mut renewal: impl Renewal<D, N>) {
    let (mut cloud, walls) = (block::<D, N>([1.0; D], [10; D], 0.2), tank([1.0; D], Grip::Slip));
    touch(&mut cloud, &walls);
    cloud.velocity = cloud.place.iter().map(shear).collect();
    let (mut books, size) = (Books::start(&cloud), TargetSize::Constant(SIZE));
    let (windows, nodes) = (60, cloud.place.len());
    for n in 0..windows {
        let way = 0.01 * f64::from(n);
        let grains =
            [0.18, 0.36].map(|start| std::array::from_fn(|k| if k == 0 { start + way } else { 0.43 }));
        let sizes = vec![SIZE; cloud.place.len()];
        assert_eq!(seat(&mut cloud, &grains, &sizes).len(), 2, "{n}");
        renewal.remesh(&mut cloud, &walls, 0.0, &size, &mut books).unwrap();
        for x in &grains {
            let node = node_at(&cloud, x).unwrap_or_else(|| panic!("window {n}: no node at {x:?}"));
            assert!(cloud.cells.iter().flatten().any(|&corner| corner as usize == node));
            assert!(distance(&cloud.velocity[node], &shear(x)) < 1e-3, "{n}: {:?}", cloud.velocity[node]);
        }
    }
    assert!((cloud.place.len() as f64 / nodes as f64 - 1.0).abs() < 0.15, "{}", cloud.place.len());
    assert!((books.volume.cells - 1.0).abs() < 1e-10, "{}", books.volume.cells);
}

#[test]
fn grains_that_slip_through_a_mesh_keep_a_node_in_the_plane() {
    has_its_node_all_the_way(Remesher::<2, 3>::new(Recognition::MovedDomain));
}

#[test]
fn grains_that_slip_through_a_mesh_keep_a_node_in_space() {
    has_its_node_all_the_way(SpaceRemesher::new(Recognition::MovedDomain));
}

#[test]
fn a_grain_beside_another_or_outside_has_none_of_its_own() {
    let mut cloud = block::<2, 3>([1.0; 2], [10; 2], 0.2);
    let sizes = vec![SIZE; cloud.place.len()];
    assert_eq!(seat(&mut cloud, &[[0.43, 0.52], [0.46, 0.52], [0.43, 1.01]], &sizes).len(), 1);
}

#[test]
fn nodes_at_a_cell_that_turns_over_in_a_window_keep_a_size_so_that_grains_there_are_wet() {
    let mut tank = Tank::<3, 4>::of(WATER, 6, Grip::Slip, Spreading::Nodal);
    tank.remesh();
    let volume = |cell: &[u32; 4]| volume_and_areas(&tank.cloud.vertices(cell)).0;
    let thinnest = *tank.cloud.cells.iter().min_by(|a, b| volume(a).total_cmp(&volume(b))).unwrap();
    let (volume, areas) = volume_and_areas(&tank.cloud.vertices(&thinnest));
    // Its first corner goes as far behind the face opposite as it is in front of it.
    let (node, length) = (thinnest[0] as usize, 1e-3);
    let square = dot(&areas[0], &areas[0]);
    tank.cloud.velocity[node] = areas[0].map(|a| -2.0 * volume * a / (square * length));
    let place = tank.cloud.place[node];
    let grain = [GrainRow { position: place, radius: 1e-4, mass: 1e-9, ..GrainRow::default() }];
    tank.grains.populate(&tank.cloud, &grain).unwrap();
    tank.grains.project(&tank.cloud, Step { time: 0.0, length }, &grain).unwrap();
    assert!(tank.grains.mesh().volumes().iter().any(|volume| *volume < 0.0));
    assert!(tank.grains.mesh().size().iter().all(|size| *size > 0.0));
    assert!(tank.grains.wetted_volume() > 0.0);
}

#[test]
fn a_grain_on_the_edge_between_two_cells_has_a_node() {
    let cloud = block::<3, 4>([1.0; 3], [6; 3], 0.2);
    let sizes = vec![1.0 / 6.0; cloud.place.len()];
    let is_inner = |x: &[f64; 3]| x.iter().all(|x| (0.2..0.8).contains(x));
    let edges = cloud.cells.iter().map(|cell| [cell[0], cell[1]].map(|node| cloud.place[node as usize]));
    let mut tried = 0;
    for [a, b] in edges.filter(|ends| ends.iter().all(is_inner)) {
        for share in [0.1, 0.3, 0.7] {
            let place = std::array::from_fn(|k| a[k] + share * (b[k] - a[k]));
            assert_eq!(seat(&mut cloud.clone(), &[place], &sizes).len(), 1, "{place:?}");
            tried += 1;
        }
    }
    assert!(tried > 100);
}
