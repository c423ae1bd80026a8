//! Pictures of the scene, inside the page.

use base64::prelude::{BASE64_STANDARD, Engine as _};

use super::nothing;
use super::text::escape;

/// A picture and what it shows.
pub(crate) struct Figure {
    pub(crate) caption: String,
    pub(crate) png: Vec<u8>,
}

/// Narrower pictures stand side by side \[pixels\].
const WIDE: u32 = 500;

/// The width in the header of a PNG.
fn width(png: &[u8]) -> u32 {
    png.get(16..20).and_then(|bytes| bytes.try_into().ok()).map_or(0, u32::from_be_bytes)
}

pub(super) fn html(figures: &[Figure]) -> String {
    if figures.is_empty() {
        return nothing("The run has left no frames.");
    }
    let figures: String = figures
        .iter()
        .map(|Figure { caption, png }| {
            let data = BASE64_STANDARD.encode(png);
            let class = if width(png) < WIDE { "narrow" } else { "wide" };
            format!(
                "<figure class=\"{class}\"><img src=\"data:image/png;base64,{data}\" alt=\"The scene at {}\"></figure>\n",
                escape(caption)
            )
        })
        .collect();
    format!("<div class=\"pictures\">\n{figures}</div>")
}
