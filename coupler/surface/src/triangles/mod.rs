//! Surfaces of triangles from files.

mod obj;
mod seams;
mod stl;

use std::fs;
use std::path::Path;

use crate::error::InputError;
use crate::facet::Facet;
use crate::flaw::Flaw;
use crate::vector::Vector;

/// Three vertices, as a file states them.
type Triangle = [[f64; 3]; 3];

/// Triangles whose height is below this fraction of their longest edge have no side to push to.
const FLATTEST: f64 = 1e-7;

/// How triangles are written down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// STL, ASCII or binary.
    Stl,
    /// Wavefront OBJ.
    Obj,
}

/// Reads the triangles of a surface that is open at so many `rims`; its coordinates times `scale` are metres.
///
/// # Errors
/// A file that is missing, cut short, or holds no triangle; coordinates that are not finite; triangles without area;
/// triangles that are there twice; edges of more than two triangles; another number of rims.
pub fn read_triangles(
    path: &Path,
    format: Format,
    scale: f64,
    rims: usize,
) -> Result<Vec<Facet<3>>, InputError> {
    read(path, format, |triangles| {
        let facets = sound(triangles, scale)?;
        seams::check(&facets, rims)?;
        Ok(facets)
    })
}

/// Reads the triangles of a closed surface that all face the same side; its coordinates times `scale` are metres.
///
/// # Errors
/// As [`read_triangles`]; any opening; neighbours that face opposite sides.
pub fn read_closed(path: &Path, format: Format, scale: f64) -> Result<Vec<Facet<3>>, InputError> {
    read(path, format, |triangles| {
        let facets = sound(triangles, scale)?;
        seams::check_closed(&facets)?;
        Ok(facets)
    })
}

fn read(
    path: &Path,
    format: Format,
    check: impl FnOnce(Vec<Triangle>) -> Result<Vec<Facet<3>>, Flaw>,
) -> Result<Vec<Facet<3>>, InputError> {
    let bytes = fs::read(path).map_err(|source| InputError::Unreadable { path: path.into(), source })?;
    let triangles = match format {
        Format::Stl => stl::parse(&bytes),
        Format::Obj => obj::parse(&bytes),
    };
    triangles.and_then(check).map_err(|flaw| InputError::BadFile { path: path.into(), flaw })
}

/// The triangles, each of which can be a piece of wall.
fn sound(triangles: Vec<Triangle>, scale: f64) -> Result<Vec<Facet<3>>, Flaw> {
    if triangles.is_empty() {
        return Err(Flaw::whole("holds no triangle; a surface needs at least one"));
    }
    let to_metres = |vertex: [f64; 3]| Vector::from(vertex) * scale;
    let facets: Vec<_> =
        triangles.into_iter().map(|vertices| Facet { vertices: vertices.map(to_metres) }).collect();
    refuse(
        &facets,
        |facet| !facet.vertices.iter().all(|vertex| vertex.sum().is_finite()),
        |what| format!("{what} has a coordinate that is not a finite number; write the surface again"),
    )?;
    refuse(&facets, is_flat, |what| {
        format!("{what} has no area, its vertices lie on one line; remove it or repair the surface")
    })?;
    Ok(facets)
}

/// Refuses the first triangle that is `bad`, and says how many there are.
fn refuse(
    facets: &[Facet<3>],
    bad: impl Fn(&Facet<3>) -> bool,
    tell: impl Fn(String) -> String,
) -> Result<(), Flaw> {
    let Some(first) = facets.iter().position(&bad) else { return Ok(()) };
    let count = facets[first..].iter().filter(|facet| bad(facet)).count();
    let all = facets.len();
    let what = match count {
        1 => format!("triangle {} of {all}", first + 1),
        _ => format!("triangle {} of {all} (and {} more)", first + 1, count - 1),
    };
    Err(Flaw::whole(tell(what)))
}

fn is_flat(facet: &Facet<3>) -> bool {
    let [a, b, c] = facet.vertices;
    let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
    (b - a).cross(&(c - a)).norm() <= FLATTEST * longest * longest
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: Triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    #[test]
    fn coordinates_become_metres() {
        let facets = sound(vec![TRIANGLE], 1e-3).unwrap();
        assert_eq!(facets[0].vertices[1], Vector::from([1e-3, 0.0, 0.0]));
    }

    #[test]
    fn triangles_that_cannot_be_are_told_and_counted() {
        let error = |triangles: &[Triangle]| format!("a.stl{}", sound(triangles.to_vec(), 1.0).unwrap_err());
        let (mut endless, mut flat) = (TRIANGLE, TRIANGLE);
        endless[1][2] = f64::NAN;
        flat[2] = [5.0, 0.0, 0.0];
        assert_eq!(
            error(&[TRIANGLE, endless]),
            "a.stl: triangle 2 of 2 has a coordinate that is not a finite number; write the surface again"
        );
        assert_eq!(
            error(&[TRIANGLE, flat, TRIANGLE, flat, flat]),
            "a.stl: triangle 2 of 5 (and 2 more) has no area, its vertices lie on one line; remove it or repair the surface"
        );
        assert_eq!(error(&[]), "a.stl: holds no triangle; a surface needs at least one");
        let missing = read_triangles(Path::new("/nowhere/pipe.stl"), Format::Stl, 1.0, 0);
        assert!(missing.unwrap_err().to_string().starts_with("/nowhere/pipe.stl: "));
    }
}
