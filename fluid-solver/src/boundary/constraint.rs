//! Which velocity components are prescribed, and to what.

use super::condition::INLET_RANK;
use super::normal::wall_normals;
use super::profile::inlet_velocity;
use super::{Boundaries, BoundaryError, Condition, Inflow, VelocityField};
use crate::element::simplex::Vector;
use crate::mesh::{BoundaryFace, Mesh};
use linear::dense::{self, Block};

/// The constrained nodes of a mesh.
///
/// A node's velocity is u = P u + (I − P) g with P the projector onto its free directions and g what is prescribed.
pub struct Constraints<const D: usize> {
    nodes: Vec<Node<D>>,
}

/// A constrained node.
pub struct Node<const D: usize> {
    /// The node.
    pub node: u32,
    /// Projector P onto the free directions; zero where the whole velocity is prescribed.
    pub free: Block<D>,
    position: Vector<D>,
    prescribed: Prescribed<D>,
    /// The prescribed velocity is superficial: n_f u is given, not u.
    superficial: bool,
}

#[derive(Clone)]
enum Prescribed<const D: usize> {
    Constant(Vector<D>),
    Field(VelocityField<D>),
}

impl<const D: usize> Constraints<D> {
    /// The constraints that conditions put on the nodes of a mesh.
    ///
    /// Where boundaries meet, sticking walls win over moving ones, these over inlets, inlets over slip walls.
    ///
    /// # Errors
    /// An inlet of stated speed without a node that does not stick.
    pub fn new<const N: usize>(mesh: &Mesh<D, N>, boundaries: &Boundaries<D>) -> Result<Self, BoundaryError> {
        let mut rank = vec![0u8; mesh.node_count()];
        for face in mesh.boundary() {
            for point in face.points {
                let rank = &mut rank[mesh.node_of(point) as usize];
                *rank = (*rank).max(boundaries.of(face.group).rank());
            }
        }
        let sticks: Vec<bool> = {
            let mut sticks = vec![false; mesh.node_count()];
            for face in mesh.boundary().iter().filter(|face| boundaries.of(face.group).sticks()) {
                face.points.iter().for_each(|&point| sticks[mesh.node_of(point) as usize] = true);
            }
            sticks
        };
        let mut nodes: Vec<Option<Node<D>>> = (0..mesh.node_count()).map(|_| None).collect();
        let mut set = |node: u32, own: u8, free: Block<D>, prescribed: Prescribed<D>| {
            let slot = &mut nodes[node as usize];
            if rank[node as usize] == own && slot.is_none() {
                // Of the conditions only an inlet states a flux.
                let superficial = own == INLET_RANK;
                *slot =
                    Some(Node { node, free, position: mesh.nodes()[node as usize], prescribed, superficial });
            }
        };
        for (group, name) in mesh.groups().iter().enumerate() {
            let condition = boundaries.of(group as u32);
            let faces: Vec<&BoundaryFace<D>> =
                mesh.boundary().iter().filter(|face| face.group as usize == group).collect();
            let mut set_all = |prescribed: Prescribed<D>| {
                for point in faces.iter().flat_map(|face| face.points) {
                    set(mesh.node_of(point), condition.rank(), [[0.0; D]; D], prescribed.clone());
                }
            };
            match condition {
                Condition::NoSlip => set_all(Prescribed::Constant([0.0; D])),
                Condition::MovingWall(field) | Condition::Inlet(Inflow::Velocity(field)) => {
                    set_all(Prescribed::Field(field.clone()));
                }
                Condition::Inlet(Inflow::Speed { mean, profile }) => {
                    let velocity = inlet_velocity(mesh, &faces, &sticks, *mean, *profile)
                        .ok_or_else(|| BoundaryError::NoFreeNode { name: name.clone() })?;
                    for (node, velocity) in velocity {
                        set(node, condition.rank(), [[0.0; D]; D], Prescribed::Constant(velocity));
                    }
                }
                Condition::Slip | Condition::Outlet { .. } => {}
            }
        }
        let slip: Vec<&BoundaryFace<D>> = mesh
            .boundary()
            .iter()
            .filter(|face| matches!(boundaries.of(face.group), Condition::Slip))
            .collect();
        for (node, normals) in wall_normals(mesh, &slip) {
            set(node, Condition::<D>::Slip.rank(), projector(&normals), Prescribed::Constant([0.0; D]));
        }
        Ok(Self { nodes: nodes.into_iter().flatten().collect() })
    }

    /// The constrained nodes, ascending.
    pub fn nodes(&self) -> &[Node<D>] {
        &self.nodes
    }

    /// Gives the prescribed components their values at a time (s); what is stated at an inlet is the superficial velocity
    /// n_f u, the flux per area whatever the grains leave free.
    pub fn prescribe(&self, time: f64, void_fraction: &[f64], velocity: &mut [Vector<D>]) {
        for constrained in &self.nodes {
            let given = match &constrained.prescribed {
                Prescribed::Constant(velocity) => *velocity,
                Prescribed::Field(field) => field(&constrained.position, time),
            };
            let share = if constrained.superficial { void_fraction[constrained.node as usize] } else { 1.0 };
            let given = given.map(|component| component / share);
            let u = &mut velocity[constrained.node as usize];
            let change = std::array::from_fn(|k| u[k] - given[k]);
            let free = dense::multiply(&constrained.free, &change);
            *u = std::array::from_fn(|k| given[k] + free[k]);
        }
    }

    /// Removes the constrained components.
    pub fn project(&self, vector: &mut [Vector<D>]) {
        for constrained in &self.nodes {
            let value = &mut vector[constrained.node as usize];
            *value = dense::multiply(&constrained.free, value);
        }
    }

    /// Σ over the nodes of the constrained components.
    pub fn sum_of_constrained(&self, vector: &[Vector<D>]) -> Vector<D> {
        self.nodes.iter().fold([0.0; D], |sum, constrained| {
            let value = &vector[constrained.node as usize];
            let free = dense::multiply(&constrained.free, value);
            std::array::from_fn(|k| sum[k] + (value[k] - free[k]))
        })
    }
}

/// I − Σ n nᵀ.
fn projector<const D: usize>(normals: &[Vector<D>]) -> Block<D> {
    if normals.len() == D {
        return [[0.0; D]; D];
    }
    std::array::from_fn(|k| {
        std::array::from_fn(|l| {
            let identity = f64::from(u8::from(k == l));
            identity - normals.iter().map(|n| n[k] * n[l]).sum::<f64>()
        })
    })
}
