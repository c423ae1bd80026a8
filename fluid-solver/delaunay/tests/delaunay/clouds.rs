//! Clouds of points.

/// Pseudo-random numbers in [0, 1) (Knuth's linear congruence).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn below(&mut self, end: usize) -> usize {
        (self.next() * end as f64) as usize
    }
}

pub fn random<const D: usize>(count: usize) -> Vec<[f64; D]> {
    let mut random = Random(1);
    (0..count).map(|_| std::array::from_fn(|_| random.next())).collect()
}

/// `side` points along every axis, displaced by up to `noise` times their distance.
pub fn grid<const D: usize>(side: usize, noise: f64) -> Vec<[f64; D]> {
    let mut random = Random(7);
    let node = |mut index: usize| {
        std::array::from_fn(|_| {
            let step = index % side;
            index /= side;
            (step as f64 + noise * (2.0 * random.next() - 1.0)) / (side - 1) as f64
        })
    };
    (0..side.pow(D as u32)).map(node).collect()
}

/// Points of the unit sphere, as near as rounding lets them be.
pub fn sphere<const D: usize>(count: usize) -> Vec<[f64; D]> {
    let mut random = Random(3);
    let direction = |_| {
        let point: [f64; D] = std::array::from_fn(|_| 2.0 * random.next() - 1.0);
        let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
        point.map(|x| x / length)
    };
    (0..count).map(direction).collect()
}

/// Points on one line, or with `dimensions` 2 on one plane.
pub fn flat<const D: usize>(count: usize, dimensions: usize) -> Vec<[f64; D]> {
    let mut random = Random(5);
    let point = |_| {
        let (s, t) = (random.below(64) as f64, if dimensions == 2 { random.below(64) as f64 } else { 0.0 });
        std::array::from_fn(|k| {
            if k == 0 {
                s
            } else if k == 1 {
                s + t
            } else {
                2.0 * s - t
            }
        })
    };
    (0..count).map(point).collect()
}

/// Groups of points 10⁻¹² apart.
pub fn clusters<const D: usize>(groups: usize, each: usize) -> Vec<[f64; D]> {
    let mut random = Random(9);
    let mut points = vec![];
    for _ in 0..groups {
        let centre: [f64; D] = std::array::from_fn(|_| random.next());
        points.extend((0..each).map(|_| centre.map(|x| x + 1e-12 * random.next())));
    }
    points
}

/// A few points on a small lattice, some of them moved to the next number: as degenerate as can be.
pub fn from_bytes<const D: usize>(bytes: &[u8]) -> Vec<[f64; D]> {
    let coordinate = |byte: &u8| {
        let x = f64::from(byte & 7) * if byte & 64 == 0 { 1.0 } else { 0.1 };
        match byte >> 3 & 7 {
            0 => (x + 1.0).next_up(),
            1 => (x + 1.0).next_down(),
            2 => -x,
            _ => x,
        }
    };
    bytes.chunks_exact(D).map(|chunk| std::array::from_fn(|k| coordinate(&chunk[k]))).collect()
}
