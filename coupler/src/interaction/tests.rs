//! Claims about grains in a fluid: the laws, the relaxation of the grain and the reaction together.

use std::array::from_fn;

use interface::frames::{GrainRow, HydroRow, ImpulseRow, ReactionRow, SampleRow};

use super::drag::Drag;
use super::exchange::{Relaxation, target_velocity};
use super::{Interaction, InteractionError, Laws, Passage, Shape, compliant_reaction, reaction};

const STOKES: Laws = Laws { drag: Drag::Stokes, added_mass: 0.0, self_disturbance: false };

fn water() -> SampleRow {
    SampleRow {
        void_fraction: 0.99,
        wetted_fraction: 1.0,
        kernel_width: 4e-3,
        own_share: 1e-3,
        density: 998.2,
        viscosity: 1.002e-3,
        ..SampleRow::default()
    }
}

fn glass(radius: f64) -> GrainRow {
    GrainRow { id: 7, radius, mass: 2500.0 * Shape::Sphere.volume(radius), ..GrainRow::default() }
}

/// What a grain solver does with a hydro row: exact relaxation over the window under `other` constant forces.
fn advance(grain: &GrainRow, hydro: &HydroRow, other: [f64; 3], window: f64) -> (GrainRow, ImpulseRow) {
    let inertia = grain.mass + hydro.added_mass;
    let other: [f64; 3] = from_fn(|k| other[k] + hydro.force[k]);
    let beta = hydro.exchange_coefficient;
    let mean = Relaxation::over(beta * window / inertia).mean;
    let target = target_velocity(grain.velocity, other, inertia, beta, window);
    let drag = from_fn(|k| beta * mean * (hydro.fluid_velocity[k] - target[k]) * window);
    let velocity = from_fn(|k| grain.velocity[k] + (drag[k] + other[k] * window) / inertia);
    (GrainRow { velocity, ..*grain }, ImpulseRow { drag, other })
}

/// A periodic box without gravity: fluid of mass `fluid_mass` to one grain, both moving as one each.
struct PeriodicBox {
    fluid_mass: f64,
    fluid: [f64; 3],
    fluid_acceleration: [f64; 3],
    grain: GrainRow,
    owed: [f64; 3],
}

impl PeriodicBox {
    /// One window of the explicit scheme: grain, then fluid, implicit in the reaction.
    fn step(&mut self, beta: f64, added_mass: f64, window: f64) {
        let sample = SampleRow { velocity: self.fluid, acceleration: self.fluid_acceleration, ..water() };
        let hydro = HydroRow {
            force: from_fn(|k| added_mass * sample.acceleration[k] + self.owed[k] / window),
            exchange_coefficient: beta,
            fluid_velocity: sample.velocity,
            added_mass,
            ..HydroRow::default()
        };
        let (after, impulse) = advance(&self.grain, &hydro, [0.0; 3], window);
        let passage =
            Passage { before: &self.grain, after: &after, sample: &sample, hydro: &hydro, impulse: &impulse };
        let row: ReactionRow = reaction(&passage, window);
        let resistance = row.exchange_coefficient;
        let reached = from_fn(|k| {
            let momentum = self.fluid_mass * self.fluid[k]
                + window * (row.force[k] + resistance * row.target_velocity[k]);
            momentum / (self.fluid_mass + window * resistance)
        });
        self.owed = from_fn(|k| resistance * window * (reached[k] - self.fluid[k]));
        self.fluid_acceleration = from_fn(|k| (reached[k] - self.fluid[k]) / window);
        self.fluid = reached;
        self.grain = after;
    }

    fn momentum(&self) -> f64 {
        self.grain.mass * self.grain.velocity[0] + self.fluid_mass * self.fluid[0] + self.owed[0]
    }
}

#[test]
fn momentum_closes_and_velocities_stay_bounded_for_every_ratio_of_masses_and_of_times() {
    for solids_to_fluid in [1e-3, 0.01, 1.0, 30.0, 1e4] {
        for x in [1e-4, 0.3, 10.0, 1e4, 1e6] {
            for added_to_fluid in [0.0, 0.1, 0.75] {
                let mass = 1e-6;
                let fluid_mass = mass / solids_to_fluid;
                let grain = GrainRow { velocity: [1.0, 0.0, 0.0], mass, ..GrainRow::default() };
                let mut scene = PeriodicBox {
                    fluid_mass,
                    fluid: [0.0; 3],
                    fluid_acceleration: [0.0; 3],
                    grain,
                    owed: [0.0; 3],
                };
                let total = scene.momentum();
                for n in 0..200 {
                    let drift = 1.0 + 0.1 * f64::from(n % 7) / 6.0;
                    scene.step(x * mass / 1e-3 * drift, added_to_fluid * fluid_mass, 1e-3);
                    let defect = (scene.momentum() - total).abs() / (scene.grain.mass + fluid_mass);
                    assert!(defect < 1e-13, "{solids_to_fluid} {x} {added_to_fluid}: {defect}");
                    let fastest = scene.fluid[0].abs().max(scene.grain.velocity[0].abs());
                    assert!(fastest < 1.1, "{solids_to_fluid} {x} {added_to_fluid}, window {n}: {fastest}");
                }
            }
        }
    }
}

/// u and v relax with 1/τ = β(1/m + 1/M), by Stokes drag, to the common velocity; first order in Δt.
#[test]
fn a_suspension_relaxes_to_its_mixture_velocity_at_the_exact_rate() {
    let (mass, fluid_mass, beta) = (1.0, 3.0, 2.0);
    let rate = beta * (1.0 / mass + 1.0 / fluid_mass);
    let error = |steps: u32| {
        let window = 1.0 / (rate * f64::from(steps));
        let grain = GrainRow { velocity: [1.0, 0.0, 0.0], mass, ..GrainRow::default() };
        let mut scene =
            PeriodicBox { fluid_mass, fluid: [0.0; 3], fluid_acceleration: [0.0; 3], grain, owed: [0.0; 3] };
        for _ in 0..steps {
            scene.step(beta, 0.0, window);
        }
        scene.grain.velocity[0] - (0.25 + 0.75 * (-1.0_f64).exp())
    };
    let (coarse, fine) = (error(100), error(200));
    let order = (coarse / fine).log2();
    assert!((order - 1.0).abs() < 0.05 && fine.abs() < 1e-3, "order {order}, errors {coarse} {fine}");
}

#[test]
fn a_neutrally_buoyant_grain_at_rest_in_still_water_stays_at_rest() {
    let laws = Laws { added_mass: 0.5, ..STOKES };
    let interaction = Interaction::new(laws, Shape::Sphere).unwrap();
    let sample = SampleRow { pressure_gradient: [0.0, 0.0, -998.2 * 9.81], ..water() };
    let mass = 998.2 * Shape::Sphere.volume(1e-3);
    let grain = GrainRow { mass, ..glass(1e-3) };
    let hydro = interaction.evaluate(&grain, &sample, [0.0; 3], 1e-3).unwrap();
    let (after, _) = advance(&grain, &hydro, [0.0, 0.0, -mass * 9.81], 1e-3);
    assert!(after.velocity[2].abs() < 1e-17, "{:?}", after.velocity);
}

/// Force balance of a 2 mm glass sphere in water, Schiller & Naumann: 0.26765428 m/s.
#[test]
fn a_glass_sphere_of_two_millimetres_settles_at_its_published_speed() {
    let laws = Laws { drag: Drag::SchillerNaumann, ..STOKES };
    let interaction = Interaction::new(laws, Shape::Sphere).unwrap();
    let sample = SampleRow { pressure_gradient: [0.0, 0.0, -998.2 * 9.81], ..water() };
    let mut grain = glass(1e-3);
    for _ in 0..400 {
        let hydro = interaction.evaluate(&grain, &sample, [0.0; 3], 5e-3).unwrap();
        grain = advance(&grain, &hydro, [0.0, 0.0, -grain.mass * 9.81], 5e-3).0;
    }
    assert!((grain.velocity[2] / -0.267_654_28 - 1.0).abs() < 1e-7, "{:?}", grain.velocity);
}

/// The grain's own force F comes back as φ_own F(1/3 + 2Ψ₂/3) in the stress forces; with it the total is F.
#[test]
fn drag_and_own_stress_together_are_the_undisturbed_drag() {
    let laws = Laws { self_disturbance: true, ..STOKES };
    let grain = glass(1e-3);
    // Creeping flow: the sample has lost s β of the slip U, and V∇·σ holds φ_own of the drag.
    let (slip, own_share) =
        (1e-9, Shape::Sphere.volume(1e-3) / (4.0 * std::f64::consts::PI * 1.6e-5).powf(1.5));
    let drag = 3.0 * std::f64::consts::PI * 1.002e-3 * 2e-3 * slip;
    let lost = 2e-3 / (2.0 * std::f64::consts::PI.sqrt() * 4e-3);
    let density = -own_share * drag / Shape::Sphere.volume(1e-3);
    let sample = SampleRow {
        velocity: [slip * (1.0 - lost), 0.0, 0.0],
        pressure_gradient: [density / 3.0, 0.0, 0.0],
        viscous_stress_divergence: [-density * 2.0 / 3.0, 0.0, 0.0],
        void_fraction: 1.0 - own_share,
        own_share,
        ..water()
    };
    let hydro =
        Interaction::new(laws, Shape::Sphere).unwrap().evaluate(&grain, &sample, [0.0; 3], 1e-3).unwrap();
    let total = hydro.force[0] + hydro.exchange_coefficient * sample.velocity[0];
    assert!((total / drag - 1.0).abs() < 1e-5, "{total} {drag}");
}

/// dv/dt = 3/(1 + 2 ρ_p/ρ) Du/Dt without drag: −∇p = ρ Du/Dt and added mass 1/2.
#[test]
fn a_light_sphere_outruns_an_accelerated_fluid_by_its_added_mass() {
    let laws = Laws { drag: Drag::None, added_mass: 0.5, ..STOKES };
    let sample =
        SampleRow { acceleration: [0.7, 0.0, 0.0], pressure_gradient: [-0.7 * 998.2, 0.0, 0.0], ..water() };
    let grain = GrainRow { mass: 0.1 * 998.2 * Shape::Sphere.volume(1e-3), ..glass(1e-3) };
    let interaction = Interaction::new(laws, Shape::Sphere).unwrap();
    let hydro = interaction.evaluate(&grain, &sample, [0.0; 3], 1e-3).unwrap();
    let (after, _) = advance(&grain, &hydro, [0.0; 3], 1e-3);
    assert!((after.velocity[0] / (3.0 / 1.2 * 0.7e-3) - 1.0).abs() < 1e-12, "{:?}", after.velocity);
}

/// I = 2/5 m r² of a sphere, 1/2 m r² of a disc.
#[test]
fn a_grain_that_keeps_up_with_an_accelerating_fluid_takes_nothing_and_is_owed_nothing_in_one_pass() {
    let (acceleration, window, radius) = ([2.0, -1.0, 0.5], 2e-3, 1e-3);
    let grain = GrainRow { mass: 998.2 * Shape::Sphere.volume(radius), ..glass(radius) };
    for beta in [0.0, 1e-3, 10.0] {
        let sample = SampleRow { acceleration, ..water() };
        let hydro =
            HydroRow { exchange_coefficient: beta, added_mass: 0.5 * grain.mass, ..HydroRow::default() };
        let velocity = acceleration.map(|a| a * window);
        // Its drag is that of the fluid at the start, from which it leaves.
        let drag = velocity.map(|v| -0.5 * beta * v * window);
        let (after, impulse) = (GrainRow { velocity, ..grain }, ImpulseRow { drag, other: [0.0; 3] });
        let passage =
            Passage { before: &grain, after: &after, sample: &sample, hydro: &hydro, impulse: &impulse };
        let reaction = compliant_reaction(&passage, Shape::Sphere, window);
        for k in 0..3 {
            let given = reaction.exchange_coefficient * (velocity[k] - reaction.target_velocity[k]) * window;
            // What the drag lags behind within a window; nothing without drag.
            let lag = beta * velocity[k] * window;
            assert!((given - drag[k]).abs() <= lag.abs() + 1e-12 * grain.mass * velocity[k].abs(), "{given}");
        }
    }
}

#[test]
fn in_a_long_window_grains_take_half_the_vorticity_as_their_spin() {
    let sample = SampleRow { vorticity: [0.0, 0.0, 8.0], ..water() };
    for (drag, shape, factor) in
        [(Drag::Stokes, Shape::Sphere, 0.4), (Drag::DiFeliceCylinder, Shape::Disc { depth: 0.2 }, 0.5)]
    {
        let interaction = Interaction::new(Laws { drag, ..STOKES }, shape).unwrap();
        let grain = GrainRow { angular_velocity: [0.0, 0.0, -3.0], ..glass(1e-3) };
        let hydro = interaction.evaluate(&grain, &sample, [0.0; 3], 1e4).unwrap();
        let spin = -3.0 + hydro.torque[2] * 1e4 / (factor * grain.mass * 1e-6);
        assert!((spin - 4.0).abs() < 1e-12, "{shape}: {spin}");
    }
}

#[test]
fn outside_the_fluid_nothing_acts_but_what_is_owed() {
    let interaction = Interaction::new(Laws { added_mass: 0.5, ..STOKES }, Shape::Sphere).unwrap();
    let grain = GrainRow { velocity: [1.0, 2.0, 3.0], ..glass(1e-3) };
    let hydro = interaction.evaluate(&grain, &SampleRow::default(), [4e-9, 0.0, -1e-9], 0.5).unwrap();
    assert_eq!((hydro.force, hydro.torque), ([8e-9, 0.0, -2e-9], [0.0; 3]));
    assert_eq!((hydro.exchange_coefficient, hydro.added_mass), (0.0, 0.0));
    let still = SampleRow { velocity: grain.velocity, ..water() };
    let inside = interaction.evaluate(&grain, &still, [4e-9, 0.0, -1e-9], 0.5).unwrap();
    assert_eq!(inside.force, [8e-9, 0.0, -2e-9]);
}

#[test]
fn laws_of_spheres_are_refused_for_discs_and_the_other_way_round() {
    let disc = Shape::Disc { depth: 1.0 };
    let refused = Interaction::new(Laws { drag: Drag::DiFelice, ..STOKES }, disc).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "coupling.drag: the law \"di-felice\" is fitted to spheres (3D), the grains are discs (2D); \
         allowed: none, di-felice-cylinder; choose one of them"
    );
    assert!(Interaction::new(Laws { drag: Drag::DiFeliceCylinder, ..STOKES }, Shape::Sphere).is_err());
    assert!(Interaction::new(Laws { drag: Drag::DiFeliceCylinder, ..STOKES }, disc).is_ok());
    assert!(Interaction::new(Laws { added_mass: f64::NAN, ..STOKES }, Shape::Sphere).is_err());
    assert!(Interaction::new(Laws { added_mass: -0.5, ..STOKES }, Shape::Sphere).is_err());
}

#[test]
fn the_fluid_acts_on_a_grain_by_its_wetted_fraction() {
    let laws = Laws { drag: Drag::SchillerNaumann, added_mass: 0.5, self_disturbance: false };
    let interaction = Interaction::new(laws, Shape::Sphere).unwrap();
    let spinning = GrainRow { angular_velocity: [0.0, 0.0, 30.0], ..glass(1e-3) };
    let wet = SampleRow {
        velocity: [0.1, 0.0, 0.0],
        pressure_gradient: [0.0, 0.0, -9.81 * 998.2],
        viscous_stress_divergence: [3.0, 0.0, 0.0],
        acceleration: [0.0, 2.0, 0.0],
        ..water()
    };
    let acted = |wetted_fraction: f64| {
        let sample = SampleRow { wetted_fraction, ..wet };
        interaction.evaluate(&spinning, &sample, [0.0; 3], 1e-6).unwrap()
    };
    let (whole, part) = (acted(1.0), acted(0.3));
    assert!((0..3).all(|k| whole.force[k] != 0.0) && whole.torque[2] != 0.0);
    let scaled = |part: f64, whole: f64| (part - 0.3 * whole).abs() <= 1e-14 * whole.abs();
    assert!((0..3).all(|k| scaled(part.force[k], whole.force[k])), "{part:?} {whole:?}");
    assert!(scaled(part.exchange_coefficient, whole.exchange_coefficient));
    assert!(scaled(part.added_mass, whole.added_mass));
    // The implicit torque of a short window is the rate times the window, less the square of it.
    assert!((part.torque[2] / whole.torque[2] - 0.3).abs() < 1e-5);
}

#[test]
fn what_no_law_is_made_for_is_refused_by_name() {
    let interaction = Interaction::new(STOKES, Shape::Sphere).unwrap();
    let refused =
        |grain: GrainRow, sample: SampleRow| match interaction.evaluate(&grain, &sample, [0.0; 3], 1e-3) {
            Err(InteractionError::OutOfRange { grain: 7, quantity, .. }) => quantity,
            other => panic!("{other:?}"),
        };
    assert_eq!(refused(glass(1e-3), SampleRow { void_fraction: 0.0, ..water() }), "void fraction");
    assert_eq!(refused(glass(1e-3), SampleRow { void_fraction: 1.01, ..water() }), "void fraction");
    assert_eq!(refused(glass(1e-3), SampleRow { viscosity: 0.0, ..water() }), "fluid viscosity");
    assert_eq!(refused(glass(1e-3), SampleRow { density: f64::NAN, ..water() }), "fluid density");
    assert_eq!(refused(glass(1e-3), SampleRow { wetted_fraction: 1.1, ..water() }), "wetted fraction");
    assert_eq!(refused(glass(1e-3), SampleRow { kernel_width: 0.0, ..water() }), "kernel width");
    assert_eq!(refused(glass(1e-3), SampleRow { own_share: f64::NAN, ..water() }), "own share");
    assert_eq!(refused(glass(0.0), water()), "radius");
    assert_eq!(refused(GrainRow { mass: 0.0, ..glass(1e-3) }, water()), "mass");
    let stormy = SampleRow { velocity: [f64::NAN, 0.0, 0.0], ..water() };
    assert_eq!(refused(glass(1e-3), stormy), "fluid velocity");
}

#[test]
fn a_grain_that_disturbs_its_sample_too_much_is_named() {
    let interaction = Interaction::new(Laws { self_disturbance: true, ..STOKES }, Shape::Sphere).unwrap();
    let sample = SampleRow { kernel_width: 1e-3, void_fraction: 0.99, own_share: 0.01, ..water() };
    let error = interaction.evaluate(&glass(1e-3), &sample, [0.0; 3], 1e-3).unwrap_err();
    let message = error.to_string();
    assert!(message.starts_with("grain 7: its own force takes 0.56"), "{message}");
    assert!(message.contains("coupling.self-disturbance = false"), "{message}");
}

#[test]
fn a_frozen_grain_gives_the_fluid_all_its_drag() {
    let interaction = Interaction::new(STOKES, Shape::Sphere).unwrap();
    let grain = GrainRow { mass: f64::INFINITY, ..glass(1e-3) };
    let sample = SampleRow { velocity: [0.2, 0.0, 0.0], ..water() };
    let hydro = interaction.evaluate(&grain, &sample, [0.0; 3], 1e-3).unwrap();
    let drag = sample.velocity.map(|u| hydro.exchange_coefficient * u * 1e-3);
    let impulse = ImpulseRow { drag, other: [0.0; 3] };
    let passage =
        Passage { before: &grain, after: &grain, sample: &sample, hydro: &hydro, impulse: &impulse };
    let row = reaction(&passage, 1e-3);
    assert_eq!(row.exchange_coefficient, hydro.exchange_coefficient);
    assert!(row.target_velocity[0].abs() < 1e-16, "{row:?}");
}
