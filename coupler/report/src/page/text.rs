//! Text and numbers for people.

/// Text made fit for HTML.
pub(super) fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
        .replace('\'', "&#39;")
}

/// A number with up to five significant digits, as short as it can be.
pub(crate) fn number(value: f64) -> String {
    let magnitude = value.abs();
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return value.to_string();
    }
    if (1e-3..1e6).contains(&magnitude) {
        let decimals = (4 - magnitude.log10().floor() as i32).max(0) as usize;
        shortened(&format!("{value:.decimals$}"))
    } else {
        let scientific = format!("{value:.4e}");
        match scientific.split_once('e') {
            Some((mantissa, exponent)) => format!("{}e{exponent}", shortened(mantissa)),
            None => scientific,
        }
    }
}

/// Without the zeros at the end of a decimal fraction.
fn shortened(decimal: &str) -> String {
    if decimal.contains('.') {
        decimal.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        decimal.to_owned()
    }
}

/// A count with its thousands set apart by thin spaces.
pub(super) fn count(value: u64) -> String {
    let digits = value.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// Bytes in the largest binary unit that leaves at least 1.
pub(super) fn bytes(value: u64) -> String {
    let units = ["B", "KiB", "MiB", "GiB", "TiB"];
    let power = (value.max(1).ilog2() / 10).min(4);
    let scaled =
        value as f64 / f64::from(1u32 << (10 * power.min(3))) / if power == 4 { 1024.0 } else { 1.0 };
    let decimals = usize::from(power > 0 && scaled < 100.0);
    format!("{scaled:.decimals$} {}", units[power as usize])
}

/// Seconds as a person says them.
pub(super) fn duration(seconds: f64) -> String {
    if !seconds.is_finite() || seconds < 0.0 {
        return format!("{seconds} s");
    }
    if seconds < 100.0 {
        return format!("{} s", number(seconds));
    }
    let whole = seconds.round() as u64;
    let (hours, minutes, rest) = (whole / 3600, whole / 60 % 60, whole % 60);
    if hours > 0 { format!("{hours} h {minutes} min") } else { format!("{minutes} min {rest} s") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_keep_five_digits() {
        let cases = [
            (0.0, "0"),
            (1.0, "1"),
            (-0.12345678, "-0.12346"),
            (1234.5678, "1234.6"),
            (99999.96, "100000"),
            (1e6, "1e6"),
            (2.5e-7, "2.5e-7"),
            (-1.234567e-12, "-1.2346e-12"),
            (f64::NAN, "NaN"),
            (f64::INFINITY, "inf"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn counts_bytes_and_durations_read_well() {
        assert_eq!(count(1_234_567), "1\u{202f}234\u{202f}567");
        assert_eq!((count(0).as_str(), count(999).as_str()), ("0", "999"));
        assert_eq!((bytes(0).as_str(), bytes(1023).as_str()), ("0 B", "1023 B"));
        assert_eq!((bytes(1 << 20).as_str(), bytes(3 << 40).as_str()), ("1.0 MiB", "3.0 TiB"));
        assert_eq!((duration(0.25).as_str(), duration(3723.0).as_str()), ("0.25 s", "1 h 2 min"));
        assert_eq!(duration(125.4), "2 min 5 s");
    }

    #[test]
    fn escaped_text_cannot_open_a_tag() {
        assert_eq!(escape("<script>'\"&"), "&lt;script&gt;&#39;&quot;&amp;");
    }
}
