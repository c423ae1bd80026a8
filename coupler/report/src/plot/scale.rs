//! Linear or logarithmic.

/// How values are laid out along the vertical axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scale {
    Linear,
    Logarithmic,
}

impl Scale {
    /// Residuals want a logarithmic scale once they span a factor of 30; anything negative forbids it.
    pub(crate) fn for_residuals(values: impl Iterator<Item = f64> + Clone) -> Self {
        let finite = values.filter(|value| value.is_finite());
        if finite.clone().any(|value| value < 0.0) {
            return Self::Linear;
        }
        let positive = finite.filter(|&value| value > 0.0);
        let smallest = positive.clone().fold(f64::INFINITY, f64::min);
        let largest = positive.fold(0.0, f64::max);
        if largest > 30.0 * smallest { Self::Logarithmic } else { Self::Linear }
    }

    /// Where a value stands; zero has no place on a logarithmic scale.
    pub(crate) fn place(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Logarithmic if value > 0.0 => value.log10(),
            Self::Logarithmic => f64::NAN,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_positive_values_over_more_than_a_decade_are_logarithmic() {
        let scale = |values: &[f64]| Scale::for_residuals(values.iter().copied());
        assert_eq!(scale(&[1e-12, 1e-3, 0.0, f64::NAN]), Scale::Logarithmic);
        assert_eq!(scale(&[1.0, 2.0]), Scale::Linear);
        assert_eq!(scale(&[-1.0, 1e-9, 2.0]), Scale::Linear);
        assert_eq!(scale(&[]), Scale::Linear);
        assert_eq!(scale(&[0.0, 1.0]), Scale::Linear);
    }
}
