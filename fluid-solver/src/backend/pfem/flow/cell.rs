//! What a cell adds to the rows of its nodes.

use super::rheology::{Law, Rheology};
use crate::element::simplex::{Vector, dot, longest_edge, volume_and_areas};

/// A cell in the middle of the step.
#[derive(Clone, Copy, Debug)]
pub struct Cell<const D: usize, const N: usize> {
    /// V (m³), signed.
    pub volume: f64,
    /// a_i = V∇N_i, finite in the thinnest cell.
    pub areas: [Vector<D>; N],
    /// 1/V, V not less than that of a sliver.
    pub inverse: f64,
    /// V over what is taken for it: 1, less in slivers, negative in cells that have turned over.
    pub fullness: f64,
    /// τ (m³ s/kg).
    pub relaxation: f64,
    /// μ (Pa s).
    pub viscosity: f64,
    /// μγ̇ (Pa).
    pub shear_stress: f64,
}

/// The share of the volume of a regular cell of the same longest edge below which V is not taken in a divisor. In space
/// slivers are in every mesh: their stabilisation and stress are then V/(that volume) of what they are, or one such cell
/// would be as stiff as a thousand others.
const SLIVER: [f64; 2] = [1e-6, 0.02];

/// The volume of a regular simplex of edge 1.
pub const fn regular_volume(dimension: usize) -> f64 {
    if dimension == 2 { 0.433_012_701_892_219_3 } else { 0.117_851_130_197_757_93 }
}

/// What is taken for the volume of a cell in a divisor.
fn size<const D: usize, const N: usize>(corners: &[Vector<D>; N], volume: f64) -> f64 {
    volume.max(SLIVER[D - 2] * regular_volume(D) * longest_edge(corners).powi(D as i32))
}

/// μ of a cell whose corners have these velocities, less in slivers: what the flow multiplies with V and ∇v (Pa s).
pub fn viscosity<const D: usize, const N: usize>(
    corners: &[Vector<D>; N],
    v: &[Vector<D>; N],
    rheology: &Rheology,
) -> f64 {
    if rheology.is_newtonian() {
        let (volume, _) = volume_and_areas(corners);
        return volume / size(corners, volume) * rheology.viscosity(0.0);
    }
    let cell = Cell::new(corners, v, 0.0, rheology);
    cell.fullness * cell.viscosity
}

impl<const D: usize, const N: usize> Cell<D, N> {
    /// A cell with these corners that move with v; `inertia` is ρ/(θΔt).
    ///
    /// τ = (8μ/h² + ρ/(θΔt))⁻¹ with h = 2V^{1/D}.
    ///
    /// Source: Oñate, Franci and Carbonell, *Int. J. Numer. Meth. Fluids* 74 (2014) 699.
    pub fn new(corners: &[Vector<D>; N], v: &[Vector<D>; N], inertia: f64, rheology: &Rheology) -> Self {
        let (volume, areas) = volume_and_areas(corners);
        let size = size(corners, volume);
        let h = 2.0 * if D == 2 { size.sqrt() } else { size.cbrt() };
        let (inverse, fullness) = (1.0 / size, volume / size);
        let mut cell =
            Self { volume, areas, inverse, fullness, relaxation: 0.0, viscosity: 0.0, shear_stress: 0.0 };
        let shear_rate = cell.shear_rate(v);
        cell.viscosity = rheology.viscosity(shear_rate);
        cell.shear_stress = cell.viscosity * shear_rate;
        cell.relaxation = 1.0 / (8.0 * cell.viscosity / (h * h) + inertia);
        cell
    }

    /// V∇v = Σ v_j ⊗ a_j.
    pub fn velocity_gradient(&self, v: &[Vector<D>; N]) -> [Vector<D>; D] {
        let mut gradient = [[0.0; D]; D];
        for (v, a) in v.iter().zip(&self.areas) {
            for k in 0..D {
                for l in 0..D {
                    gradient[k][l] += v[k] * a[l];
                }
            }
        }
        gradient
    }

    /// E = ∇v + ∇vᵀ − ⅔∇·v (1/s); in the plane its third diagonal entry is what the trace lacks.
    pub fn strain_rate(&self, v: &[Vector<D>; N]) -> Tensor<D> {
        let gradient = self.velocity_gradient(v);
        let mean = 2.0 / 3.0 * (0..D).map(|k| gradient[k][k]).sum::<f64>();
        std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                let isotropic = if k == l { mean } else { 0.0 };
                self.inverse * (gradient[k][l] + gradient[l][k] - isotropic)
            })
        })
    }

    /// γ̇ = √(½E:E) (1/s).
    fn shear_rate(&self, v: &[Vector<D>; N]) -> f64 {
        let strain_rate = self.strain_rate(v);
        product(&strain_rate, &strain_rate).sqrt()
    }

    /// Adds ∫κ'∇·v ∇N_i to forces (N), κ' = `bulk` V^{2/D}.
    pub fn resist_expansion(&self, bulk: f64, v: &[Vector<D>; N], forces: &mut [Vector<D>; N]) {
        let rate: f64 = v.iter().zip(&self.areas).map(|(v, a)| dot(v, a)).sum();
        let stress = bulk * self.inverse.powf(1.0 - 2.0 / D as f64) * rate;
        for (force, area) in forces.iter_mut().zip(&self.areas) {
            (0..D).for_each(|k| force[k] += stress * area[k]);
        }
    }

    /// a_i·w (m³/s) with w = τ(e + ∇p), e being the residual of momentum at the corners but for its stresses (N/m³): the
    /// volume that goes over from each corner to others where the volume rows are met.
    pub fn passing(&self, p: &[f64; N], e: &[Vector<D>; N]) -> [f64; N] {
        let drift: Vector<D> = std::array::from_fn(|k| {
            let mean = e.iter().map(|e| e[k]).sum::<f64>() / N as f64;
            let slope: f64 = p.iter().zip(&self.areas).map(|(p, a)| p * a[k]).sum();
            self.relaxation * (self.fullness * mean + self.inverse * slope)
        });
        self.areas.map(|a| dot(&a, &drift))
    }

    /// The forces ∫(τ − p I)∇N_i (N) and the volume rows ∫N_i∇·v + τ∇N_i·(e + ∇p) (m³/s), whose second part is
    /// what passes.
    ///
    /// `curvature` times V det ∇v is added to the rate of volume, N_i sharing it: with Δt²/4 in space the sum is
    /// (V_{n+1} − V_n)/Δt itself.
    pub fn rows(
        &self,
        v: &[Vector<D>; N],
        p: &[f64; N],
        passing: &[f64; N],
        curvature: f64,
    ) -> ([Vector<D>; N], [f64; N]) {
        let share = 1.0 / N as f64;
        let gradient = self.velocity_gradient(v);
        let rate: f64 = (0..D).map(|k| gradient[k][k]).sum();
        let pressure = share * p.iter().sum::<f64>();
        let shear = self.viscosity * self.inverse;
        let stress: [Vector<D>; D] = std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                let isotropic = if k == l { 2.0 / 3.0 * shear * rate + pressure } else { 0.0 };
                shear * (gradient[k][l] + gradient[l][k]) - isotropic
            })
        });
        // V det ∇v is the volume that v spans.
        let volume = share * (rate + curvature * volume_and_areas(v).0);
        (
            self.areas.map(|a| std::array::from_fn(|k| dot(&stress[k], &a))),
            passing.map(|passing| volume + passing),
        )
    }
}

/// By how much the volume that passes brings less momentum to the corners than with their own velocities, per density
/// (m⁴/s²): ½ Σ_j q_ij (v_i − v_j), q_ij = (q_j − q_i)/N from j to i, which is −½ (q_i (v_i − v̄) + Σ_j q_j v_j/N).
///
/// The corner i gains −q_i, and Σ q_i = 0. With the velocity half of whence it comes and half of whither it goes, Σ V_i v_i and
/// Σ ½ V_i |v_i|² are kept.
pub fn exchange<const D: usize, const N: usize>(passing: &[f64; N], v: &[Vector<D>; N]) -> [Vector<D>; N] {
    let share = 0.5 / N as f64;
    let (mut carried, mut mean) = ([0.0; D], [0.0; D]);
    for (q, v) in passing.iter().zip(v) {
        for k in 0..D {
            carried[k] += share * q * v[k];
            mean[k] += share * v[k];
        }
    }
    std::array::from_fn(|i| std::array::from_fn(|k| passing[i] * (mean[k] - 0.5 * v[i][k]) - carried[k]))
}

/// A matrix by rows.
pub type Tensor<const D: usize> = [Vector<D>; D];

/// ½a:b of tensors without trace; in the plane with the entries that these have across it.
pub fn product<const D: usize>(a: &Tensor<D>, b: &Tensor<D>) -> f64 {
    let trace = |tensor: &Tensor<D>| (0..D).map(|k| tensor[k][k]).sum::<f64>();
    let within: f64 = a.iter().zip(b).map(|(a, b)| dot(a, b)).sum();
    0.5 * (within + trace(a) * trace(b))
}

#[cfg(test)]
mod tests {
    use super::super::rheology::Newtonian;
    use super::*;

    const fn newtonian(viscosity: f64) -> Rheology {
        Rheology::Newtonian(Newtonian { viscosity })
    }

    const CORNERS: [[f64; 3]; 4] = [[0.1, 0.2, 0.3], [1.3, 0.1, 0.2], [0.2, 1.5, 0.4], [0.3, 0.1, 1.9]];

    #[test]
    fn a_rigid_motion_meets_no_stress_and_changes_no_volume() {
        let cell = Cell::new(&CORNERS, &[[0.0; 3]; 4], 2.0, &newtonian(3.0));
        let v = CORNERS.map(|x| [1.0 - 2.0 * x[1] + 0.5 * x[2], 3.0 + 2.0 * x[0] - x[2], x[1] - 0.5 * x[0]]);
        let (forces, volumes) = cell.rows(&v, &[0.0; 4], &[0.0; 4], 0.0);
        assert!(forces.iter().flatten().chain(&volumes).all(|row| row.abs() < 1e-14), "{forces:?}");
    }

    #[test]
    fn the_volume_rows_sum_to_the_change_of_volume_itself() {
        let v = [[0.3, -0.1, 0.2], [-0.4, 0.2, 0.1], [0.5, 0.6, -0.7], [-0.2, 0.3, 0.9]];
        let length = 0.5;
        let at = |share: f64| -> [[f64; 3]; 4] {
            std::array::from_fn(|i| std::array::from_fn(|k| CORNERS[i][k] + share * length * v[i][k]))
        };
        let (before, after) = (volume_and_areas(&at(0.0)).0, volume_and_areas(&at(1.0)).0);
        let middle = Cell::new(&at(0.5), &v, 1.0, &newtonian(0.0));
        let (_, volumes) = middle.rows(&v, &[0.0; 4], &[0.0; 4], 0.25 * length * length);
        assert!((volumes.iter().sum::<f64>() - (after - before) / length).abs() < 1e-14);
    }

    #[test]
    fn simple_shear_has_the_rate_of_its_one_slope() {
        let cell = Cell::new(&CORNERS, &[[0.0; 3]; 4], 2.0, &newtonian(3.0));
        let rate = cell.shear_rate(&CORNERS.map(|x| [0.0, -7.0 * x[0], 0.0]));
        assert!((rate - 7.0).abs() < 1e-13, "{rate}");
    }

    #[test]
    fn what_is_in_equilibrium_leaves_the_volume_rows_empty_in_slivers_and_cells_turned_over_too() {
        let slope = [4.0, -5.0, 6.0];
        for height in [1.9, 1e-3, 0.0, -1e-3] {
            let mut corners = CORNERS;
            corners[3] = [0.8, 0.7, 0.3 + height];
            let cell = Cell::new(&corners, &[[0.0; 3]; 4], 2.0, &newtonian(3.0));
            let pressure = corners.map(|x| dot(&x, &slope) + 7.0);
            let passing = cell.passing(&pressure, &[slope.map(|s| -s); 4]);
            assert!(passing.iter().all(|passing| passing.abs() < 1e-14), "{passing:?}");
        }
    }

    #[test]
    fn what_passes_between_corners_keeps_momentum_and_energy() {
        let v = [[0.3, -0.1, 0.2], [-0.4, 0.2, 0.1], [0.5, 0.6, -0.7], [-0.2, 0.3, 0.9]];
        let cell = Cell::new(&CORNERS, &v, 2.0, &newtonian(3.0));
        let passing = cell.passing(&[3.0, -1.0, 4.0, 2.0], &v);
        let gained = exchange(&passing, &v);
        for k in 0..3 {
            let momentum: f64 = (0..4).map(|i| gained[i][k] + passing[i] * v[i][k]).sum();
            assert!(momentum.abs() < 1e-15, "{momentum:e}");
        }
        let energy: f64 = (0..4).map(|i| dot(&gained[i], &v[i]) + 0.5 * passing[i] * dot(&v[i], &v[i])).sum();
        assert!(energy.abs() < 1e-15, "{energy:e}");
    }
}
