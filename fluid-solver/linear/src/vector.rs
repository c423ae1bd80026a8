//! Vector operations with the same bits for any number of threads.

use crate::parallel::for_each_chunk;

/// Entries summed in one go, with four running sums.
const CHUNK: usize = 4096;
/// Length from which a sum is worth a second thread.
const PARALLEL: usize = 8 * CHUNK;

/// a·b = Σᵢ aᵢ bᵢ.
///
/// Chunks of fixed length are joined in index order by a balanced tree, so the rounding error grows with log n.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len(), "dot product of vectors of different length");
    if a.len() <= CHUNK {
        return dot_chunk(a, b);
    }
    let middle = (a.len() / 2).next_multiple_of(CHUNK);
    let ((a0, a1), (b0, b1)) = (a.split_at(middle), b.split_at(middle));
    let (left, right) = join(a.len(), || dot(a0, b0), || dot(a1, b1));
    left + right
}

fn dot_chunk(a: &[f64], b: &[f64]) -> f64 {
    let (a4, a_rest) = a.as_chunks::<4>();
    let (b4, b_rest) = b.as_chunks::<4>();
    let mut sums = [0.0; 4];
    for (a, b) in a4.iter().zip(b4) {
        for k in 0..4 {
            sums[k] += a[k] * b[k];
        }
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// Euclidean norm √(a·a), also where the squares underflow or overflow.
pub fn norm(a: &[f64]) -> f64 {
    let square = dot(a, a);
    if square.is_normal() {
        return square.sqrt();
    }
    let largest = a.iter().fold(0.0, |max: f64, a| max.max(a.abs()));
    if largest > 0.0 && largest.is_finite() {
        let scaled: f64 = a.iter().map(|a| (a / largest) * (a / largest)).sum();
        largest * scaled.sqrt()
    } else {
        square.sqrt()
    }
}

/// Σᵢ aᵢ, joined like [`dot`].
pub fn sum(a: &[f64]) -> f64 {
    if a.len() <= CHUNK {
        return a.iter().sum();
    }
    let (left, right) = a.split_at((a.len() / 2).next_multiple_of(CHUNK));
    let (left, right) = join(a.len(), || sum(left), || sum(right));
    left + right
}

fn join(length: usize, left: impl FnOnce() -> f64 + Send, right: impl FnOnce() -> f64 + Send) -> (f64, f64) {
    if length >= PARALLEL { rayon::join(left, right) } else { (left(), right()) }
}

/// y ← y + αx.
pub fn axpy(alpha: f64, x: &[f64], y: &mut [f64]) {
    update(x, y, |x, y| y + alpha * x);
}

/// y ← x + βy.
pub fn xpby(x: &[f64], beta: f64, y: &mut [f64]) {
    update(x, y, |x, y| x + beta * y);
}

/// y ← αy.
pub fn scale(alpha: f64, y: &mut [f64]) {
    for_each_chunk(y, |_, y| y.iter_mut().for_each(|y| *y *= alpha));
}

/// y ← y − (Σᵢ yᵢ / n) 1: the part of y that is orthogonal to the constants.
pub fn remove_mean(y: &mut [f64]) {
    if y.is_empty() {
        return;
    }
    let mean = sum(y) / y.len() as f64;
    for_each_chunk(y, |_, y| y.iter_mut().for_each(|y| *y -= mean));
}

/// yᵢ ← f(xᵢ, yᵢ).
pub(crate) fn update(x: &[f64], y: &mut [f64], f: impl Fn(f64, f64) -> f64 + Sync + Send) {
    assert_eq!(x.len(), y.len(), "update of a vector by one of different length");
    for_each_chunk(y, |first, y| {
        for (y, x) in y.iter_mut().zip(&x[first..]) {
            *y = f(*x, *y);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(n: usize, pitch: f64) -> Vec<f64> {
        (0..n).map(|i| (i as f64 * pitch).sin()).collect()
    }

    #[test]
    fn dot_agrees_with_the_plain_sum_at_every_length_around_a_chunk() {
        for n in [0, 1, 3, 4, 5, CHUNK - 1, CHUNK, CHUNK + 1, 3 * CHUNK + 7, 2 * PARALLEL + 5] {
            let (a, b) = (wave(n, 0.7), wave(n, 1.3));
            let plain: f64 = a.iter().zip(&b).map(|(a, b)| a * b).sum();
            assert!((dot(&a, &b) - plain).abs() <= 1e-12 * (n as f64 + 1.0), "n = {n}");
        }
    }

    #[test]
    fn sums_have_the_same_bits_for_1_2_and_4_threads() {
        let (a, b) = (wave(300_001, 0.7), wave(300_001, 1.3));
        let bits = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| (dot(&a, &b).to_bits(), sum(&a).to_bits()))
        };
        assert_eq!(bits(1), bits(2));
        assert_eq!(bits(1), bits(4));
    }

    #[test]
    fn updates_are_the_textbook_formulas() {
        let mut y = vec![1.0, 2.0];
        axpy(2.0, &[10.0, 20.0], &mut y);
        assert_eq!(y, [21.0, 42.0]);
        xpby(&[1.0, 1.0], 2.0, &mut y);
        assert_eq!(y, [43.0, 85.0]);
        scale(0.5, &mut y);
        assert_eq!(y, [21.5, 42.5]);
        remove_mean(&mut y);
        assert_eq!(y, [-10.5, 10.5]);
        remove_mean(&mut []);
    }

    #[test]
    fn a_nan_anywhere_reaches_the_norm() {
        let mut a = vec![0.0; 3 * CHUNK];
        a[2 * CHUNK + 1] = f64::NAN;
        assert!(norm(&a).is_nan());
    }

    #[test]
    fn the_norm_neither_underflows_nor_overflows() {
        for scale in [1e-300, 1e-160, 1.0, 1e160, 1e300] {
            let relative = norm(&[3.0 * scale, -4.0 * scale]) / (5.0 * scale);
            assert!((relative - 1.0).abs() < 1e-15, "{scale:e}");
        }
        assert_eq!(norm(&[0.0, -0.0]), 0.0);
        assert_eq!(norm(&[f64::NEG_INFINITY, 1.0]), f64::INFINITY);
    }
}
