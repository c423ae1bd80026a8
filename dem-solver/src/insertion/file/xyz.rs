//! XYZ, plain or extended, in SI units: a line with the number of grains, a comment, a row for each grain; and again.
//!
//! Plain rows are a name, x, y, z and, if wanted, a radius. The comment of the extended form says by `Properties=` what
//! stands where: `pos`, `velo` or `vel`, `radius`; other properties are passed over.

use super::FileGrain;
use super::columns::{Columns, Names};
use surface::Flaw;

const NAMES: Names = ["x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "radius"];

/// The number of grains that a line states, and nothing else.
pub(super) fn count(line: &str) -> Option<usize> {
    line.trim().parse().ok()
}

/// The grains of the last snapshot.
pub(super) fn read(text: &str) -> Result<Vec<FileGrain>, Flaw> {
    let lines: Vec<&str> = text.lines().collect();
    let (mut start, mut grains) = (0, Vec::new());
    while start < lines.len() && !lines[start..].iter().all(|line| line.trim().is_empty()) {
        let number = count(lines[start]).ok_or_else(|| {
            Flaw::at(start + 1, format!("{:?} is not the number of grains", lines[start].trim()))
        })?;
        let first = start + 2;
        let Some(rows) = first.checked_add(number).and_then(|end| lines.get(first..end)) else {
            let left = lines.len().saturating_sub(first);
            let what = format!("{number} grains are announced, {left} rows follow; the file was cut short");
            return Err(Flaw::at(start + 1, what));
        };
        grains = snapshot(first, lines[start + 1], rows)?;
        start = first + number;
    }
    Ok(grains)
}

fn snapshot(first: usize, comment: &str, rows: &[&str]) -> Result<Vec<FileGrain>, Flaw> {
    let cells: Vec<Vec<&str>> = rows.iter().map(|row| row.split_whitespace().collect()).collect();
    let stated = comment.split_whitespace().find_map(|word| word.strip_prefix("Properties="));
    let names = match stated {
        Some(properties) => properties_of(properties)
            .ok_or_else(|| Flaw::at(first, format!("{properties:?} is not name:type:count:…")))?,
        None if cells.first().is_some_and(|row| row.len() == 5) => vec!["name", "x", "y", "z", "radius"],
        None => vec!["name", "x", "y", "z"],
    };
    let columns = Columns::of(first, &names, &NAMES, 1.0)?;
    cells.iter().enumerate().map(|(k, row)| columns.grain(first + k + 1, row)).collect()
}

/// Names of the columns that `name:type:count:name:type:count…` describes.
fn properties_of(properties: &str) -> Option<Vec<&str>> {
    let words: Vec<&str> = properties.split(':').collect();
    let mut names = Vec::new();
    for property in words.chunks(3) {
        let &[name, _, count] = property else { return None };
        let count: usize = count.parse().ok()?;
        match (name, count) {
            ("pos", 3) => names.extend(["x", "y", "z"]),
            ("velo" | "vel", 3) => names.extend(["vx", "vy", "vz"]),
            ("radius", 1) => names.push("radius"),
            _ => names.extend(std::iter::repeat_n("", count)),
        }
    }
    Some(names)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_and_extended_rows_are_read() {
        let plain = "1\nfirst\nG 9 9 9\n2\nlast\nG 1 2 3\nG 4 5 6\n\n";
        let grains = read(plain).unwrap();
        assert_eq!((grains.len(), grains[1].centre, grains[1].radius), (2, [4.0, 5.0, 6.0], None));
        assert_eq!(read("1\n\nG 1 2 3 0.5\n").unwrap()[0].radius, Some(0.5));
        let extended = "1\nLattice=\"1 0 0\" Properties=id:I:1:radius:R:1:species:S:1:pos:R:3:velo:R:3\n7 0.25 Si 1 2 3 4 5 6\n";
        let grain = FileGrain {
            centre: [1.0, 2.0, 3.0],
            velocity: Some([4.0, 5.0, 6.0]),
            angular_velocity: None,
            radius: Some(0.25),
        };
        assert_eq!(read(extended).unwrap(), [grain]);
    }

    #[test]
    fn messages_name_line_and_column() {
        let error = |text: &str| format!("a.xyz{}", read(text).unwrap_err());
        assert_eq!(
            error("2\n\nG 1 2 3\n"),
            "a.xyz:1: 2 grains are announced, 1 rows follow; the file was cut short"
        );
        assert_eq!(error("1\n\nG 1 2 x\n"), "a.xyz:3: z: \"x\" is not a finite number");
        assert_eq!(error("1\n\nG 1 2 3\nG 4 5 6\n"), "a.xyz:4: \"G 4 5 6\" is not the number of grains");
        assert_eq!(error("1\nProperties=pos:R\n1 2 3\n"), "a.xyz:2: \"pos:R\" is not name:type:count:…");
        assert_eq!(error("1\n\nG 1 2\n"), "a.xyz:3: 3 values where the header has 4");
    }
}
