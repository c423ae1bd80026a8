//! What remeshing does to energy.

use super::Seeds;
use crate::support::{G, momentum, tank};
use fluid_solver::backend::pfem::remesh::Remesher;
use fluid_solver::backend::pfem::wall::Grip;

#[test]
fn volume_that_is_restored_at_the_surface_is_lifted_by_the_motion_of_the_fluid() {
    let ([length, depth], h) = ([0.584, 0.292], 0.0292);
    let mut seeds = Seeds::new(&tank::<2>([length, 1.0], Grip::Slip));
    seeds.add_box([length, depth], h, 1, |x| x);
    let mut fluid = seeds.mesh(h, 1.2);
    fluid.remesher = Remesher::default().under([0.0, -G]);
    let cloud = &mut fluid.cloud;
    for (v, x) in cloud.velocity.iter_mut().zip(&cloud.place) {
        *v = [x[1] - 0.5 * depth, 0.5 * length - x[0]];
    }
    fluid.books.volume.target *= 1.0 + 1e-4;
    let (volume, energy, start) = (fluid.books.volume.cells, fluid.energy(), momentum(&fluid.cloud));
    fluid.remesh();
    let gained = fluid.books.volume.cells - volume;
    assert!(gained > 1e-5 * volume);
    assert!(fluid.energy() <= energy * (1.0 + 1e-12));
    for (now, before) in momentum(&fluid.cloud).into_iter().zip(start) {
        assert!((now - before).abs() <= 1e-13);
    }
}
