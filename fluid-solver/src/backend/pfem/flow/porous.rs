//! What a cell with grains adds to the rows of its nodes.

use super::cell::Cell;
use crate::element::simplex::{Vector, dot, volume_and_areas};
use crate::grains::Compliance;
use crate::weak_form::Average;

/// Fields at the corners of a cell.
#[derive(Clone, Copy, Debug)]
pub struct Corners<const D: usize, const N: usize> {
    /// v_m (m/s).
    pub velocity: [Vector<D>; N],
    /// p (Pa).
    pub pressure: [f64; N],
    /// Residual of momentum per volume of fluid but for stresses and drag (N/m³).
    pub excess: [Vector<D>; N],
    /// Drag per volume (N/m³).
    pub drag: [Vector<D>; N],
    /// v − v̂ (m/s).
    pub slip: [Vector<D>; N],
    /// How the grains give way.
    pub compliance: [Compliance; N],
    /// v_{n+1} − u′ (m/s).
    pub velocity_change: [Vector<D>; N],
    /// p − p′ (Pa).
    pub pressure_change: [f64; N],
}

/// A cell between whose nodes the void fraction is linear.
#[derive(Clone, Copy, Debug)]
pub struct Porous<const D: usize, const N: usize> {
    /// ε.
    void: Average<N>,
    /// V∇ε (m²).
    slope: Vector<D>,
    /// τ with ε and drag in it (m³ s/kg).
    relaxation: f64,
}

impl<const D: usize, const N: usize> Porous<D, N> {
    /// A cell with ε at its corners; `resistance` is the drag coefficient per volume (kg/(m³ s)).
    ///
    /// τ = (ε(8μ/h² + ρ/(θΔt)) + β)⁻¹.
    pub fn new(cell: &Cell<D, N>, void_fraction: [f64; N], resistance: f64) -> Self {
        let void = Average::new(void_fraction);
        let slope = sum(&cell.areas, &void_fraction);
        let relaxation = 1.0 / (void.mean() / cell.relaxation + resistance);
        Self { void, slope, relaxation }
    }

    /// τ (m³ s/kg).
    pub fn relaxation(&self) -> f64 {
        self.relaxation
    }

    /// ∫εN_i (m³).
    pub fn fluid_volume(&self, cell: &Cell<D, N>, corner: usize) -> f64 {
        cell.volume * self.void.first(corner)
    }

    /// ∫∇(εN_i) (m²).
    pub fn areas(&self, cell: &Cell<D, N>) -> [Vector<D>; N] {
        let void = self.void.mean();
        cell.areas.map(|area| std::array::from_fn(|k| void * area[k] + self.slope[k] / N as f64))
    }

    /// ∫p∇(εN_i) (N).
    pub fn pressure_forces(&self, cell: &Cell<D, N>, p: &[f64; N]) -> [Vector<D>; N] {
        let pressure = Average::new(*p);
        let mean: f64 = (0..N).map(|j| pressure.first(j) * self.void.values[j]).sum();
        std::array::from_fn(|i| {
            std::array::from_fn(|k| mean * cell.areas[i][k] + pressure.first(i) * self.slope[k])
        })
    }

    /// The forces ∫(τ − p I)∇(εN_i) + N_i r∇(p − p′) (N) and the volume rows (m³/s)
    ///
    /// ∫N_i(ε∇·v + (v − v̂)·∇ε) + ε∇N_i·τ(ε(e + ∇p) + φ) − ∇N_i·(e(v_{n+1} − u′) − k∇(p − p′)).
    pub fn rows(&self, cell: &Cell<D, N>, at: &Corners<D, N>, curvature: f64) -> ([Vector<D>; N], [f64; N]) {
        let gradient = cell.velocity_gradient(&at.velocity);
        let rate: f64 = (0..D).map(|k| gradient[k][k]).sum();
        let shear = cell.viscosity * cell.inverse;
        let void = self.void.mean();
        let pressure = self.pressure_forces(cell, &at.pressure);
        let relayed = Average::new(at.compliance.map(|c| c.relayed));
        let entrained = Average::new(at.compliance.map(|c| c.entrained));
        let pressed = at.compliance.iter().map(|c| c.pressed).sum::<f64>() / N as f64;
        let change = sum(&cell.areas, &at.pressure_change);

        let areas = self.areas(cell);
        let forces = std::array::from_fn(|i| {
            let area = &areas[i];
            std::array::from_fn(|k| {
                let viscous: f64 = (0..D).map(|l| (gradient[k][l] + gradient[l][k]) * area[l]).sum();
                shear * (viscous - 2.0 / 3.0 * rate * area[k]) - pressure[i][k] + relayed.first(i) * change[k]
            })
        });

        let steepness = sum(&cell.areas, &at.pressure);
        let mean = |field: &[Vector<D>; N], k: usize| field.iter().map(|v| v[k]).sum::<f64>() / N as f64;
        let flux: Vector<D> = std::array::from_fn(|k| {
            let excess = cell.fullness * (void * mean(&at.excess, k) + mean(&at.drag, k))
                + void * cell.inverse * steepness[k];
            let carried: f64 = (0..N).map(|j| entrained.first(j) * at.velocity_change[j][k]).sum();
            void * self.relaxation * excess - carried + pressed * cell.inverse * change[k]
        });
        let growth = rate + curvature * volume_and_areas(&at.velocity).0;
        let transport = Average::new(at.slip.map(|slip| dot(&slip, &self.slope)));
        let volumes = std::array::from_fn(|i| {
            self.void.first(i) * growth + transport.first(i) + dot(&cell.areas[i], &flux)
        });
        (forces, volumes)
    }

    /// ∫N_i ∇·((ε + e)v) − ∮N_i e v·n, e being what the grains are entrained by (m³/s).
    pub fn divergence(&self, cell: &Cell<D, N>, v: &[Vector<D>; N], entrained: [f64; N]) -> [f64; N] {
        let gradient = cell.velocity_gradient(v);
        let rate: f64 = (0..D).map(|k| gradient[k][k]).sum();
        let entrained = Average::new(entrained);
        let carried: Vector<D> = std::array::from_fn(|k| (0..N).map(|j| entrained.first(j) * v[j][k]).sum());
        let transport = Average::new(v.map(|v| dot(&v, &self.slope)));
        std::array::from_fn(|i| {
            self.void.first(i) * rate + transport.first(i) - dot(&cell.areas[i], &carried)
        })
    }

    /// ∫p∇(εN_i) − N_i r∇p (N), r being what the grains relay.
    pub fn relayed_forces(&self, cell: &Cell<D, N>, p: &[f64; N], relayed: [f64; N]) -> [Vector<D>; N] {
        let (forces, slope) = (self.pressure_forces(cell, p), sum(&cell.areas, p));
        let relayed = Average::new(relayed);
        std::array::from_fn(|i| std::array::from_fn(|k| forces[i][k] - relayed.first(i) * slope[k]))
    }

    /// What an increment of pressure moves through the cell: κ = (ε + r)(ε + e)/(ερ/(θΔt) + β) + k (m³ s/kg).
    pub fn mobility(&self, inertia: f64, resistance: f64, compliance: &[Compliance; N]) -> f64 {
        let mean = |part: fn(&Compliance) -> f64| compliance.iter().map(part).sum::<f64>() / N as f64;
        let (relayed, entrained) = (mean(|c| c.relayed), mean(|c| c.entrained));
        let void = self.void.mean();
        (void + relayed) * (void + entrained) / (void * inertia + resistance) + mean(|c| c.pressed)
    }
}

/// V∇f = Σ f_i a_i of a linear field.
fn sum<const D: usize, const N: usize>(areas: &[Vector<D>; N], values: &[f64; N]) -> Vector<D> {
    std::array::from_fn(|k| areas.iter().zip(values).map(|(area, value)| value * area[k]).sum())
}
