//! What a file holds, and the mesh in it.

use super::element_type::ElementType;
use super::source::Source;
use crate::element::simplex::{Vector, difference, volume_and_gradients};
use crate::mesh::build::root;
use crate::mesh::{MeshError, MeshParts, PeriodicPairs};

/// Points lie in one plane, and periodic shifts along one axis, to this share of the mesh's extent.
const FLATNESS: f64 = 1e-9;

/// Names, nodes, elements and periodic pairs, as in the file.
#[derive(Default)]
pub struct Content {
    /// Dimension, tag, name.
    names: Vec<(i32, i32, String)>,
    /// Tag, position.
    pub nodes: Vec<(u64, Vector<3>)>,
    pub elements: Vec<Element>,
    /// Tags of image and master.
    pub periodic: Vec<(u64, u64)>,
}

/// An element: its type, physical tag (0 for none), and the tags of its nodes.
pub struct Element {
    pub kind: ElementType,
    pub physical: i32,
    pub nodes: [u64; 4],
}

/// Tag and number of nodes, sorted by tag, and the positions by number.
type UsedNodes<const D: usize> = (Vec<(u64, u32)>, Vec<Vector<D>>);

/// Refuses what is no linear simplex.
pub fn element_type(source: &Source, number: i32) -> Result<ElementType, MeshError> {
    ElementType::from_number(number).map_err(|name| {
        let expected = "points, 2-node lines, 3-node triangles, 4-node tetrahedra";
        source.error(
            name,
            expected,
            "mesh with simplices of first order (Mesh.ElementOrder = 1, no recombination)",
        )
    })
}

impl Content {
    pub fn read_names(&mut self, source: &mut Source) -> Result<(), MeshError> {
        let count: usize = source.text("a count")?;
        for _ in 0..count {
            let (dimension, tag) = (source.text("a dimension")?, source.text("a tag")?);
            self.names.push((dimension, tag, source.quoted()?.to_owned()));
        }
        Ok(())
    }

    /// The parts of the mesh: cells of dimension D, the nodes they use, and the boundary groups.
    pub fn into_parts<const D: usize, const N: usize>(
        self,
        source: &Source,
    ) -> Result<MeshParts<D, N>, MeshError> {
        let higher = self.elements.iter().find(|element| element.kind.dimension() > D);
        if let Some(element) = higher {
            let (found, expected) = (format!("a {:?}", element.kind), format!("a mesh of dimension {D}"));
            return Err(source.error(found, expected, "set the case's dimension to that of the mesh"));
        }
        let (order, points) = self.used_nodes::<D>(source)?;
        let point_of = |tag: u64| order.binary_search_by_key(&tag, |entry| entry.0).ok().map(|i| order[i].1);
        let unknown = |tag: u64| {
            source.error(
                format!("node {tag}"),
                "a node of the cells",
                "take the element out of the group, or mesh beside it",
            )
        };
        let of_dimension = |dimension| self.elements.iter().filter(move |e| e.kind.dimension() == dimension);
        let mut parts = MeshParts { points, ..MeshParts::default() };
        for element in of_dimension(D) {
            let mut cell = [0; N];
            for (corner, &tag) in cell.iter_mut().zip(&element.nodes) {
                *corner = point_of(tag).ok_or_else(|| unknown(tag))?;
            }
            if D == 2 && volume_and_gradients(&cell.map(|point: u32| parts.points[point as usize])).0 < 0.0 {
                cell.swap(1, 2);
            }
            parts.cells.push(cell);
        }
        let groups = self.names.iter().filter(|(dimension, ..)| *dimension as usize == D - 1);
        let tags: Vec<i32> = groups.clone().map(|(_, tag, _)| *tag).collect();
        parts.groups = groups.map(|(.., name)| name.clone()).collect();
        for element in of_dimension(D - 1).filter(|element| element.physical != 0) {
            let group = tags.iter().position(|&tag| tag == element.physical).ok_or_else(|| {
                let found =
                    format!("physical group {} of dimension {} without a name", element.physical, D - 1);
                source.error(
                    found,
                    "named groups",
                    "name it: Physical Surface(\"wall\") = {…} (in 2D: Physical Curve)",
                )
            })?;
            let mut face = [0; D];
            for (corner, &tag) in face.iter_mut().zip(&element.nodes) {
                *corner = point_of(tag).ok_or_else(|| unknown(tag))?;
            }
            parts.boundary.push((face, group as u32));
        }
        parts.periodic = periodic_axes(&self.periodic, &parts.points, point_of);
        Ok(parts)
    }

    /// The nodes that cells use.
    fn used_nodes<const D: usize>(&self, source: &Source) -> Result<UsedNodes<D>, MeshError> {
        let cells = self.elements.iter().filter(|element| element.kind.dimension() == D);
        let mut used: Vec<u64> = cells.flat_map(|cell| cell.nodes[..=D].iter().copied()).collect();
        used.sort_unstable();
        used.dedup();
        let kept: Vec<_> = self.nodes.iter().filter(|(tag, _)| used.binary_search(tag).is_ok()).collect();
        let mut order: Vec<(u64, u32)> =
            kept.iter().enumerate().map(|(i, (tag, _))| (*tag, i as u32)).collect();
        order.sort_unstable();
        if let Some(twice) = order.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(source.error(
                format!("node {} twice", twice[0].0),
                "each node once",
                "export the file again",
            ));
        }
        let extent = kept.iter().flat_map(|(_, x)| x).fold(0.0, |extent: f64, c| extent.max(c.abs()));
        let height = kept.first().map_or(0.0, |(_, x)| x[2]);
        let off_plane = kept.iter().find(|(_, x)| D == 2 && (x[2] - height).abs() > FLATNESS * extent);
        if let Some((tag, x)) = off_plane {
            return Err(source.error(
                format!("node {tag} at z = {}", x[2]),
                format!("all nodes at the z of the first, {height}"),
                "draw a mesh of dimension 2 in the x-y plane",
            ));
        }
        Ok((order, kept.iter().map(|(_, x)| std::array::from_fn(|k| x[k])).collect()))
    }
}

/// Sorts periodic pairs by the axis they are shifted along.
///
/// Files pair a corner with one other corner only, perhaps across several axes: so first all images of a node are gathered,
/// then every two of them that differ along one axis are paired, the image being the upper one.
fn periodic_axes<const D: usize>(
    pairs: &[(u64, u64)],
    points: &[Vector<D>],
    point_of: impl Fn(u64) -> Option<u32>,
) -> Vec<PeriodicPairs> {
    let mut master: Vec<u32> = (0..points.len() as u32).collect();
    for (image, other) in pairs.iter().filter_map(|&(a, b)| Some((point_of(a)?, point_of(b)?))) {
        let (a, b) = (root(&master, image), root(&master, other));
        master[a.max(b) as usize] = a.min(b);
    }
    let mut images: Vec<(u32, u32)> =
        (0..points.len() as u32).map(|point| (root(&master, point), point)).collect();
    images.sort_unstable();
    let mut axes: [Vec<(u32, u32)>; D] = std::array::from_fn(|_| Vec::new());
    for group in images.chunk_by(|a, b| a.0 == b.0) {
        for &(_, image) in group {
            for &(_, lower) in group {
                let shift = difference(&points[image as usize], &points[lower as usize]);
                let longest = shift.iter().fold(0.0, |longest: f64, s| longest.max(s.abs()));
                let mut moved = (0..D).filter(|&k| shift[k].abs() > FLATNESS * longest);
                if let (Some(axis), None) = (moved.next(), moved.next())
                    && shift[axis] > 0.0
                {
                    axes[axis].push((image, lower));
                }
            }
        }
    }
    let listed = axes.into_iter().enumerate().filter(|(_, pairs)| !pairs.is_empty());
    listed.map(|(axis, pairs)| PeriodicPairs { axis, pairs }).collect()
}
