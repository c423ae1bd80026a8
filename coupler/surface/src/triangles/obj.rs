//! Wavefront OBJ: vertices and faces; what is not geometry is passed over.

use super::Triangle;
use crate::flaw::Flaw;

/// Statements that place nothing.
const PASSED_OVER: [&str; 10] = ["vn", "vt", "vp", "g", "o", "s", "l", "p", "usemtl", "mtllib"];

/// The triangles of an OBJ file, in its own unit; faces of more corners are cut into fans.
pub(super) fn parse(bytes: &[u8]) -> Result<Vec<Triangle>, Flaw> {
    let text = std::str::from_utf8(bytes).map_err(|_| Flaw::whole("is not text, as OBJ is"))?;
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for (index, line) in text.lines().enumerate() {
        let number = index + 1;
        let mut words = line.split('#').next().unwrap_or_default().split_whitespace();
        match words.next() {
            Some("v") => vertices.push(vertex(number, line, words)?),
            Some("f") => {
                let corners = words
                    .map(|word| corner(number, word, &vertices))
                    .collect::<Result<Vec<[f64; 3]>, Flaw>>()?;
                let [first, rest @ ..] = corners.as_slice() else { return Err(too_few(number, 0)) };
                if rest.len() < 2 {
                    return Err(too_few(number, corners.len()));
                }
                triangles.extend(rest.windows(2).map(|pair| [*first, pair[0], pair[1]]));
            }
            Some(known) if PASSED_OVER.contains(&known) => {}
            Some(other) => {
                let what = format!("unknown statement {other:?}; allowed: v, f, {}", PASSED_OVER.join(", "));
                return Err(Flaw::at(number, what));
            }
            None => {}
        }
    }
    Ok(triangles)
}

fn vertex<'a>(number: usize, line: &str, words: impl Iterator<Item = &'a str>) -> Result<[f64; 3], Flaw> {
    let numbers: Vec<f64> = words.map_while(|word| word.parse().ok()).collect();
    match numbers.as_slice() {
        &[x, y, z, ..] => Ok([x, y, z]),
        _ => Err(Flaw::at(number, format!("{:?} is not a vertex; write \"v x y z\"", line.trim()))),
    }
}

/// The vertex of a corner `v`, `v/vt` or `v/vt/vn`: counted from 1, or back from the last if negative.
fn corner(number: usize, word: &str, vertices: &[[f64; 3]]) -> Result<[f64; 3], Flaw> {
    let stated: Option<i64> = word.split('/').next().and_then(|index| index.parse().ok());
    let found = stated.and_then(|stated| match stated {
        1.. => vertices.get(stated as usize - 1),
        _ => vertices.len().checked_sub(stated.unsigned_abs() as usize).and_then(|at| vertices.get(at)),
    });
    found.copied().ok_or_else(|| {
        Flaw::at(number, format!("corner {word:?} is none of the {} vertices so far", vertices.len()))
    })
}

fn too_few(number: usize, corners: usize) -> Flaw {
    Flaw::at(number, format!("a face of {corners} corners; it needs 3 or more"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = "# a square\no floor\nv 0 0 0\nv 1 0 0 # corner\nv 1 1 0 1.0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nf -4 -3/7 -2\n";

    #[test]
    fn faces_are_cut_into_triangles() {
        let (a, b, c, d) = ([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]);
        assert_eq!(parse(SQUARE.as_bytes()).unwrap(), [[a, b, c], [a, c, d], [a, b, c]]);
    }

    #[test]
    fn messages_name_the_line() {
        let error = |from: &str, to: &str| {
            assert!(SQUARE.contains(from));
            format!("a.obj{}", parse(SQUARE.replace(from, to).as_bytes()).unwrap_err())
        };
        assert_eq!(error("v 0 1 0", "v 0 1"), "a.obj:6: \"v 0 1\" is not a vertex; write \"v x y z\"");
        assert_eq!(error("4//1", "5//1"), "a.obj:8: corner \"5//1\" is none of the 4 vertices so far");
        assert_eq!(error("4//1", "0"), "a.obj:8: corner \"0\" is none of the 4 vertices so far");
        assert_eq!(error("f -4 -3/7 -2", "f -4 -3"), "a.obj:9: a face of 2 corners; it needs 3 or more");
        assert!(
            error("vn 0", "curv 0").starts_with("a.obj:7: unknown statement \"curv\"; allowed: v, f, vn, ")
        );
        assert_eq!(format!("a.obj{}", parse(&[0xff, 0xfe]).unwrap_err()), "a.obj: is not text, as OBJ is");
    }
}
