use crate::assembly::{Sphere, Spheres, cement};
use dem_solver::bond::{Bond, BondError, BondLaw, Bonds, Links, Profile};
use dem_solver::{Fault, Vector};

fn bond(one: u64, other: u64) -> Bond {
    Bond::new([one, other], 0, Vector::from([2e-3, 0.0, 0.0]))
}

fn link(bonds: &[Bond]) -> Result<Links, BondError> {
    let bonds = Bonds::new(bonds.to_vec())?;
    let laws = [BondLaw::ParallelBond(cement())];
    Links::new(&laws, Profile::Round, &bonds, &[0, 1, 5], |_| Sphere::at([0.0; 3], 1e-3).end())
}

#[test]
fn a_bond_to_a_grain_that_is_not_there_is_refused_and_named() {
    assert!(link(&[bond(0, 5)]).is_ok());
    let error = link(&[bond(0, 1), bond(1, 4)]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "bond of grains 1 and 4: grain 4 does not exist among 3 grains; bond grains that are inserted at the start, \
         or leave the bond out"
    );
}

#[test]
fn bonds_that_make_no_sense_are_refused() {
    assert_eq!(link(&[bond(1, 1)]).unwrap_err(), BondError::WithItself { grain: 1 });
    let twice = link(&[bond(0, 1), bond(0, 5), bond(1, 0)]).unwrap_err();
    assert_eq!(twice, BondError::Twice { one: 0, other: 1 });
    let nowhere = Bond::new([0, 1], 0, Vector::from([f64::NAN, 0.0, 0.0]));
    for bad in [Bond::new([0, 1], 0, Vector::zeros()), nowhere] {
        assert!(matches!(link(&[bad]), Err(BondError::NoLength { one: 0, other: 1, .. })));
    }
    let lawless = Bond { law: 3, ..bond(0, 1) };
    assert_eq!(link(&[lawless]).unwrap_err(), BondError::MissingLaw { one: 0, other: 1, law: 3, laws: 1 });
}

#[test]
fn bonded_centres_that_meet_are_a_fault() {
    let mut bonds = Bonds::new(vec![bond(0, 1)]).unwrap();
    let mut links = link(&[bond(0, 1)]).unwrap();
    let spheres = Spheres(vec![Sphere::at([0.0; 3], 1e-3); 2]);
    bonds.fly(1e-6);
    let fault = links.pull(&[BondLaw::ParallelBond(cement())], &mut bonds, &spheres).unwrap_err();
    assert_eq!(fault, Fault::Coincident { one: 0, other: 1 });
}
