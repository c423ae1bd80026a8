//! The conservative, implicit exchange of momentum between a grain and the fluid over a window.
//!
//! With β, u and F_o constant in a window Δt, (m + m_A) v' = F_o + β(u − v) relaxes exponentially; F_o is the mean of
//! all other forces, m_A Du/Dt among them. In x = βΔt/(m + m_A), E = e^−x:
//!
//! - mean drag coefficient β(1 − E)/x, seen from v* = v0 + (F_o Δt/(m + m_A)) \[1/(1 − E) − 1/x\];
//! - the grain takes from the fluid X = J + m_A(Du/Dt Δt − Δv), J the drag impulse;
//! - when u changes by δu over the window, X/Δt changes by β_e δu, **β_e = m/(m + m_A)·(β + m_A/Δt)·(1 − E)/x**.
//!
//! So the fluid is given the force −β_e(u − v*) with v* = u_f − X/(β_e Δt): it gets −X when u is the u_f that the grain
//! felt, and resists change as the grain would. When F_o changes by δF, X changes by −R δF Δt, **R = 1 − m/(m + m_A)·(1 − E)/x**:
//! that share of a force on the grain goes on to the fluid within the window. Stable for every x and every ratio of densities; conserved to round-off
//! with what the fluid gives beyond X carried into the grain's next window. (Handed back to the fluid it would undo the
//! implicit step: velocities then overshoot, by 70 % where the grains outweigh the fluid.) x → 0 is the explicit exchange, one step of x ≪ 1 the implicit Euler one.

use std::array::from_fn;

/// Exponential relaxation over x = βΔt/m; every member is accurate to round-off for x in \[0, ∞\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relaxation {
    /// E = e^−x \[-\]: what is left of a slip.
    pub decay: f64,
    /// (1 − E)/x \[-\]: mean of the slip over the window; 1 at x = 0.
    pub mean: f64,
    /// 1/(1 − E) − 1/x \[-\]: when, in parts of the window, a constant force has to act at once to give the same
    /// impulse; 1/2 at x = 0, 1 at x → ∞.
    pub bracket: f64,
}

/// Below, the bracket's difference would lose digits and its series does not.
const SERIES: f64 = 0.5;

impl Relaxation {
    /// The relaxation over x ≥ 0 \[-\].
    pub fn over(x: f64) -> Relaxation {
        let lost = -(-x).exp_m1();
        let mean = if x == 0.0 { 1.0 } else { lost / x };
        let bracket = if x < SERIES { bracket_series(x) } else { 1.0 / lost - 1.0 / x };
        Relaxation { decay: (-x).exp(), mean, bracket }
    }
}

/// 1/(1 − e^−x) − 1/x = 1/2 + Σ B_2n x^(2n−1)/(2n)!, to x¹¹ (Abramowitz & Stegun 1964, 23.1.1).
fn bracket_series(x: f64) -> f64 {
    const BERNOULLI: [f64; 6] = [
        1.0 / 12.0,
        -1.0 / 720.0,
        1.0 / 30_240.0,
        -1.0 / 1_209_600.0,
        1.0 / 47_900_160.0,
        -691.0 / 1_307_674_368_000.0,
    ];
    let square = x * x;
    0.5 + x * BERNOULLI.iter().rev().fold(0.0, |sum, coefficient| sum * square + coefficient)
}

/// Velocity v* = v0 + (F_o Δt/m)·bracket \[m/s\] that the mean drag β(1 − E)/x·(u − v*) is seen from, x = βΔt/m; `inertia`
/// is m + m_A.
pub fn target_velocity(
    velocity: [f64; 3],
    other_force: [f64; 3],
    inertia: f64,
    exchange_coefficient: f64,
    window: f64,
) -> [f64; 3] {
    let bracket = Relaxation::over(exchange_coefficient * window / inertia).bracket;
    from_fn(|k| velocity[k] + other_force[k] * window / inertia * bracket)
}

/// β_e = m/(m + m_A)·(β + m_A/Δt)·(1 − E)/x \[kg/s\]; of a grain that does not move (m = ∞) β + m_A/Δt.
pub fn effective_exchange_coefficient(
    mass: f64,
    added_mass: f64,
    exchange_coefficient: f64,
    window: f64,
) -> f64 {
    kept_share(mass, added_mass, exchange_coefficient, window) * (exchange_coefficient + added_mass / window)
}

/// m/(m + m_A)·(1 − E)/x \[-\]: what a grain keeps, as its own momentum, of a constant force that acts through the window.
/// The rest, R, it hands on to the fluid by drag and added mass; a grain that does not move (m = ∞) hands on nothing.
pub fn kept_share(mass: f64, added_mass: f64, exchange_coefficient: f64, window: f64) -> f64 {
    let mobile = 1.0 / (1.0 + added_mass / mass);
    mobile * Relaxation::over(exchange_coefficient * window / (mass + added_mass)).mean
}

/// Impulse X = J + m_A(Du/Dt Δt − Δv) \[N s\] that the grain took from the fluid by drag and added mass.
pub fn impulse_taken(
    drag_impulse: [f64; 3],
    added_mass: f64,
    fluid_acceleration: [f64; 3],
    velocity_change: [f64; 3],
    window: f64,
) -> [f64; 3] {
    from_fn(|k| drag_impulse[k] + added_mass * (fluid_acceleration[k] * window - velocity_change[k]))
}

/// v* = u_f − X/(β_e Δt) \[m/s\]: −β_e(u_f − v*)Δt = −X. With β_e = 0 nothing is exchanged and v* is u_f.
pub fn target_velocity_from_impulse(
    fluid_velocity: [f64; 3],
    impulse: [f64; 3],
    effective_coefficient: f64,
    window: f64,
) -> [f64; 3] {
    if effective_coefficient == 0.0 {
        return fluid_velocity;
    }
    from_fn(|k| fluid_velocity[k] - impulse[k] / (effective_coefficient * window))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x, e^−x, (1 − e^−x)/x, 1/(1 − e^−x) − 1/x from 700-digit arithmetic.
    const EXACT: [(f64, f64, f64, f64); 25] = [
        (1e-300, 1.0, 1.0, 0.5),
        (1e-16, 0.9999999999999999, 1.0, 0.5),
        (1e-9, 0.999999999, 0.9999999995, 0.5000000000833333),
        (1e-4, 0.9999000049998333, 0.999950001666625, 0.500008333333332),
        (0.001, 0.999000499833375, 0.9995001666250083, 0.5000833333319444),
        (0.01, 0.9900498337491681, 0.9950166250831947, 0.5008333319444478),
        (0.0101, 0.9899508337158773, 0.9949669588240295, 0.5008416652356965),
        (0.1, 0.9048374180359596, 0.9516258196404043, 0.5083319447750496),
        (0.3, 0.7408182206817179, 0.8639392643942738, 0.5249625801767492),
        (0.49, 0.6126263941844161, 0.7905583792154774, 0.5406708604825053),
        (0.5, 0.6065306597126334, 0.7869386805747332, 0.5414940825367983),
        (0.51, 0.6004955788122659, 0.7833420023288903, 0.5423168960858592),
        (0.75, 0.4723665527410147, 0.7035112630119804, 0.5619218010690101),
        (1.0, 0.36787944117144233, 0.6321205588285577, 0.5819767068693265),
        (2.0, 0.1353352832366127, 0.43233235838169365, 0.6565176427496656),
        (5.0, 0.006737946999085467, 0.1986524106001829, 0.8067836549063042),
        (10.0, 4.5399929762484854e-05, 0.09999546000702375, 0.9000454019910097),
        (36.0, 2.3195228302435696e-16, 0.027777777777777773, 0.9722222222222224),
        (40.0, 4.248354255291589e-18, 0.025, 0.975),
        (100.0, 3.720075976020836e-44, 0.01, 0.99),
        (1e4, 0.0, 0.0001, 0.9999),
        (1e8, 0.0, 1e-08, 0.99999999),
        (1e16, 0.0, 1e-16, 0.9999999999999999),
        (1e100, 0.0, 1e-100, 1.0),
        (1e300, 0.0, 1e-300, 1.0),
    ];

    #[test]
    fn relaxation_is_exact_from_1e_minus_300_to_1e300() {
        for (x, decay, mean, bracket) in EXACT {
            let found = Relaxation::over(x);
            assert!((found.decay - decay).abs() <= 1e-14 * decay, "decay at {x}: {}", found.decay);
            assert!((found.mean / mean - 1.0).abs() <= 1e-14, "mean at {x}: {}", found.mean);
            assert!((found.bracket / bracket - 1.0).abs() <= 1e-14, "bracket at {x}: {}", found.bracket);
        }
        assert_eq!(Relaxation::over(0.0), Relaxation { decay: 1.0, mean: 1.0, bracket: 0.5 });
        assert_eq!(Relaxation::over(f64::INFINITY), Relaxation { decay: 0.0, mean: 0.0, bracket: 1.0 });
        assert!(Relaxation::over(f64::NAN).mean.is_nan());
    }

    /// v1 = u + (v0 − u)E + (F_o/β)(1 − E), Δv = (J + F_o Δt)/m, J = β(1 − E)/x (u − v*)Δt.
    #[test]
    fn mean_drag_from_the_target_velocity_is_the_exact_impulse() {
        let (v0, u, other, mass) = (0.3, -1.1, 2.0e-3, 7e-4);
        for x in [1e-9, 1e-3, 0.4, 3.0, 60.0, 1e7] {
            let window = 2e-3;
            let beta = x * mass / window;
            let decay = Relaxation::over(x).decay;
            let v1 = u + (v0 - u) * decay - other / beta * (-x).exp_m1();
            let exact = mass * (v1 - v0) - other * window;
            let target = target_velocity([v0; 3], [other; 3], mass, beta, window);
            let found = effective_exchange_coefficient(mass, 0.0, beta, window) * (u - target[0]) * window;
            let scale = mass * (u - v0).abs();
            assert!((found - exact).abs() < 1e-14 * scale, "x = {x}: {found} {exact}");
            let back =
                target_velocity_from_impulse([u; 3], [found; 3], beta * Relaxation::over(x).mean, window);
            assert!((back[1] - target[1]).abs() < 1e-12 * (u - v0).abs(), "x = {x}");
        }
    }

    #[test]
    fn nothing_is_exchanged_without_drag_and_added_mass() {
        assert_eq!(effective_exchange_coefficient(1.0, 0.0, 0.0, 1e-3), 0.0);
        assert_eq!(target_velocity_from_impulse([1.0, 2.0, 3.0], [0.0; 3], 0.0, 1e-3), [1.0, 2.0, 3.0]);
    }

    #[test]
    fn a_grain_that_does_not_move_resists_with_all_its_drag() {
        assert_eq!(effective_exchange_coefficient(f64::INFINITY, 2e-3, 5.0, 1e-3), 5.0 + 2e-3 / 1e-3);
    }

    /// The share kept against the change of the impulse that the grain takes when a constant force is added.
    #[test]
    fn what_a_grain_does_not_keep_of_a_force_it_hands_on() {
        let (mass, window, v0, u) = (2e-4, 1e-3, 0.4, -0.2);
        for (added, x) in [(0.0, 1e-6), (0.0, 0.7), (6e-4, 0.7), (3e-2, 5.0), (1e-5, 1e4)] {
            let inertia = mass + added;
            let beta = x * inertia / window;
            let taken = |other: f64| {
                let target = target_velocity([v0; 3], [other; 3], inertia, beta, window)[0];
                let drag = beta * Relaxation::over(x).mean * (u - target) * window;
                let change = (drag + other * window) / inertia;
                impulse_taken([drag; 3], added, [0.0; 3], [change; 3], window)[0]
            };
            let handed_on = (taken(0.0) - taken(1.0)) / window;
            let kept = kept_share(mass, added, beta, window);
            assert!((handed_on + kept - 1.0).abs() < 1e-11, "{added} {x}: {handed_on} {kept}");
        }
        assert_eq!(kept_share(f64::INFINITY, 1.0, 5.0, window), 1.0);
    }

    /// β_e against the change of the impulse that the grain really takes, by exact integration at u and at u + δ.
    #[test]
    fn the_effective_coefficient_is_the_grains_response() {
        let (mass, window, v0, u0, gravity) = (2e-4, 1e-3, 0.4, -0.2, -1.7e-3);
        for (added, x) in [(0.0, 0.7), (6e-4, 1e-6), (6e-4, 0.7), (3e-2, 5.0), (1e-5, 1e4)] {
            let inertia = mass + added;
            let beta = x * inertia / window;
            let taken = |u: f64| {
                let acceleration = (u - u0) / window;
                let other = gravity + added * acceleration;
                let target = target_velocity([v0; 3], [other; 3], inertia, beta, window)[0];
                let drag = beta * Relaxation::over(x).mean * (u - target) * window;
                let change = (drag + other * window) / inertia;
                impulse_taken([drag; 3], added, [acceleration; 3], [change; 3], window)[0]
            };
            let response = (taken(1.0) - taken(0.0)) / window;
            let found = effective_exchange_coefficient(mass, added, beta, window);
            assert!((found / response - 1.0).abs() < 1e-11, "{added} {x}: {found} {response}");
        }
    }
}
