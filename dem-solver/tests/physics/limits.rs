use crate::scenes::{floor, glass, hertz, hooke, run, world};
use dem_solver::wall::{Cylinder, Disc, Facet, Shape, Side, Wall, Walls};
use dem_solver::{
    Binding, DemError, Domain, Escape, Fault, Grain, Scene, Substep, Vector, World, critical_time_step,
    substeps, turn_over,
};

fn fault(error: DemError) -> Fault {
    match error {
        DemError::Fault { fault, .. } => fault,
        other => panic!("{other}"),
    }
}

#[test]
fn the_smallest_grain_sets_the_step_and_twice_the_step_resolves_the_contact_half_as_well() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    let grains =
        [Grain::at([0.0; 3], 1e-3), Grain::at([1.0, 0.0, 0.0], 1e-4), Grain::at([2.0, 0.0, 0.0], 2e-3)];
    let critical = critical_time_step(&scene, &world(&scene, &grains));
    assert_eq!(critical.binding, Binding::Contact(1));
    // 0.4 of Rayleigh's time of that grain.
    let shear_modulus = 1e7 / 2.6;
    let rayleigh =
        std::f64::consts::PI * 1e-4 * (2500.0_f64 / shear_modulus).sqrt() / (0.1631 * 0.3 + 0.8766);
    assert!((critical.step / (0.4 * rayleigh) - 1.0).abs() < 1e-12);
}

#[test]
fn a_fast_grain_sets_the_step() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    let grains = [Grain::at([0.0; 3], 1e-3), Grain::at([1.0, 0.0, 0.0], 1e-3).moving([1e4, 0.0, 0.0])];
    let critical = critical_time_step(&scene, &world(&scene, &grains));
    assert_eq!((critical.binding, critical.step), (Binding::Speed(1), 1e-8));
}

#[test]
fn the_bound_on_stiffness_is_where_a_chain_becomes_unstable() {
    // A frozen, a free, a frozen grain in line, pressed together: ω² = 2 k/m, stable below 2/ω. Gershgorin's
    // circle counts the neighbours' motion too and asks for 2/√(4 k/m).
    let scene = Scene::<3>::new(glass(1.0, 0.0), hooke());
    let grains = [
        Grain::at([-1.9e-3, 0.0, 0.0], 1e-3).frozen(),
        Grain::at([1e-9, 0.0, 0.0], 1e-3),
        Grain::at([1.9e-3, 0.0, 0.0], 1e-3).frozen(),
    ];
    let mut chain = world(&scene, &grains);
    run(&scene, &mut chain, 1e-12, 1).unwrap();
    let list = &chain.contacts;
    let (_, _, coefficients) = list.chunks[0].inner.pairs(list.alike.as_ref()).next().unwrap();
    let stiffness = coefficients.normal_stiffness;
    let stable = 2.0 / (2.0 * stiffness / chain.grains.mass[1]).sqrt();
    let shake = |step: f64| {
        let mut world = world(&scene, &grains);
        run(&scene, &mut world, 400.0 * step, 400).map(|_| world.grains.place[1].centre.x.abs())
    };
    assert!(shake(0.99 * stable).unwrap() < 1e-7);
    assert!(shake(1.01 * stable).is_err() || shake(1.01 * stable).unwrap() > 1e-6);
    assert!(critical_time_step(&scene, &chain).step < stable / 2.0_f64.sqrt() * (1.0 + 1e-12));
}

#[test]
fn steps_that_cannot_be_are_refused_with_what_binds() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    let critical = critical_time_step(&scene, &world(&scene, &[Grain::at([0.0; 3], 1e-3)]));
    let count = |window: f64, wish: Substep| substeps(window, wish, &critical);
    assert_eq!(count(10.0 * critical.step, Substep::Given(critical.step)).unwrap(), 10);
    assert_eq!(count(10.0 * critical.step, Substep::Fraction(0.5)).unwrap(), 20);
    let too_large = count(1.0, Substep::Given(2.0 * critical.step)).unwrap_err().to_string();
    assert!(
        too_large.starts_with("time.substep: ")
            && too_large.contains("the duration of a contact of grain 0 sets")
    );
    let too_many = count(1e7 * critical.step, Substep::Fraction(0.5)).unwrap_err().to_string();
    assert!(too_many.contains("more than 1000000 allowed"), "{too_many}");
    for window in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(count(window, Substep::Fraction(0.5)).is_err());
    }
    assert_eq!(
        substeps(1.0, Substep::Fraction(0.5), &critical_time_step(&scene, &World::<3>::new())).unwrap(),
        1
    );
}

#[test]
fn what_is_not_finite_is_found_in_the_step_it_appears() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    for bad in [f64::NAN, f64::INFINITY] {
        let grains = [Grain::at([0.0; 3], 1e-3), Grain::at([1.0, 0.0, 0.0], 1e-3).moving([bad, 0.0, 0.0])];
        let error = run(&scene, &mut world(&scene, &grains), 1e-3, 10).unwrap_err();
        assert_eq!(fault(error), Fault::NotFinite { grain: 1 });
    }
    let mut nowhere = world(&scene, &[Grain::at([f64::NAN, 0.0, 0.0], 1e-3)]);
    assert_eq!(fault(run(&scene, &mut nowhere, 1e-3, 1).unwrap_err()), Fault::NotFinite { grain: 0 });
}

#[test]
fn coincident_centres_are_found() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz()).with_walls(floor());
    let mut twins = world(&scene, &[Grain::at([0.0, 0.0, 1.0], 1e-3), Grain::at([0.0, 0.0, 1.0], 2e-3)]);
    let error = run(&scene, &mut twins, 1e-6, 1).unwrap_err();
    assert_eq!(fault(error), Fault::Coincident { one: 0, other: 1 });
}

#[test]
fn a_centre_inside_another_grain_is_found() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    // The large one reaches 1e-5 m beyond the small one's centre, or not.
    let at = |distance: f64| [Grain::at([0.0; 3], 5e-3), Grain::at([distance, 0.0, 0.0], 1e-3)];
    run(&scene, &mut world(&scene, &at(5.01e-3)), 1e-9, 1).unwrap();
    let error = run(&scene, &mut world(&scene, &at(4.99e-3)), 1e-9, 1).unwrap_err();
    let Fault::TooDeep { grain: 1, other: 0, depth, .. } = fault(error) else {
        panic!("the small one is named")
    };
    assert!((depth - 1.01).abs() < 1e-9);
    // Frozen ones bear it.
    let frozen = at(4.99e-3).map(Grain::frozen);
    run(&scene, &mut world(&scene, &frozen), 1e-9, 1).unwrap();
}

#[test]
fn a_contact_too_soft_for_the_impact_stops_the_run_before_the_wall_is_passed() {
    let facet = Facet::new([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]]);
    let disc = Disc { centre: Vector::zeros(), axis: Vector::z(), radius: 1.0 };
    let shell = Cylinder { point: Vector::zeros(), axis: Vector::x(), radius: 0.1, side: Side::Inside };
    let upright = |wall| (wall, [0.0, 0.0, 1.5e-3]);
    let walls = [
        upright(Wall::plane("plane", 0, [0.0; 3], [0.0, 0.0, 1.0])),
        upright(Wall::facets("triangle", 0, vec![facet])),
        upright(Wall::new("disc", 0, vec![Shape::Disc(disc)])),
        (Wall::new("cylinder", 0, vec![Shape::Cylinder(shell)]), [0.0, 0.0, -0.0985]),
    ];
    for (wall, at) in walls {
        let name = wall.name.clone();
        let scene = Scene::<3>::new(glass(0.9, 0.3), hooke()).with_walls(Walls::new(vec![wall]));
        let mut world = world(&scene, &[Grain::at(at, 1e-3).moving([0.0, 0.0, -100.0])]);
        // A tenth of the radius in a step.
        let error = (0..100).find_map(|_| run(&scene, &mut world, 1e-5, 10).err()).expect(&name);
        let told = error.to_string();
        let Fault::ThroughWall { grain: 0, wall: 0, depth, speed } = fault(error) else {
            panic!("{name}: {told}")
        };
        assert!(depth > 0.8 && depth < 1.2 && speed > 10.0 && speed < 100.0, "{name}: {told}");
        assert!(
            told.contains("its centre goes through wall 0") && told.ends_with("insert grains apart"),
            "{told}"
        );
        // At a hundredth of the speed it bounces.
        let mut slow = World::new();
        slow.add(&scene, &Grain::at(at, 1e-3).moving([0.0, 0.0, -1.0]));
        (0..30).for_each(|_| drop(run(&scene, &mut slow, 1e-4, 100).unwrap()));
        assert!(slow.grains.motion[0].velocity.z > 0.8, "{name}: {}", slow.grains.motion[0].velocity.z);
    }
}

#[test]
fn an_escaped_grain_stops_the_run_or_is_removed_and_booked() {
    let domain = Domain::new([-1.0; 3], [1.0; 3]);
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz()).in_domain(domain);
    let grains = [
        Grain::at([0.0; 3], 1e-3),
        Grain::at([0.99, 0.0, 0.0], 1e-3).moving([1.0, 0.0, 0.0]),
        Grain::at([0.0, 0.5, 0.0], 1e-3),
    ];
    // Told at the end of the window in which it left.
    let mut leaving = world(&scene, &grains);
    let error = (0..100).find_map(|_| run(&scene, &mut leaving, 1e-3, 1).err()).unwrap();
    assert!(matches!(fault(error), Fault::Escaped { grain: 1, at } if at[0] > 1.0 && at[0] < 1.002));

    let scene = Scene { escape: Escape::Remove, ..scene };
    let mut world = world(&scene, &grains);
    run(&scene, &mut world, 0.1, 100).unwrap();
    assert_eq!(world.grains.len(), 3, "rows stay within a window");
    let turnover = turn_over(&scene, &mut world).unwrap();
    assert_eq!(
        (turnover.removed.count, turnover.order_changed, &world.grains.id[..]),
        (1, true, &[0, 2][..])
    );
    assert!((turnover.removed.momentum.x - turnover.removed.mass).abs() < 1e-18);
}

#[test]
fn a_period_too_short_for_the_grains_is_refused() {
    let domain = Domain::new([0.0; 3], [1.0, 4e-3, 1.0]).periodic([false, true, false]);
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz()).in_domain(domain);
    let error = run(&scene, &mut world(&scene, &[Grain::at([0.5, 1e-3, 0.5], 1e-3)]), 1e-3, 10).unwrap_err();
    assert!(error.to_string().starts_with("grains.periodic: the domain is 0.004 m long in y"), "{error}");
}

#[test]
fn grains_a_thousand_times_different_in_size_find_each_other() {
    let scene = Scene::<3>::new(glass(1.0, 0.0), hertz());
    let mut grains = vec![Grain::at([0.0; 3], 1e-1)];
    for k in 0..20 {
        let angle = f64::from(k) * 0.3;
        let direction = [angle.cos(), angle.sin(), 0.0];
        let towards = direction.map(|x| -x);
        grains.push(Grain::at(direction.map(|x| x * 0.1002), 1e-4).moving(towards));
    }
    let mut world = world(&scene, &grains);
    run(&scene, &mut world, 4e-4, 4000).unwrap();
    for k in 1..=20 {
        let (place, motion) = (&world.grains.place[k], &world.grains.motion[k]);
        assert!(motion.velocity.dot(&place.centre) / place.centre.norm() > 0.99, "grain {k} bounced off");
    }
}
