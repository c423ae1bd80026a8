//! Viscous damping from restitution, for contacts that never pull.

/// Restitution e of a damped contact that ends when its force vanishes.
///
/// A linear spring and dashpot of damping ratio ζ = c/(2 √(k m*)) in parallel, cut off where k δ + c δ' = 0:
///
/// e = exp(-2 ζ arccos ζ / √(1 - ζ²)),  for ζ > 1: e = exp(-2 ζ arcosh ζ / √(ζ² - 1)).
///
/// The same holds for Hertz's spring with c ∝ δ^(1/4): with y = √(2 U(δ)/…) ∝ δ^(5/4) as coordinate and
/// dτ ∝ δ^(1/4) dt as time its motion is that of the linear contact, and the force vanishes at the same place.
///
/// Source: Schwager & Pöschel, Granular Matter 9 (2007) 465–469, Eq. 15 (their three branches are one in ζ);
/// Antypov & Elliott, EPL 94 (2011) 50004, for the transformation.
pub fn restitution(damping_ratio: f64) -> f64 {
    let zeta = damping_ratio;
    let angle_by_sine = if (zeta - 1.0).abs() < 1e-12 {
        1.0
    } else if zeta < 1.0 {
        zeta.acos() / (1.0 - zeta * zeta).sqrt()
    } else {
        zeta.acosh() / (zeta * zeta - 1.0).sqrt()
    };
    (-2.0 * zeta * angle_by_sine).exp()
}

/// The damping ratio ζ whose restitution is e, for e in (0, 1]; by bisection, since e falls steadily with ζ.
pub fn damping_ratio(e: f64) -> f64 {
    if e >= 1.0 {
        return 0.0;
    }
    let mut upper = 1.0;
    while restitution(upper) > e {
        upper *= 2.0;
    }
    let mut lower = 0.0;
    for _ in 0..100 {
        let middle = 0.5 * (lower + upper);
        if restitution(middle) > e { lower = middle } else { upper = middle }
    }
    0.5 * (lower + upper)
}

/// The damping ratio ζ = -ln e/√(ln² e + π²) of a contact that may pull until its overlap vanishes.
pub fn pulling_damping_ratio(e: f64) -> f64 {
    let log = e.ln();
    -log / log.hypot(std::f64::consts::PI)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn damping_ratio_inverts_restitution() {
        for e in [1e-6, 1e-3, 0.05, (-2.0_f64).exp(), 0.3, 0.7, 0.99, 1.0 - 1e-9, 1.0] {
            assert!((restitution(damping_ratio(e)) - e).abs() < 1e-13, "e = {e}");
        }
    }

    #[test]
    fn light_damping_agrees_with_the_contact_that_may_pull() {
        // Without the cut-off e = exp(-π ζ/√(1 - ζ²)); the cut-off matters at second order in ζ.
        let zeta = 1e-4_f64;
        let may_pull = (-std::f64::consts::PI * zeta).exp();
        assert!((restitution(zeta) - may_pull).abs() < 3.0 * zeta * zeta);
    }
}
