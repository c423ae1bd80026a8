//! Quadrature on simplices.

/// Barycentric points of the rule of degree 2 with `N = D + 1` points of equal weight `V / N`.
///
/// Point `i` has `λ_i = 1 - D b` and `λ_j = b` elsewhere, `b = (1 - 1/√(D + 2)) / (D + 1)`: the three points
/// `(2/3, 1/6, 1/6)` of the triangle and the four points `(0.585…, 0.138…, …)` of the tetrahedron
/// (Hammer & Stroud, Math. Tables Aids Comput. 10 (1956) 137).
pub fn degree_2<const D: usize, const N: usize>() -> [[f64; N]; N] {
    const { assert!(N == D + 1) };
    let b = (1.0 - 1.0 / (D as f64 + 2.0).sqrt()) / N as f64;
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 1.0 - D as f64 * b } else { b }))
}

/// Barycentric points and weights (sum one) of the Grundmann–Möller rule of degree 5, for error norms.
///
/// Some weights are negative (SIAM J. Numer. Anal. 15 (1978) 282, with s = 2).
pub fn degree_5<const D: usize, const N: usize>() -> Vec<([f64; N], f64)> {
    const { assert!(N == D + 1) };
    const S: usize = 2;
    let factorial = |n: usize| (1..=n).map(|k| k as f64).product::<f64>();
    let mut rule = Vec::new();
    for i in 0..=S {
        let sum = D + 2 * S + 1;
        let denominator = (sum - 2 * i) as f64;
        let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
        let weight = sign * factorial(D) * denominator.powi(2 * S as i32 + 1)
            / (16.0 * factorial(i) * factorial(sum - i));
        for beta in compositions::<N>(S - i) {
            rule.push((beta.map(|b| (2 * b + 1) as f64 / denominator), weight));
        }
    }
    rule
}

/// All ways to write `total` as a sum of `N` non-negative integers.
fn compositions<const N: usize>(total: usize) -> Vec<[usize; N]> {
    let base = total + 1;
    (0..base.pow(N as u32))
        .map(|code| std::array::from_fn(|k| code / base.pow(k as u32) % base))
        .filter(|parts: &[usize; N]| parts.iter().sum::<usize>() == total)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean of `Π λ_k^{e_k}` over a simplex: `D! Π e_k! / (D + Σ e_k)!`.
    fn exact_mean<const N: usize>(exponents: &[usize; N]) -> f64 {
        let factorial = |n: usize| (1..=n).map(|k| k as f64).product::<f64>();
        let degree: usize = exponents.iter().sum();
        factorial(N - 1) * exponents.iter().map(|&e| factorial(e)).product::<f64>()
            / factorial(N - 1 + degree)
    }

    fn error<const N: usize>(rule: &[([f64; N], f64)], degree: usize) -> f64 {
        let monomial =
            |point: &[f64; N], e: &[usize; N]| (0..N).map(|k| point[k].powi(e[k] as i32)).product::<f64>();
        compositions::<N>(degree)
            .iter()
            .map(|e| rule.iter().map(|(p, w)| w * monomial(p, e)).sum::<f64>() - exact_mean(e))
            .fold(0.0, |worst, e| e.abs().max(worst))
    }

    fn rule_2<const D: usize, const N: usize>() -> Vec<([f64; N], f64)> {
        degree_2::<D, N>().map(|p| (p, 1.0 / N as f64)).to_vec()
    }

    #[test]
    fn the_rules_are_exact_up_to_their_degree_and_not_above() {
        for degree in 0..=2 {
            assert!(error(&rule_2::<2, 3>(), degree) < 1e-15);
            assert!(error(&rule_2::<3, 4>(), degree) < 1e-15);
        }
        assert!(error(&rule_2::<2, 3>(), 3) > 1e-4);
        assert!(error(&rule_2::<3, 4>(), 3) > 1e-4);
        for degree in 0..=5 {
            assert!(error(&degree_5::<2, 3>(), degree) < 1e-14);
            assert!(error(&degree_5::<3, 4>(), degree) < 1e-14);
        }
        assert!(error(&degree_5::<2, 3>(), 6) > 1e-5);
        assert!(error(&degree_5::<3, 4>(), 6) > 1e-5);
    }
}
