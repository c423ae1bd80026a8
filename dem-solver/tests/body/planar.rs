use crate::shapes::{DENSITY, member};
use dem_solver::Vector;
use dem_solver::body::Clump;
use nalgebra::UnitQuaternion;

#[test]
fn a_body_of_discs_turns_in_its_plane_by_omega_t() {
    let discs = [member([0.0, 0.0, 0.0], 1e-3), member([2.5e-3, 1e-3, 0.0], 1.2e-3)];
    let clump = Clump::of_discs(&discs, DENSITY, 0.01).unwrap();
    let (velocity, rate) = (Vector::from([0.2, -0.1, 0.0]), 300.0);
    let spin = Vector::from([0.0, 0.0, rate]);
    let start = clump.body(Vector::zeros(), UnitQuaternion::identity(), velocity, spin);
    let arms: Vec<Vector<3>> = start.members(&clump).map(|m| m.centre - start.centre).collect();
    let mut body = start;
    let step = 7e-3;
    for k in 1..=1000 {
        body.drift(&clump, step);
        let angle = rate * step * f64::from(k);
        for (carried, arm) in body.members(&clump).zip(&arms) {
            let (sin, cos) = angle.sin_cos();
            let turned = Vector::from([cos * arm.x - sin * arm.y, sin * arm.x + cos * arm.y, 0.0]);
            assert!((carried.centre - body.centre - turned).norm() < 1e-10 * arm.norm());
            assert!((carried.velocity - velocity - spin.cross(&turned)).norm() < 1e-10 * rate * arm.norm());
            assert_eq!(
                (carried.centre.z, carried.angular_velocity.x, carried.angular_velocity.y),
                (0.0, 0.0, 0.0)
            );
        }
    }
}
