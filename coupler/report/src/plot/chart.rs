//! A plot as inline SVG.

use plotters::prelude::*;

use super::ticked_range::TickedRange;
use super::{PALETTE, Plot, Scale};
use crate::ReportError;
use crate::axis::{Axis, superscript};

const SIZE: (u32, u32) = (560, 260);
/// A curve that goes up and down the height of the plot more often is drawn with a thinner pen.
const RAGGED: f64 = 12.0;
const GRID: RGBColor = RGBColor(226, 230, 235);
const AXIS: RGBColor = RGBColor(120, 128, 138);
const INK: RGBColor = RGBColor(51, 59, 68);

/// The plot as an `<svg>` element without anything external, its curves in the order of [`PALETTE`].
///
/// # Errors
/// The plotting library refuses.
pub(crate) fn svg(plot: &Plot) -> Result<String, ReportError> {
    let mut text = String::new();
    draw(plot, &mut text)
        .map_err(|problem| ReportError::Plot { title: plot.title.clone(), problem: problem.to_string() })?;
    // Inside HTML an svg element needs no namespace, and the report keeps free of addresses.
    Ok(text.replace(" xmlns=\"http://www.w3.org/2000/svg\"", ""))
}

fn draw(plot: &Plot, text: &mut String) -> Result<(), Box<dyn std::error::Error>> {
    let points = || plot.curves.iter().flat_map(|curve| curve.points());
    let (left, right) = widened(points().map(|point| point.0), 0.0);
    let (low, high) = widened(points().map(|point| point.1), 0.06);
    let across = match plot.across_scale {
        Scale::Linear => Axis::linear(left, right, 6),
        Scale::Logarithmic => Axis::logarithmic(left, right, 6),
    };
    let upright = match plot.scale {
        Scale::Linear if points().all(|point| point.1.fract() == 0.0) => {
            // Whole numbers get whole ticks.
            Axis::linear(low, high, (high - low).ceil().min(5.0) as usize)
        }
        Scale::Linear => Axis::linear(low, high, 5),
        Scale::Logarithmic => Axis::logarithmic(low, high, 6),
    };

    let across_title = format!("{} {}", plot.across.name, bracket(&plot.across.unit, across.exponent));
    let upright_title = bracket(&plot.unit, upright.exponent);

    let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
    let mut chart = ChartBuilder::on(&area)
        .margin(8)
        .margin_right(18)
        .x_label_area_size(42)
        .y_label_area_size(66)
        .build_cartesian_2d(
            TickedRange { low: left, high: right, axis: across },
            TickedRange { low, high, axis: upright },
        )?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID)
        .axis_style(AXIS)
        .label_style(("sans-serif", 15).into_font().color(&INK))
        .axis_desc_style(("sans-serif", 15).into_font().color(&INK))
        .x_desc(across_title)
        .y_desc(upright_title)
        .draw()?;
    for (curve, &(r, g, b)) in plot.curves.iter().zip(&PALETTE) {
        let colour = RGBColor(r, g, b);
        let width = if curve.travel() > RAGGED * (high - low) { 1 } else { 2 };
        for piece in &curve.pieces {
            if let [point] = piece[..] {
                chart.draw_series([Circle::new(point, 3, colour.filled())])?;
            } else {
                chart.draw_series(LineSeries::new(piece.iter().copied(), colour.stroke_width(width)))?;
            }
        }
    }
    area.present()?;
    Ok(())
}

/// `[10⁻³ unit]`; empty for a number without unit or power.
fn bracket(unit: &str, exponent: i32) -> String {
    let power = if exponent == 0 { String::new() } else { format!("10{}", superscript(exponent)) };
    match (power.as_str(), unit) {
        ("", "1") => String::new(),
        (power, "1") => format!("[{power}]"),
        ("", unit) => format!("[{unit}]"),
        (power, unit) => format!("[{power} {unit}]"),
    }
}

/// The range of the values with a margin at both ends, never empty.
fn widened(values: impl Iterator<Item = f64>, share: f64) -> (f64, f64) {
    let (low, high) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    let span = high - low;
    if span > 0.0 && span.is_finite() && span > 1e-12 * low.abs().max(high.abs()) {
        (low - share * span, high + share * span)
    } else if low.is_finite() && high.is_finite() {
        // A constant, exact or but for round-off: give it room on both sides.
        let half =
            if low == 0.0 && high == 0.0 { 1.0 } else { (0.1 * low.abs().max(high.abs())).max(1e-300) };
        ((low - half).max(f64::MIN), (high + half).min(f64::MAX))
    } else {
        (0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Curve;
    use super::*;
    use case_io::output::series::Title;

    fn plot(scale: Scale, x: &[f64], y: &[f64]) -> Plot {
        let places: Vec<f64> = y.iter().map(|&value| scale.place(value)).collect();
        Plot {
            title: "grains".to_owned(),
            across: Title { name: "t".to_owned(), unit: "s".to_owned() },
            across_scale: Scale::Linear,
            unit: "m/s".to_owned(),
            scale,
            curves: vec![Curve::new("vz", x, &places)],
        }
    }

    #[test]
    fn the_axes_carry_units_and_round_ticks() {
        let svg = svg(&plot(Scale::Linear, &[0.0, 1.0], &[0.0, -2e-3])).unwrap();
        for expected in ["t [s]", "[10⁻³ m/s]", "0.2", "-1.0", "<polyline"] {
            assert!(svg.contains(expected), "{expected} in {svg}");
        }
        assert!(!svg.contains("http"));
    }

    #[test]
    fn whole_numbers_get_whole_ticks() {
        let svg = svg(&plot(Scale::Linear, &[0.25, 0.5, 0.75], &[2.0, 4.0, 3.0])).unwrap();
        assert!(svg.contains("\n3\n") && !svg.contains("\n3.0\n") && !svg.contains("\n2.5\n"), "{svg}");
    }

    #[test]
    fn decades_of_residuals_are_labelled() {
        let svg = svg(&plot(Scale::Logarithmic, &[0.0, 1.0, 2.0], &[1e-2, 1e-6, 0.0])).unwrap();
        assert!(svg.contains("10⁻⁴") && svg.contains("10⁻⁶"), "{svg}");
    }

    #[test]
    fn a_single_row_is_a_dot() {
        assert!(svg(&plot(Scale::Linear, &[0.0], &[1.0])).unwrap().contains("<circle"));
    }

    #[test]
    fn no_values_constants_and_extremes_make_a_plot() {
        for y in [
            &[][..],
            &[f64::NAN],
            &[0.0, 0.0],
            &[3.0, 3.0],
            &[5e-324, 0.0],
            &[-f64::MAX, f64::MAX],
            &[1.0, 1.0 + 1e-16],
        ] {
            let x: Vec<f64> = (0..y.len()).map(|i| i as f64).collect();
            for scale in [Scale::Linear, Scale::Logarithmic] {
                assert!(svg(&plot(scale, &x, y)).unwrap().starts_with("<svg"), "{y:?}");
            }
        }
    }
}
