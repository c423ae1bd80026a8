use crate::shapes::{jack, member};
use dem_solver::Vector;
use dem_solver::body::{BodyError, Clump, MassProperties};
use nalgebra::Matrix3;

#[test]
fn a_clump_without_mass_is_refused() {
    for density in [0.0, -1.0, f64::NAN] {
        assert!(matches!(Clump::of_spheres(&jack(), density), Err(BodyError::NoMass { .. })), "{density}");
    }
    assert_eq!(
        Clump::of_spheres(&jack(), 0.0).unwrap_err().to_string(),
        "clump: its mass is 0 kg; it must be positive and finite; state a density or a mass"
    );
    assert!(matches!(Clump::of_discs(&[member([0.0; 3], 1.0)], 1.0, 0.0), Err(BodyError::NoMass { .. })));
}

#[test]
fn members_that_are_none_are_refused_and_named() {
    assert_eq!(Clump::of_spheres(&[], 1.0).unwrap_err(), BodyError::NoMembers);
    for radius in [0.0, -1e-3, f64::INFINITY] {
        let members = [member([0.0; 3], 1.0), member([1.0; 3], radius)];
        assert_eq!(Clump::of_spheres(&members, 1.0).unwrap_err(), BodyError::BadRadius { member: 1, radius });
    }
    let nowhere = [member([0.0, f64::NAN, 0.0], 1.0)];
    assert!(matches!(Clump::of_spheres(&nowhere, 1.0), Err(BodyError::BadPlace { member: 0, .. })));
    let off = [member([0.0, 0.0, 0.1], 1.0)];
    assert!(matches!(Clump::of_discs(&off, 1.0, 1.0), Err(BodyError::BadPlace { member: 0, .. })));
}

#[test]
fn an_inertia_that_no_matter_has_is_refused() {
    for moments in [[1.0, 1.0, 2.1], [0.0, 1.0, 1.0], [-1.0, 2.0, 2.0], [1.0, 2.0, f64::NAN]] {
        let inertia = Matrix3::from_diagonal(&Vector::from(moments));
        let properties = MassProperties { mass: 1.0, centre: Vector::zeros(), inertia };
        let refused = Clump::with_mass(&jack(), &properties);
        assert!(matches!(refused, Err(BodyError::BadInertia { .. })), "{moments:?}: {refused:?}");
    }
    let flat = Matrix3::from_diagonal(&Vector::from([1.0, 2.0, 3.0]));
    let properties = MassProperties { mass: 1.0, centre: Vector::zeros(), inertia: flat };
    assert!(Clump::with_mass(&jack(), &properties).is_ok(), "a flat body has this");
}
