//! Round numbers along an axis.

use crate::page::number;

/// Where the ticks of an axis stand and what they say.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axis {
    /// Place and label.
    pub(crate) ticks: Vec<(f64, String)>,
    /// The labels are in units of 10 to this power, a multiple of 3.
    pub(crate) exponent: i32,
}

impl Axis {
    /// About `wanted` ticks at multiples of 1, 2 or 5 times a power of ten, within `low` to `high`.
    pub(crate) fn linear(low: f64, high: f64, wanted: usize) -> Self {
        let largest = low.abs().max(high.abs());
        let span = high - low;
        if !(span.is_finite() && span > 0.0 && largest.is_normal()) {
            return Self { ticks: Vec::new(), exponent: 0 };
        }
        let exponent =
            if (1e-2..1e4).contains(&largest) { 0 } else { 3 * (largest.log10() / 3.0).floor() as i32 };
        let step = round_step(span / wanted.max(1) as f64);
        let decimals = ((f64::from(exponent) - step.log10()).ceil().clamp(0.0, 9.0)) as usize;
        let first = (low / step).ceil();
        let count = ((high / step + 1e-9).floor() - first) as usize;
        let ticks = (0..=count.min(4 * wanted + 4))
            .map(|k| {
                let multiple = first + k as f64;
                let value = multiple * step;
                // A sum with zero turns −0 into 0.
                (value, format!("{:.decimals$}", value / 10f64.powi(exponent) + 0.0))
            })
            .collect();
        Self { ticks, exponent }
    }

    /// Ticks at whole powers of ten, and within two decades at 2 and 5 times these; `low` and `high` are logarithms, and so are the
    /// places.
    pub(crate) fn logarithmic(low: f64, high: f64, wanted: usize) -> Self {
        let (first, last) = (low.ceil() as i32, high.floor() as i32);
        if high - low < 2.0 {
            let factors = || [1.0, 2.0, 5.0].into_iter();
            let ticks = (first - 1..=last)
                .flat_map(|decade| factors().map(move |factor: f64| (decade, factor)))
                .map(|(decade, factor)| (f64::from(decade) + factor.log10(), factor * 10f64.powi(decade)))
                .filter(|(place, _)| (low..=high).contains(place))
                .map(|(place, value)| (place, number(value)))
                .collect();
            return Self { ticks, exponent: 0 };
        }
        let stride = ((last - first) / wanted.max(1) as i32).max(0) + 1;
        let ticks = (first..=last)
            .filter(|decade| decade % stride == 0)
            .map(|decade| (f64::from(decade), format!("10{}", superscript(decade))))
            .collect();
        Self { ticks, exponent: 0 }
    }
}

/// The smallest of 1, 2, 5 times a power of ten that is not below `step`.
fn round_step(step: f64) -> f64 {
    let power = 10f64.powf(step.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|factor| factor * power)
        .find(|&round| round >= step * (1.0 - 1e-9))
        .unwrap_or(step)
}

/// A whole number in superscript digits.
pub(crate) fn superscript(number: i32) -> String {
    let raised = |letter: char| match letter {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    number.to_string().chars().map(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|(_, label)| label.as_str()).collect()
    }

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(labels(&Axis::linear(0.0, 1.0, 5)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(&Axis::linear(-0.13, 0.28, 4)), ["0.0", "0.2"]);
        assert_eq!(labels(&Axis::linear(3.0, 27.0, 5)), ["5", "10", "15", "20", "25"]);
    }

    #[test]
    fn large_and_small_numbers_share_a_power_of_a_thousand() {
        let axis = Axis::linear(0.0, 2.5e-5, 5);
        assert_eq!((labels(&axis), axis.exponent), (vec!["0", "5", "10", "15", "20", "25"], -6));
        let axis = Axis::linear(0.0, 3.0e5, 3);
        assert_eq!((labels(&axis), axis.exponent), (vec!["0", "100", "200", "300"], 3));
    }

    #[test]
    fn a_small_change_of_a_large_value_gets_the_digits_it_needs() {
        let axis = Axis::linear(1.000_001, 1.000_003, 2);
        assert_eq!(labels(&axis), ["1.000001", "1.000002", "1.000003"]);
    }

    #[test]
    fn an_axis_without_length_has_no_ticks() {
        for (low, high) in [(1.0, 1.0), (2.0, 1.0), (f64::NAN, 1.0), (0.0, f64::INFINITY), (0.0, 5e-324)] {
            assert!(Axis::linear(low, high, 5).ticks.is_empty(), "{low} {high}");
        }
    }

    #[test]
    fn a_narrow_range_has_ticks_between_the_powers() {
        assert_eq!(labels(&Axis::logarithmic(-0.8, 0.4, 5)), ["0.2", "0.5", "1", "2"]);
    }

    #[test]
    fn decades_are_written_as_powers() {
        assert_eq!(labels(&Axis::logarithmic(-12.3, -8.7, 5)), ["10⁻¹²", "10⁻¹¹", "10⁻¹⁰", "10⁻⁹"]);
    }
}
