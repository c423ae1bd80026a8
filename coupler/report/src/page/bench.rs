//! The page over a benchmark.

use case_io::output::series::Title;

use super::text::escape;
use super::{document, section, series};
use crate::plot::{Curve, Plot, Scale};
use crate::{ReportError, WorkPrecision};

/// The whole page.
///
/// # Errors
/// A plot that cannot be drawn.
pub(crate) fn html(title: &str, plots: &[WorkPrecision]) -> Result<String, ReportError> {
    let mut body = format!("<header>\n<h1>{}</h1>\n</header>\n", escape(title));
    for measured in plots {
        let figure = series::figure(&plot(measured))?;
        let content = format!("<p>{}</p>\n<div class=\"plots\">\n{figure}</div>\n", escape(&measured.error));
        body += &section(&escape(&measured.title), &content);
    }
    Ok(document(title, &body))
}

fn plot(measured: &WorkPrecision) -> Plot {
    let scale = Scale::Logarithmic;
    let places = |which: fn(&(f64, f64)) -> f64, points: &[(f64, f64)]| -> Vec<f64> {
        points.iter().map(|point| scale.place(which(point))).collect()
    };
    let curve = |(name, points): &(String, Vec<(f64, f64)>)| {
        Curve::new(name, &places(|point| point.0, points), &places(|point| point.1, points))
    };
    Plot {
        title: measured.title.clone(),
        across: Title { name: measured.work.name.clone(), unit: measured.work.unit.clone() },
        across_scale: scale,
        unit: "1".to_owned(),
        scale,
        curves: measured.curves.iter().map(curve).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Amount;

    #[test]
    fn errors_and_work_are_drawn_on_logarithmic_scales() {
        let work = Amount { name: "processor time".to_owned(), unit: "s".to_owned() };
        let curves = vec![("fast & right".to_owned(), vec![(0.1, 1e-2), (10.0, 1e-5)])];
        let plot = WorkPrecision { title: "vortex".to_owned(), work, error: "error of u".to_owned(), curves };
        let html = html("Bench", &[plot]).unwrap();
        for expected in ["vortex", "processor time [s]", "error of u", "10⁻⁴", "fast &amp; right"] {
            assert!(html.contains(expected), "{expected} in {html}");
        }
    }
}
