//! Claims that every drag law is held to.

use std::f64::consts::PI;

use super::{Drag, Fitted, Slip};

/// A sphere of unit diameter in a fluid of unit density and viscosity: the speed is the particle Reynolds number.
fn unit_sphere(particle_reynolds: f64, void_fraction: f64) -> Slip {
    Slip {
        speed: particle_reynolds,
        diameter: 1.0,
        volume: PI / 6.0,
        void_fraction,
        density: 1.0,
        viscosity: 1.0,
    }
}

/// Rows of a csv file with one header line, after comments.
fn rows(csv: &str) -> (Vec<&str>, Vec<Vec<f64>>) {
    let mut lines = csv.lines().filter(|line| !line.starts_with('#'));
    let header = lines.next().unwrap().split(',').collect();
    let rows = lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    (header, rows)
}

fn assert_near(value: f64, reference: f64, tolerance: f64, what: &str) {
    assert!((value / reference - 1.0).abs() < tolerance, "{what}: {value} instead of {reference}");
}

#[test]
fn laws_of_one_sphere_give_the_published_drag_coefficient() {
    let (header, rows) = rows(include_str!("../../../tests/reference/drag_single_sphere.csv"));
    assert_eq!(rows.len(), 26);
    for (column, drag) in [
        ("stokes", Drag::Stokes),
        ("schiller_naumann", Drag::SchillerNaumann),
        ("haider_levenspiel", Drag::HaiderLevenspiel),
    ] {
        let k = header.iter().position(|name| *name == column).unwrap();
        for row in &rows {
            for void_fraction in [1.0, 0.5] {
                let slip = unit_sphere(row[0], void_fraction);
                let multiple = drag.exchange_coefficient(&slip) / slip.stokes_coefficient();
                assert_near(multiple * 24.0 / row[0], row[k], 1e-7, &format!("{column} at Re = {}", row[0]));
            }
        }
    }
}

#[test]
fn laws_of_suspensions_give_the_published_model_a_drag() {
    let (header, rows) = rows(include_str!("../../../tests/reference/drag_voidage_laws.csv"));
    assert_eq!(rows.len(), 45);
    for (column, drag) in [
        ("wen_yu", Drag::WenYu),
        ("ergun", Drag::Ergun),
        ("gidaspow", Drag::Gidaspow),
        ("di_felice", Drag::DiFelice),
    ] {
        let k = header.iter().position(|name| *name == column).unwrap();
        for row in &rows {
            let slip = unit_sphere(row[1] / row[0], row[0]);
            let multiple = drag.exchange_coefficient(&slip) / slip.stokes_coefficient();
            assert_near(multiple, row[k], 1e-7, &format!("{column} at n_f = {}, Re = {}", row[0], row[1]));
        }
    }
}

/// C_D that the law claims for a grain alone, if it claims one; without a wildcard, so that a new law has to say.
fn single_grain_drag_coefficient(drag: Drag, reynolds: f64) -> Option<f64> {
    let schiller_naumann = 24.0 / reynolds * (1.0 + 0.15 * reynolds.powf(0.687));
    match drag {
        Drag::None => Some(0.0),
        Drag::Stokes => Some(24.0 / reynolds),
        Drag::SchillerNaumann | Drag::WenYu | Drag::Gidaspow => Some(schiller_naumann),
        Drag::HaiderLevenspiel => Some(
            24.0 / reynolds * (1.0 + 0.1806 * reynolds.powf(0.6459)) + 0.4251 / (1.0 + 6880.95 / reynolds),
        ),
        Drag::Ergun => None,
        Drag::DiFelice => Some((0.63 + 4.8 / reynolds.sqrt()).powi(2)),
        Drag::DiFeliceCylinder => Some(1.0 + 10.0 * reynolds.powf(-2.0 / 3.0)),
    }
}

#[test]
fn without_neighbours_the_drag_is_that_of_one_grain() {
    for &drag in Drag::ALL {
        for reynolds in [0.5, 3.0, 40.0, 700.0] {
            let Some(coefficient) = single_grain_drag_coefficient(drag, reynolds) else { continue };
            let slip = unit_sphere(reynolds, 1.0);
            let area = match drag.fitted() {
                Fitted::AnyGrain | Fitted::Spheres => PI / 4.0,
                Fitted::Cylinders => slip.disc_length(),
            };
            let force = 0.5 * coefficient * area * reynolds * reynolds;
            let found = drag.exchange_coefficient(&slip) * reynolds;
            assert!((found - force).abs() <= 1e-13 * force, "{}: {found} instead of {force}", drag.name());
        }
    }
}

#[test]
fn drag_grows_with_slip_and_with_crowding() {
    let laws = Drag::ALL.iter().filter(|law| **law != Drag::None);
    for drag in laws {
        for void_fraction in [0.3, 0.4, 0.6, 0.79, 0.8, 0.95, 1.0] {
            let force = |i: i32| {
                let reynolds = 10.0_f64.powf(f64::from(i) / 50.0);
                drag.exchange_coefficient(&unit_sphere(reynolds, void_fraction)) * reynolds
            };
            for i in -600..400 {
                assert!(force(i + 1) > force(i), "{} at n_f = {void_fraction}, decade {i}/50", drag.name());
            }
        }
        for reynolds in [0.0, 0.1, 10.0, 1e4] {
            let beta = |n_f| drag.exchange_coefficient(&unit_sphere(reynolds, n_f));
            assert!(beta(0.4) >= beta(0.6) && beta(0.6) >= beta(0.79), "{} at Re = {reynolds}", drag.name());
        }
    }
}

#[test]
fn drag_is_finite_from_rest_to_the_fastest_slip() {
    for &drag in Drag::ALL {
        for void_fraction in [1e-3, 0.4, 1.0] {
            for reynolds in [0.0, 1e-300, 1e-12, 1e8] {
                let beta = drag.exchange_coefficient(&unit_sphere(reynolds, void_fraction));
                assert!(beta.is_finite() && beta >= 0.0, "{} at Re = {reynolds}: {beta}", drag.name());
            }
        }
        let at_rest = drag.exchange_coefficient(&unit_sphere(0.0, 0.6));
        if drag.fitted() == Fitted::Cylinders {
            assert_eq!(at_rest, 0.0, "{}: Stokes' paradox", drag.name());
        } else {
            let nearly = drag.exchange_coefficient(&unit_sphere(1e-40, 0.6));
            assert!((at_rest - nearly).abs() <= 1e-12 * nearly, "{}: {at_rest}, {nearly}", drag.name());
        }
    }
}

#[test]
fn drag_is_not_a_number_where_the_fluid_is_not() {
    for drag in Drag::ALL.iter().filter(|law| !matches!(law, Drag::None)) {
        let beta = drag.exchange_coefficient(&Slip { viscosity: f64::NAN, ..unit_sphere(1.0, 0.5) });
        assert!(beta.is_nan(), "{}: {beta}", drag.name());
    }
}

#[test]
fn the_dimensionless_drag_depends_on_reynolds_number_and_void_fraction_alone() {
    for &drag in Drag::ALL {
        let unit = unit_sphere(37.0, 0.55);
        let (diameter, density, viscosity) = (3e-4, 1.2, 1.8e-5);
        let scaled = Slip {
            speed: 37.0 * viscosity / (density * diameter),
            diameter,
            volume: PI / 6.0 * diameter * diameter * diameter,
            void_fraction: 0.55,
            density,
            viscosity,
        };
        let expected = drag.exchange_coefficient(&unit) * viscosity * diameter;
        let found = drag.exchange_coefficient(&scaled);
        assert!(
            (found - expected).abs() <= 1e-13 * expected,
            "{}: {found} instead of {expected}",
            drag.name()
        );
    }
}

#[test]
fn every_law_is_found_by_its_name_and_says_what_it_is() {
    for &drag in Drag::ALL {
        assert_eq!(Drag::by_name(drag.name()), Some(drag));
        let said = drag.explain().to_string();
        let explanation = drag.explain();
        for part in [explanation.name, explanation.formula, explanation.validity, explanation.source] {
            assert!(!part.is_empty() && said.contains(part), "{said}");
        }
    }
    assert_eq!(Drag::by_name("di_felice"), None);
    assert_eq!(Drag::by_name(""), None);
}
