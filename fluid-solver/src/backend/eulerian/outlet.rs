//! Outlets: the stated pressure and what leaves through them.

use crate::boundary::{Boundaries, Condition};
use crate::element::simplex::{Vector, difference, dot};
use crate::mesh::Mesh;
use crate::weak_form::Facet;
use linear::BlockCsr;

/// A face of an outlet.
#[derive(Debug, Clone, Copy)]
pub struct OutletFace<const D: usize> {
    nodes: [u32; D],
    facet: Facet<D>,
    /// Outer pressure at the corners (Pa).
    pressure: [f64; D],
}

/// All outlets of a mesh.
#[derive(Debug, Clone, Default)]
pub struct Outlets<const D: usize> {
    faces: Vec<OutletFace<D>>,
    reference: Option<(Vector<D>, f64)>,
}

impl<const D: usize> Outlets<D> {
    /// The outlets, each with p_o at its centre and hydrostatic for the weight ρg (Pa/m) along it.
    pub fn new<const N: usize>(mesh: &Mesh<D, N>, boundaries: &Boundaries<D>, weight: &Vector<D>) -> Self {
        let mut outlets = Self { faces: Vec::new(), reference: None };
        for group in 0..mesh.groups().len() as u32 {
            let Condition::Outlet { pressure } = boundaries.of(group) else { continue };
            let faces = || mesh.boundary().iter().filter(|face| face.group == group);
            let centre = centroid(faces().map(|face| (mesh.area_vector(face), mesh.face_vertices(face))));
            outlets.reference.get_or_insert((centre, *pressure));
            outlets.faces.extend(faces().map(|face| OutletFace {
                nodes: face.points.map(|point| mesh.node_of(point)),
                facet: Facet { area: mesh.area_vector(face) },
                pressure: mesh.face_vertices(face).map(|x| pressure + dot(weight, &difference(&x, &centre))),
            }));
        }
        outlets
    }

    /// Centre and pressure of the first outlet.
    pub fn reference(&self) -> Option<(Vector<D>, f64)> {
        self.reference
    }

    /// ∮ N_a n of the outlets at each of their corners (m²), with the node.
    pub fn openings(&self) -> impl Iterator<Item = (u32, Vector<D>)> + '_ {
        self.faces
            .iter()
            .flat_map(|face| face.nodes.map(|node| (node, face.facet.area.map(|a| a / D as f64))))
    }

    /// Adds ∮ρε (a·n)₊ u·w to the matrix.
    pub fn add_outflow(
        &self,
        density: f64,
        void: &[f64],
        convecting: &[Vector<D>],
        matrix: &mut BlockCsr<D>,
    ) {
        for face in &self.faces {
            let outflow = face.outflow(void, convecting);
            for (&i, row) in face.nodes.iter().zip(outflow) {
                for (&j, value) in face.nodes.iter().zip(row) {
                    let block = std::array::from_fn(|k| {
                        std::array::from_fn(|l| if k == l { density * value } else { 0.0 })
                    });
                    matrix.add(i as usize, j as usize, &block);
                }
            }
        }
    }

    /// Calls `add(node, −∮ε p_o w·n)` for every corner (N).
    pub fn for_each_traction(&self, void: &[f64], mut add: impl FnMut(usize, Vector<D>)) {
        for face in &self.faces {
            let void = face.nodes.map(|node| void[node as usize]);
            for (a, &node) in face.nodes.iter().enumerate() {
                add(node as usize, face.facet.triple(&void, &face.pressure, a).map(|force| -force));
            }
        }
    }

    /// Forces of the outlets on the fluid: −∮ε p_o n − ∮ρε (a·n)₊ u, and Σ of the magnitudes of the parts (N).
    pub fn force(
        &self,
        density: f64,
        void: &[f64],
        convecting: &[Vector<D>],
        velocity: &[Vector<D>],
    ) -> (Vector<D>, f64) {
        let (mut sum, mut scale) = ([0.0; D], 0.0);
        let mut add = |part: Vector<D>| {
            for k in 0..D {
                sum[k] += part[k];
                scale += part[k].abs();
            }
        };
        self.for_each_traction(void, |_, force| add(force));
        for face in &self.faces {
            for row in face.outflow(void, convecting) {
                for (&j, value) in face.nodes.iter().zip(row) {
                    add(velocity[j as usize].map(|u| -density * value * u));
                }
            }
        }
        (sum, scale)
    }
}

impl<const D: usize> OutletFace<D> {
    fn outflow(&self, void: &[f64], convecting: &[Vector<D>]) -> [[f64; D]; D] {
        self.facet.outflow(
            &self.nodes.map(|node| void[node as usize]),
            &self.nodes.map(|node| convecting[node as usize]),
        )
    }
}

fn centroid<const D: usize>(faces: impl Iterator<Item = (Vector<D>, [Vector<D>; D])>) -> Vector<D> {
    let (mut sum, mut total) = ([0.0; D], 0.0);
    for (area, vertices) in faces {
        let area = dot(&area, &area).sqrt();
        total += area;
        for k in 0..D {
            sum[k] += area * vertices.iter().map(|x| x[k]).sum::<f64>() / D as f64;
        }
    }
    sum.map(|component| component / total)
}
