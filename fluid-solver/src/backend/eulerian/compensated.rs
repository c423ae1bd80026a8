//! Sums of many terms of one sign, which lose digits one by one otherwise.

/// A sum that carries its own rounding error (Neumaier 1974): accurate to round-off for any number of terms.
#[derive(Debug, Clone, Copy, Default)]
pub struct CompensatedSum {
    sum: f64,
    lost: f64,
}

impl CompensatedSum {
    /// Adds a term.
    pub fn add(&mut self, term: f64) {
        let sum = self.sum + term;
        self.lost +=
            if self.sum.abs() >= term.abs() { (self.sum - sum) + term } else { (term - sum) + self.sum };
        self.sum = sum;
    }

    /// The sum.
    pub fn value(self) -> f64 {
        self.sum + self.lost
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_equal_terms_keep_all_digits() {
        let mut sum = CompensatedSum::default();
        (0..1_000_000).for_each(|_| sum.add(0.1));
        assert_eq!(sum.value(), 100_000.0);
        let naive: f64 = (0..1_000_000).map(|_| 0.1).sum();
        assert!((naive - 100_000.0).abs() > 1e-7, "the plain sum does not");
    }
}
