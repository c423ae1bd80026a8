//! How the triangles of a surface hang together.

use std::collections::{BTreeMap, HashMap};

use crate::facet::Facet;
use crate::flaw::Flaw;
use crate::vector::Vector;

/// Vertices this near to each other, relative to the largest coordinate, are one: four units in the last place of the
/// single precision of STL.
const ONE_VERTEX: f64 = 4.0 * f32::EPSILON as f64;

/// Refuses triangles that are there twice, edges of more than two triangles, and another number of open rims than `rims`.
pub(super) fn check(facets: &[Facet<3>], rims: usize) -> Result<(), Flaw> {
    let welded = Welded::new(facets);
    welded.refuse_twins()?;
    let edges = welded.edges();
    welded.refuse_fins(&edges)?;
    welded.refuse_holes(&edges, rims)
}

/// Refuses what [`check`] does, any opening, and neighbours that face opposite sides: the surface has an inside.
pub(super) fn check_closed(facets: &[Facet<3>]) -> Result<(), Flaw> {
    let welded = Welded::new(facets);
    welded.refuse_twins()?;
    let edges = welded.edges();
    welded.refuse_fins(&edges)?;
    welded.refuse_openings(&edges)?;
    welded.refuse_turned()
}

/// Triangles as indices of vertices.
struct Welded {
    vertices: Vec<Vector<3>>,
    triangles: Vec<[u32; 3]>,
}

/// For each edge, how many triangles have it; vertices ascend.
type Edges = BTreeMap<[u32; 2], u32>;

impl Welded {
    fn new(facets: &[Facet<3>]) -> Self {
        let all = || facets.iter().flat_map(|facet| facet.vertices);
        let tolerance = ONE_VERTEX * all().map(|vertex| vertex.amax()).fold(0.0, f64::max);
        let mut vertices: Vec<Vector<3>> = Vec::new();
        // Cells of twice the tolerance: what is within it is in this cell or in the nearer neighbours.
        let mut cells: HashMap<[i64; 3], u32> = HashMap::new();
        let mut index = |vertex: &Vector<3>| {
            let scaled: Vector<3> = vertex / (2.0 * tolerance);
            let near = (0..8).find_map(|corner| {
                let cell = std::array::from_fn(|axis| {
                    let shift = if corner >> axis & 1 == 0 { -0.5 } else { 0.5 };
                    (scaled[axis] + shift).floor() as i64
                });
                let known = *cells.get(&cell)?;
                ((vertices[known as usize] - vertex).amax() <= tolerance).then_some(known)
            });
            near.unwrap_or_else(|| {
                let new = vertices.len() as u32;
                vertices.push(*vertex);
                cells.insert(std::array::from_fn(|axis| scaled[axis].floor() as i64), new);
                new
            })
        };
        let triangles = facets.iter().map(|facet| facet.vertices.map(|vertex| index(&vertex))).collect();
        Self { vertices, triangles }
    }

    fn edges(&self) -> Edges {
        let mut edges = Edges::new();
        for &[a, b, c] in &self.triangles {
            for [one, other] in [[a, b], [b, c], [c, a]] {
                *edges.entry([one.min(other), one.max(other)]).or_default() += 1;
            }
        }
        edges
    }

    fn at(&self, vertex: u32) -> String {
        let Vector { data, .. } = self.vertices[vertex as usize];
        let [[x, y, z]] = data.0;
        format!("({x}, {y}, {z}) m")
    }

    fn refuse_twins(&self) -> Result<(), Flaw> {
        let mut known = BTreeMap::new();
        let twins: Vec<_> = self
            .triangles
            .iter()
            .enumerate()
            .filter_map(|(number, triangle)| {
                let mut key = *triangle;
                key.sort_unstable();
                known.insert(key, number).map(|first| (first + 1, number + 1))
            })
            .collect();
        match twins.as_slice() {
            [] => Ok(()),
            [(first, second), ..] => Err(Flaw::whole(format!(
                "{} of {} triangles are there twice, the first are {first} and {second}; remove one of each",
                twins.len(),
                self.triangles.len()
            ))),
        }
    }

    /// A surface is on both sides of each edge: where three triangles meet, it does not say which go on.
    fn refuse_fins(&self, edges: &Edges) -> Result<(), Flaw> {
        let fins: Vec<_> = edges.iter().filter(|(_, triangles)| **triangles > 2).collect();
        match fins.as_slice() {
            [] => Ok(()),
            [([one, other], triangles), ..] => Err(Flaw::whole(format!(
                "{} edges belong to more than two triangles, the first, from {} to {}, to {triangles}; make what meets there walls of their own",
                fins.len(),
                self.at(*one),
                self.at(*other)
            ))),
        }
    }

    fn refuse_openings(&self, edges: &Edges) -> Result<(), Flaw> {
        let rims = rims(&open(edges));
        let Some((count, vertex)) = rims.values().min() else { return Ok(()) };
        Err(Flaw::whole(format!(
            "has {} holes (the smallest of {count} edges, near {}); close them: only a closed surface has an inside",
            rims.len(),
            self.at(*vertex)
        )))
    }

    /// Two triangles that face the same side pass their common edge in opposite directions.
    fn refuse_turned(&self) -> Result<(), Flaw> {
        let mut passed = BTreeMap::new();
        for (number, &[a, b, c]) in self.triangles.iter().enumerate() {
            for edge in [[a, b], [b, c], [c, a]] {
                if let Some(other) = passed.insert(edge, number) {
                    return Err(Flaw::whole(format!(
                        "triangles {} and {} face opposite sides of the surface; write it again with all triangles facing outwards",
                        other + 1,
                        number + 1
                    )));
                }
            }
        }
        Ok(())
    }

    fn refuse_holes(&self, edges: &Edges, allowed: usize) -> Result<(), Flaw> {
        let rims = rims(&open(edges));
        if rims.len() == allowed {
            return Ok(());
        }
        let found = match rims.values().min() {
            None => "is closed".to_string(),
            Some((edges, vertex)) => format!(
                "has {} open rims (the smallest of {edges} edges, near {})",
                rims.len(),
                self.at(*vertex)
            ),
        };
        let stated = "state as rims how many it is meant to have";
        Err(Flaw::whole(format!("{found}, allowed: {allowed}; close what is open by mistake, or {stated}")))
    }
}

/// The edges of one triangle only.
fn open(edges: &Edges) -> Vec<[u32; 2]> {
    edges.iter().filter(|(_, triangles)| **triangles == 1).map(|(edge, _)| *edge).collect()
}

/// The rims that open edges form, by their first vertex: the number of edges, and that vertex.
fn rims(open: &[[u32; 2]]) -> BTreeMap<u32, (usize, u32)> {
    let mut linked: BTreeMap<u32, u32> = open.iter().flatten().map(|&vertex| (vertex, vertex)).collect();
    fn root(linked: &BTreeMap<u32, u32>, mut vertex: u32) -> u32 {
        while linked[&vertex] != vertex {
            vertex = linked[&vertex];
        }
        vertex
    }
    for &[one, other] in open {
        let (one, other) = (root(&linked, one), root(&linked, other));
        linked.insert(one.max(other), one.min(other));
    }
    let mut rims = BTreeMap::new();
    for &[one, _] in open {
        let first = root(&linked, one);
        rims.entry(first).or_insert((0, first)).0 += 1;
    }
    rims
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The faces of a unit cube, two triangles each, with vertices that are off by `noise`.
    fn cube(noise: f64) -> Vec<Facet<3>> {
        let mut facets = Vec::new();
        let mut toss = 1.0;
        for (axis, side) in (0..6).map(|face| (face / 2, f64::from(face as u32 % 2))) {
            let mut corner = |u: f64, v: f64| {
                toss = -toss;
                let mut at = [0.0; 3];
                (at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]) = (side + noise * toss, u, v);
                at
            };
            facets.push(Facet::new([corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0)]));
            facets.push(Facet::new([corner(0.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)]));
        }
        facets
    }

    fn error(facets: &[Facet<3>], rims: usize) -> String {
        format!("a.stl{}", check(facets, rims).unwrap_err())
    }

    #[test]
    fn a_cube_is_closed_and_its_vertices_meet_within_single_precision() {
        for noise in [0.0, 1e-7] {
            check(&cube(noise), 0).unwrap();
        }
        assert!(error(&cube(1e-5), 0).contains("open rims"));
        assert_eq!(
            error(&cube(0.0), 1),
            "a.stl: is closed, allowed: 1; close what is open by mistake, or state as rims how many it is meant to have"
        );
    }

    #[test]
    fn holes_are_told_apart_from_rims_that_are_meant() {
        let whole = cube(0.0);
        let lidless = [&whole[..8], &whole[10..]].concat();
        check(&lidless, 1).unwrap();
        assert!(error(&lidless, 0).starts_with(
            "a.stl: has 1 open rims (the smallest of 4 edges, near (0, 0, 0) m), allowed: 0; close what"
        ));
        let torn = &lidless[1..];
        check(torn, 1).unwrap_or_else(|flaw| panic!("a hole that touches the rim is one with it: {flaw}"));
        let holed: Vec<_> = whole[1..11].iter().chain(&whole[11..]).copied().collect();
        assert!(error(&holed, 0).contains("smallest of 3 edges"), "{}", error(&holed, 0));
    }

    #[test]
    fn a_surface_without_an_inside_is_refused() {
        let told = |facets: &[Facet<3>]| format!("a.stl{}", check_closed(facets).unwrap_err());
        let whole = cube(1e-7);
        // The faces on the low sides face inwards as they are made here.
        let outwards: Vec<_> = (0..12)
            .map(|k| {
                let [a, b, c] = whole[k].vertices;
                if k / 2 % 2 == 0 { Facet { vertices: [a, c, b] } } else { whole[k] }
            })
            .collect();
        check_closed(&outwards).unwrap();
        assert!(told(&whole).contains("face opposite sides of the surface"), "{}", told(&whole));
        assert!(
            told(&outwards[1..]).starts_with("a.stl: has 1 holes (the smallest of 3 edges, near (")
                && told(&outwards[1..]).ends_with("close them: only a closed surface has an inside")
        );
    }

    #[test]
    fn twins_and_fins_are_refused() {
        let mut twins = cube(0.0);
        twins.push(twins[3]);
        assert_eq!(
            error(&twins, 0),
            "a.stl: 1 of 13 triangles are there twice, the first are 4 and 13; remove one of each"
        );
        let mut fin = cube(0.0);
        fin.push(Facet::new([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, -1.0, -1.0]]));
        assert!(
            error(&fin, 0).starts_with("a.stl: 1 edges belong to more than two triangles, the first, from ")
        );
    }
}
