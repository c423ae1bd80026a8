//! The key to the colours.

use tiny_skia::{Color, Paint, Pixmap, Rect, Transform};

use super::colour_map::ColourMap;
use super::lettering::write_text;
use crate::axis::Axis;

/// What a colour bar says.
pub(super) struct ColourBar<'a> {
    pub(super) map: ColourMap,
    pub(super) range: (f64, f64),
    pub(super) label: &'a str,
    pub(super) unit: &'a str,
}

/// Width of the column that bars stand in \[pixels\].
pub(super) const COLUMN: usize = 118;
const BAR_WIDTH: f32 = 14.0;
const TEXT: f32 = 9.0;
/// Height of the two lines above the bar.
const HEAD: f32 = 40.0;

impl ColourBar<'_> {
    /// Draws label, unit and bar in the box from `top` to `bottom`, starting at `left`.
    pub(super) fn draw(&self, pixmap: &mut Pixmap, left: f32, top: f32, bottom: f32) {
        // With fewer than three wanted there may be none but zero.
        let wanted = (((bottom - top - HEAD) / 34.0) as usize).max(3);
        let axis = Axis::linear(self.range.0, self.range.1, wanted);
        let unit = match axis.exponent {
            0 => self.unit.to_owned(),
            exponent => format!("1e{exponent} {}", self.unit),
        };
        write_text(pixmap, self.label, left, top + TEXT, TEXT);
        write_text(pixmap, &unit, left, top + 2.0 * TEXT + 7.0, TEXT);

        let (head, foot) = (top + HEAD, bottom - 0.5 * TEXT);
        let rows = (foot - head).max(1.0) as usize;
        for row in 0..rows {
            let share = 1.0 - (row as f64 + 0.5) / rows as f64;
            let [r, g, b] = self.map.at(share);
            fill(pixmap, [left, head + row as f32, BAR_WIDTH, 1.0], [r, g, b]);
        }
        for (value, label) in &axis.ticks {
            let share = (value - self.range.0) / (self.range.1 - self.range.0);
            let y = head + rows as f32 * (1.0 - share as f32);
            fill(pixmap, [left + BAR_WIDTH, y.round() - 0.5, 4.0, 1.0], [0.45, 0.48, 0.52]);
            write_text(pixmap, label, left + BAR_WIDTH + 9.0, y + 0.5 * TEXT, TEXT);
        }
    }
}

fn fill(pixmap: &mut Pixmap, [x, y, width, height]: [f32; 4], [r, g, b]: [f32; 3]) {
    if let (Some(rect), Some(colour)) = (Rect::from_xywh(x, y, width, height), Color::from_rgba(r, g, b, 1.0))
    {
        let mut paint = Paint { anti_alias: true, ..Paint::default() };
        paint.set_color(colour);
        pixmap.fill_rect(rect, &paint, Transform::identity(), None);
    }
}
