//! Every set of lanes computes what f64 computes, bit by bit.

use super::{Backend, Kernel, Lanes, Row4, Row8, RowLanes, Vec3};

/// Numbers of all sizes and signs, with zeros.
fn numbers(seed: u64) -> [f64; 8] {
    let mut state = seed;
    std::array::from_fn(|_| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let fraction = (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
        if state >> 61 == 0 { 0.0 } else { fraction * 10_f64.powi((state >> 40) as i32 % 9) }
    })
}

/// Each operation on eight pairs of numbers.
struct Arithmetic([f64; 8], [f64; 8]);

impl Kernel for Arithmetic {
    type Output = (Vec<[f64; 8]>, Vec<u32>);

    #[inline(always)]
    fn run<L: RowLanes>(self) -> Self::Output {
        arithmetic::<L>(&self.0, &self.1)
    }
}

#[inline(always)]
fn arithmetic<L: Lanes>(a: &[f64; 8], b: &[f64; 8]) -> (Vec<[f64; 8]>, Vec<u32>) {
    let (mut found, mut masks) = (vec![[0.0; 8]; 13], vec![0; 2]);
    for lane in (0..8).step_by(L::WIDTH) {
        let (x, y) = (L::load(&a[lane..]), L::load(&b[lane..]));
        let below = x.less(y);
        let both = L::both(below, x.less(L::splat(0.0)));
        let (v, w) = (Vec3::new(x, y, x * y), Vec3::new(y, x + y, x));
        let turned = v.cross(w);
        let results = [
            x + y,
            x - y,
            x * y,
            x / y,
            -x,
            x.max(-x).sqrt(),
            x.round(),
            x.min(y),
            x.max(y),
            L::select(below, x, y),
            y.only(below),
            v.dot(w),
            turned.x + turned.y + turned.z,
        ];
        for (row, result) in found.iter_mut().zip(results) {
            result.store(&mut row[lane..]);
        }
        masks[0] |= L::bits(below) << lane;
        masks[1] |= L::bits(both) << lane;
        assert_eq!(L::any(below), L::bits(below) != 0);
    }
    (found, masks)
}

fn bits(rows: &[[f64; 8]]) -> Vec<u64> {
    // Which of the bit patterns that are not numbers a division makes is left open by the standard.
    rows.iter().flatten().map(|x| if x.is_nan() { u64::MAX } else { x.to_bits() }).collect()
}

#[test]
fn arithmetic_has_the_bits_of_f64() {
    for seed in 0..500 {
        let (a, b) = (numbers(seed), numbers(seed + 1000));
        let (expected, masks) = arithmetic::<f64>(&a, &b);
        for backend in Backend::available() {
            let (found, found_masks) = backend.run(Arithmetic(a, b));
            assert_eq!(bits(&found), bits(&expected), "{}", backend.name());
            assert_eq!(found_masks, masks, "{}", backend.name());
        }
    }
}

/// All that is read from rows and, last, what was added to empty ones.
struct RowWork {
    places: Vec<Row4>,
    motions: Vec<Row8>,
    i: [u32; 8],
    j: [u32; 8],
}

impl Kernel for RowWork {
    type Output = Vec<[f64; 8]>;

    #[inline(always)]
    fn run<L: RowLanes>(self) -> Vec<[f64; 8]> {
        let Self { places, motions, i, j } = self;
        let mut found = vec![[0.0; 8]; 22];
        let mut sums = vec![[Row8::default(); 6]; 3];
        for lane in (0..8).step_by(L::WIDTH) {
            let (i, j) = (&i[lane..], &j[lane..]);
            // SAFETY: all indices are below 6, the number of rows.
            unsafe {
                let [x, y, z, r] = L::columns4(&places, i);
                let apart = L::difference4(&places, i, j);
                let [velocity, spin] = L::columns8(&motions, j);
                let [difference, sum] = L::difference_and_sum8(&motions, i, j);
                let unequal = L::difference_of_second_half(&motions, i, j);
                let vectors = [apart, velocity, spin, difference, sum, unequal];
                let columns = vectors.into_iter().flat_map(|v| [v.x, v.y, v.z]);
                for (row, column) in found.iter_mut().zip([x, y, z, r].into_iter().chain(columns)) {
                    column.store(&mut row[lane..]);
                }
                L::add8(&mut sums[0], i, apart, velocity);
                L::add_opposed8(&mut sums[1], i, j, difference, sum);
                L::add_unequal8(&mut sums[2], i, j, apart, spin, unequal);
            }
        }
        found.into_iter().chain(sums.iter().flatten().map(|row| row.0)).collect()
    }
}

#[test]
fn rows_are_read_and_added_to_with_the_same_bits() {
    for seed in 0..200 {
        let places: Vec<_> = (0..6).map(|k| Row4(*numbers(seed + 31 * k).first_chunk().unwrap())).collect();
        let motions: Vec<_> = (0..6).map(|k| Row8(numbers(seed + 57 * k + 5))).collect();
        // Some rows meet twice and more in a block.
        let index = |k: usize, by: u64| ((seed + by * k as u64) % 6) as u32;
        let (i, j) = (std::array::from_fn(|k| index(k / 3, 1)), std::array::from_fn(|k| index(k, 5)));
        let work = || RowWork { places: places.clone(), motions: motions.clone(), i, j };
        let expected = bits(&Backend::available()[0].run(work()));
        for backend in Backend::available() {
            assert_eq!(bits(&backend.run(work())), expected, "{}", backend.name());
        }
    }
}
