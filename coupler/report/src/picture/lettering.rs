//! Letters for pictures: every glyph is a few pen strokes, smooth at any size.
//!
//! A stroke is a run of points `xy` on a grid 4 wide and 9 high (descender 0, baseline 2, x-height 6, capital height
//! 8). The pen goes from the middle of one side to the next, with the corner as control point of a quadratic curve; a
//! corner given twice stays sharp.

use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, Transform};

/// The ink of all lettering.
const INK: [u8; 3] = [0x33, 0x3b, 0x44];
const BASELINE: f32 = 2.0;
const CAPITAL: f32 = 8.0;
/// Between two glyphs, in units of the grid.
const GAP: f32 = 1.9;

fn strokes(glyph: char) -> &'static str {
    match glyph {
        '0' => "28 48 42 02 08 28",
        '1' => "16 38 38 32",
        '2' => "07 08 48 45 02 02 42",
        '3' => "07 08 48 45 25 15 25 45 42 02 03",
        '4' => "38 04 04 44|38 32",
        '5' => "48 08 08 05 05 06 46 42 02 03",
        '6' => "38 08 02 42 46 06 04",
        '7' => "08 48 48 12",
        '8' => "25 05 08 48 45 25|25 05 02 42 45 25",
        '9' => "12 42 48 08 04 44 46",
        'a' => "45 46 06 02 42 43|46 42",
        'b' => "08 02|05 06 46 42 02 03",
        'c' => "45 46 06 02 42 43",
        'd' => "48 42|45 46 06 02 42 43",
        'e' => "04 44 44 46 06 02 42 43",
        'f' => "38 18 16 12|06 36",
        'g' => "45 46 06 02 42 43|46 41 40 00 01",
        'h' => "08 02|05 06 46 44 42",
        'i' => "16 12|18 18",
        'j' => "26 21 20 00|28 28",
        'k' => "08 02|36 04 04 42",
        'l' => "18 13 12 22",
        'm' => "06 02|05 06 36 34 32|35 36 66 64 62",
        'n' => "06 02|05 06 46 44 42",
        'o' => "26 46 42 02 06 26",
        'p' => "06 00|05 06 46 42 02 03",
        'q' => "46 40|45 46 06 02 42 43",
        'r' => "06 02|04 06 36",
        's' => "45 46 06 04 44 42 02 03",
        't' => "18 14 12 32|06 36",
        'u' => "06 04 02 42 44|46 42",
        'v' => "06 22 22 46",
        'w' => "06 12 12 36 36 52 52 66",
        'x' => "06 42|46 02",
        'y' => "06 22|46 10",
        'z' => "06 46 46 02 02 42",
        'N' => "02 08 08 42 42 48",
        'P' => "02 08 08 28 48 45 25 05",
        '.' => "12 12",
        ',' => "12 01",
        ':' => "15 15|12 12",
        '-' => "05 45",
        '+' => "05 45|23 27",
        '=' => "06 46|04 44",
        '/' => "01 48",
        '(' => "29 07 03 21",
        ')' => "09 27 23 01",
        '[' => "29 09 09 01 01 21",
        ']' => "09 29 29 21 21 01",
        '_' => "01 41",
        ' ' => "",
        _ => "08 48 48 42 42 02 02 08",
    }
}

/// The glyph that is drawn for a letter: capitals that no unit needs are drawn small.
fn drawn(letter: char) -> char {
    if matches!(letter, 'N' | 'P') { letter } else { letter.to_ascii_lowercase() }
}

fn width_on_grid(glyph: char) -> f32 {
    if glyph == ' ' {
        return 2.0;
    }
    let columns = strokes(glyph).split(['|', ' ']).filter_map(|point| point.as_bytes().first());
    f32::from(columns.max().map_or(0, |column| column - b'0')).max(2.0)
}

/// Width of a line of text whose capitals are `height` pixels high.
pub(super) fn text_width(text: &str, height: f32) -> f32 {
    let grid: f32 = text.chars().map(|letter| width_on_grid(drawn(letter)) + GAP).sum();
    (grid - GAP).max(0.0) * height / (CAPITAL - BASELINE)
}

/// Writes a line of text with its baseline at `y`, starting at `x`; capitals are `height` pixels high.
pub(super) fn write_text(pixmap: &mut Pixmap, text: &str, x: f32, y: f32, height: f32) {
    let unit = height / (CAPITAL - BASELINE);
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(Color::from_rgba8(INK[0], INK[1], INK[2], 255));
    let pen = Stroke {
        width: 0.15 * height,
        line_cap: LineCap::Round,
        line_join: LineJoin::Round,
        ..Stroke::default()
    };
    let mut left = x;
    for letter in text.chars() {
        let glyph = drawn(letter);
        for stroke in strokes(glyph).split('|').filter(|stroke| !stroke.is_empty()) {
            let points: Vec<[f32; 2]> = stroke
                .split(' ')
                .filter_map(|point| point.as_bytes().first_chunk::<2>())
                .map(|&[column, row]| {
                    [left + unit * f32::from(column - b'0'), y - unit * (f32::from(row - b'0') - BASELINE)]
                })
                .collect();
            let mut path = PathBuilder::new();
            if let [a, b] = points[..]
                && a == b
            {
                path.push_circle(a[0], a[1], 0.65 * pen.width);
                if let Some(dot) = path.finish() {
                    pixmap.fill_path(&dot, &paint, FillRule::Winding, Transform::identity(), None);
                }
                continue;
            }
            path.move_to(points[0][0], points[0][1]);
            let last = points.len() - 1;
            for i in 1..last {
                let next = points[i + 1];
                let corner = points[i];
                let end = if i + 1 == last { next } else { [0, 1].map(|k| 0.5 * (corner[k] + next[k])) };
                path.quad_to(corner[0], corner[1], end[0], end[1]);
            }
            if last == 1 {
                path.line_to(points[1][0], points[1][1]);
            }
            if let Some(path) = path.finish() {
                pixmap.stroke_path(&path, &paint, &pen, Transform::identity(), None);
            }
        }
        left += unit * (width_on_grid(glyph) + GAP);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_glyph_is_made_of_strokes_on_the_grid_and_leaves_ink() {
        for glyph in "0123456789abcdefghijklmnopqrstuvwxyzNP.,:-+=/()[]_?".chars() {
            for stroke in strokes(glyph).split('|') {
                let points: Vec<&str> = stroke.split(' ').collect();
                assert!(points.len() >= 2, "{glyph}");
                assert!(
                    points.iter().all(|p| p.len() == 2 && p.bytes().all(|b| b.is_ascii_digit())),
                    "{glyph}"
                );
            }
            let mut pixmap = Pixmap::new(40, 40).unwrap();
            write_text(&mut pixmap, &glyph.to_string(), 10.0, 30.0, 12.0);
            assert!(pixmap.pixels().iter().any(|pixel| pixel.alpha() > 100), "{glyph}");
        }
    }

    #[test]
    fn text_stays_within_its_stated_width() {
        let mut pixmap = Pixmap::new(300, 40).unwrap();
        let text = "t = 0.123 s";
        write_text(&mut pixmap, text, 10.0, 30.0, 10.0);
        let mut inked = (0..300u32).filter(|&x| (0..40).any(|y| pixmap.pixel(x, y).unwrap().alpha() > 0));
        let (first, last) = (inked.next().unwrap(), inked.next_back().unwrap());
        assert!(first >= 8 && (last as f32) < 12.0 + text_width(text, 10.0));
    }
}
