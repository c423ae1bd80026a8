//! Small dense blocks.

/// A dense block, by rows.
pub type Block<const R: usize, const C: usize = R> = [[f64; C]; R];

/// y ← y + A x.
#[inline]
pub fn multiply_add<const R: usize, const C: usize>(a: &Block<R, C>, x: &[f64; C], y: &mut [f64; R]) {
    for (y, row) in y.iter_mut().zip(a) {
        for (a, x) in row.iter().zip(x) {
            *y += a * x;
        }
    }
}

/// A x.
#[inline]
pub fn multiply<const R: usize, const C: usize>(a: &Block<R, C>, x: &[f64; C]) -> [f64; R] {
    let mut y = [0.0; R];
    multiply_add(a, x, &mut y);
    y
}

/// A B.
#[inline]
pub fn product<const R: usize, const K: usize, const C: usize>(
    a: &Block<R, K>,
    b: &Block<K, C>,
) -> Block<R, C> {
    a.map(|row| std::array::from_fn(|j| row.iter().zip(b).map(|(a, b)| a * b[j]).sum()))
}

/// A⁻¹ by Gauss–Jordan elimination with partial pivoting; `None` if A is singular to working precision or not finite.
pub fn inverse<const B: usize>(a: &Block<B>) -> Option<Block<B>> {
    let mut a = *a;
    let mut inverse = [[0.0; B]; B];
    for (i, row) in inverse.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    let scale = a.as_flattened().iter().fold(0.0, |max: f64, v| max.max(v.abs()));
    for k in 0..B {
        let pivot_row = (k..B).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        a.swap(k, pivot_row);
        inverse.swap(k, pivot_row);
        let pivot = a[k][k];
        if !(pivot.is_finite() && pivot.abs() > f64::EPSILON * scale) {
            return None;
        }
        a[k] = a[k].map(|v| v / pivot);
        inverse[k] = inverse[k].map(|v| v / pivot);
        for i in (0..B).filter(|&i| i != k) {
            let factor = a[i][k];
            for j in 0..B {
                a[i][j] -= factor * a[k][j];
                inverse[i][j] -= factor * inverse[k][j];
            }
        }
    }
    inverse.as_flattened().iter().all(|v| v.is_finite()).then_some(inverse)
}

/// A flat vector seen as one array per node.
///
/// # Panics
/// If the length is not a multiple of B.
pub fn by_node<const B: usize>(x: &[f64]) -> &[[f64; B]] {
    let (nodes, rest) = x.as_chunks();
    assert!(rest.is_empty(), "vector length {} is not a multiple of {B}", x.len());
    nodes
}

/// A flat vector seen as one array per node, mutable.
///
/// # Panics
/// If the length is not a multiple of B.
pub fn by_node_mut<const B: usize>(x: &mut [f64]) -> &mut [[f64; B]] {
    let length = x.len();
    let (nodes, rest) = x.as_chunks_mut();
    assert!(rest.is_empty(), "vector length {length} is not a multiple of {B}");
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_times_its_inverse_is_the_identity_even_with_a_zero_in_the_corner() {
        let a = [[0.0, 2.0, 1.0], [1.0, 1e-3, 0.0], [4.0, 0.0, -3.0]];
        let identity = product(&a, &inverse(&a).unwrap());
        for (i, row) in identity.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                assert!((value - f64::from(u8::from(i == j))).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn scale_does_not_matter_but_rank_does() {
        assert_eq!(inverse(&[[1e-200]]), Some([[1e200]]));
        assert_eq!(inverse(&[[1.0, 2.0], [2.0, 4.0]]), None);
        assert_eq!(inverse(&[[0.0]]), None);
        assert_eq!(inverse(&[[f64::NAN]]), None);
        assert_eq!(inverse(&[[f64::INFINITY]]), None);
    }
}
