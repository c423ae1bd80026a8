//! Fields recovered at the nodes, as grains sample them.

use crate::element::simplex::Vector;
use crate::mesh::Mesh;
use crate::parallel::for_each_node;
use crate::weak_form::{gradient, share, shear_rate, velocity_gradient, viscous_stress};

/// What grains feel of the fluid, at the nodes; all *lumped* recoveries, |N_a|⁻¹ ∫ N_a ·.
///
/// With the weights w of the deposit, Σ_p V_p Σ_a w_pa G_a = ∫(1 − ε)∇p exactly: what ε∇p leaves to the grains is what
/// they receive.
#[derive(Debug, Clone, Copy)]
pub struct Recovered<const D: usize> {
    /// G_a = ∫ N_a ∇p/|N_a| (Pa/m).
    pub pressure_gradient: Vector<D>,
    /// ∇(p − p′), p′ the pressure before the last solution (Pa/m).
    pub gradient_change: Vector<D>,
    /// D_a = (−∫ τ∇N_a + ∮ N_a τ·n)/|N_a| (Pa/m).
    pub stress_divergence: Vector<D>,
    /// Du/Dt (m/s²).
    pub acceleration: Vector<D>,
    /// ∇×u (1/s).
    pub vorticity: [f64; 3],
    /// γ̇ = √(½E:E), E = ∇u + ∇uᵀ − ⅔∇·u (1/s).
    pub shear_rate: f64,
}

impl<const D: usize> Recovered<D> {
    const ZERO: Self = Self {
        pressure_gradient: [0.0; D],
        gradient_change: [0.0; D],
        stress_divergence: [0.0; D],
        acceleration: [0.0; D],
        vorticity: [0.0; 3],
        shear_rate: 0.0,
    };
}

/// The rate of the velocity at the nodes (m/s²).
#[derive(Debug, Clone, Copy)]
pub enum Rate<'a, const D: usize> {
    /// ∂u/∂t, of nodes that stay: Du/Dt = ∂u/∂t + u·∇u.
    Local(&'a [Vector<D>]),
    /// Du/Dt, of nodes that move with the fluid.
    Material(&'a [Vector<D>]),
}

/// Nodal fields whose derivatives grains feel.
#[derive(Debug, Clone, Copy)]
pub struct Felt<'a, const D: usize> {
    /// u (m/s).
    pub velocity: &'a [Vector<D>],
    /// p (Pa).
    pub pressure: &'a [f64],
    /// p′ (Pa).
    pub pressure_before: &'a [f64],
    /// Its rate.
    pub rate: Rate<'a, D>,
    /// Dynamic viscosity μ.
    pub viscosity: Viscosity<'a>,
}

/// Dynamic viscosity μ (Pa s).
#[derive(Debug, Clone, Copy)]
pub enum Viscosity<'a> {
    /// One everywhere.
    Uniform(f64),
    /// Of each cell.
    OfCells(&'a [f64]),
}

impl Viscosity<'_> {
    fn of(self, cell: usize) -> f64 {
        match self {
            Self::Uniform(viscosity) => viscosity,
            Self::OfCells(viscosities) => viscosities[cell],
        }
    }
}

/// Recovers the fields; `corners` gives the cells around a node, each with which of its corners the node is, and `measure`
/// |N_a| is that of the nodes when the grains were placed, 0 for a node of no cell.
pub fn recover<const D: usize, const N: usize, C>(
    mesh: &Mesh<D, N>,
    measure: &[f64],
    corners: impl Fn(usize) -> C + Sync,
    felt: Felt<'_, D>,
    recovered: &mut Vec<Recovered<D>>,
) where
    C: Iterator<Item = (usize, usize)>,
{
    recovered.resize(mesh.node_count(), Recovered::ZERO);
    let mut traction = vec![[0.0; D]; mesh.node_count()];
    for face in mesh.boundary() {
        let area = mesh.area_vector(face);
        let stress = felt.stress(mesh, face.cell as usize);
        for point in face.points {
            let sum = &mut traction[mesh.node_of(point) as usize];
            for k in 0..D {
                sum[k] += (0..D).map(|m| stress[k][m] * area[m]).sum::<f64>() / D as f64;
            }
        }
    }
    for_each_node(recovered, |node, value| {
        *value = match measure[node] {
            0.0 => Recovered::ZERO,
            measure => felt.at(mesh, (node, measure), corners(node), &traction[node]),
        };
    });
}

impl<const D: usize> Felt<'_, D> {
    fn at<const N: usize>(
        &self,
        mesh: &Mesh<D, N>,
        (node, measure): (usize, f64),
        corners: impl Iterator<Item = (usize, usize)>,
        traction: &Vector<D>,
    ) -> Recovered<D> {
        let mut sum = Recovered { stress_divergence: *traction, ..Recovered::ZERO };
        for (cell, a) in corners {
            let nodes = mesh.cell_nodes(cell);
            let (volume, gradients) = (mesh.volumes()[cell], &mesh.gradients()[cell]);
            let velocity = nodes.map(|node| self.velocity[node as usize]);
            let slope = velocity_gradient(gradients, &velocity);
            let stress = viscous_stress(self.viscosity.of(cell), &slope);
            let pressure = gradient(gradients, &nodes.map(|node| self.pressure[node as usize]));
            let change = |node: u32| self.pressure[node as usize] - self.pressure_before[node as usize];
            let change = gradient(gradients, &nodes.map(change));
            // ⟨N_a u⟩
            let mean: Vector<D> =
                std::array::from_fn(|k| (0..N).map(|j| share::<N>(a, j) * velocity[j][k]).sum());
            for k in 0..D {
                sum.pressure_gradient[k] += volume / N as f64 * pressure[k];
                sum.gradient_change[k] += volume / N as f64 * change[k];
                for m in 0..D {
                    sum.stress_divergence[k] -= volume * stress[k][m] * gradients[a][m];
                    sum.acceleration[k] += volume * slope[k][m] * mean[m];
                }
            }
            sum.shear_rate += volume / N as f64 * shear_rate(&slope);
            let curl = curl(&slope);
            for k in 0..3 {
                sum.vorticity[k] += volume / N as f64 * curl[k];
            }
        }
        Recovered {
            pressure_gradient: sum.pressure_gradient.map(|value| value / measure),
            gradient_change: sum.gradient_change.map(|value| value / measure),
            stress_divergence: sum.stress_divergence.map(|value| value / measure),
            acceleration: match self.rate {
                Rate::Local(rate) => std::array::from_fn(|k| rate[node][k] + sum.acceleration[k] / measure),
                Rate::Material(rate) => rate[node],
            },
            vorticity: sum.vorticity.map(|value| value / measure),
            shear_rate: sum.shear_rate / measure,
        }
    }

    /// τ in a cell (Pa).
    pub fn stress<const N: usize>(&self, mesh: &Mesh<D, N>, cell: usize) -> [Vector<D>; D] {
        let velocity = mesh.cell_nodes(cell).map(|node| self.velocity[node as usize]);
        viscous_stress(self.viscosity.of(cell), &velocity_gradient(&mesh.gradients()[cell], &velocity))
    }
}

/// ∇(p − p′) at the nodes (Pa/m).
pub fn gradient_changes<const D: usize>(recovered: &[Recovered<D>]) -> Vec<Vector<D>> {
    recovered.iter().map(|recovered| recovered.gradient_change).collect()
}

/// ∇×u from (∇u)_km = ∂u_k/∂x_m; along z in 2D.
fn curl<const D: usize>(slope: &[Vector<D>; D]) -> [f64; 3] {
    let at = |k: usize, m: usize| if k < D && m < D { slope[k][m] } else { 0.0 };
    [at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1)]
}
