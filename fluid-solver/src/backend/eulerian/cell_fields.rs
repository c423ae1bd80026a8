//! What the rows of a step's matrices share of a cell, computed once for all its corners.

use super::assembly::Ingredients;
use crate::element::simplex::{Vector, dot};
use crate::weak_form::{MassFlux, PorousCell, Resistance, relaxation_time};

/// Fields of a cell.
#[derive(Debug, Clone, Copy)]
pub struct CellFields<const D: usize, const N: usize> {
    /// What convects.
    pub flux: MassFlux<D, N>,
    /// τ₁ (m³ s/kg).
    pub relaxation_time: f64,
    /// ρε a·∇a (Pa/m).
    pub convection: Vector<D>,
    /// (ρε(g + b), w) − (a₁ρεⁿuⁿ + a₂ρεⁿ⁻¹uⁿ⁻¹, w) of the corners (N).
    pub force: [Vector<D>; N],
}

impl<const D: usize, const N: usize> CellFields<D, N> {
    /// The fields of a cell in the step to be assembled.
    pub fn new(ingredients: &Ingredients<'_, D, N>, cell: usize) -> Self {
        let Ingredients { mesh, density, viscosity, rule, state, .. } = *ingredients;
        let nodes = mesh.cell_nodes(cell);
        let here = |field: &[Vector<D>]| nodes.map(|node| field[node as usize]);
        let void = |field: &[f64]| PorousCell::new(mesh, cell, &nodes, field).void_fraction;
        let (convecting, void_fraction) = (here(ingredients.convecting), void(&state.void_fraction));
        let flux = MassFlux::new(&void_fraction, density, &convecting);

        let velocity = mean(&convecting);
        let factorial = if D == 2 { 2.0 } else { 6.0 };
        let relaxation_time = relaxation_time(&Resistance {
            density,
            viscosity,
            void_fraction: void_fraction.mean(),
            speed: dot(&velocity, &velocity).sqrt(),
            drag: nodes.iter().map(|&node| ingredients.drag[node as usize]).sum::<f64>() / N as f64,
            step: ingredients.step,
            size: root::<D>(factorial * mesh.volumes()[cell]),
        });

        let mass = density * mesh.volumes()[cell];
        let weight = void_fraction.moments(&here(ingredients.acceleration));
        let old = void(&state.void_fraction_old).moments(&here(&state.velocity_old));
        let older = void(&state.void_fraction_older).moments(&here(&state.velocity_older));
        let force = std::array::from_fn(|i| {
            std::array::from_fn(|k| mass * (weight[i][k] - rule.old() * old[i][k] - rule.older * older[i][k]))
        });
        let convection = flux.convection(&mesh.gradients()[cell], &convecting);
        Self { flux, relaxation_time, convection, force }
    }
}

/// The mean of the values at the corners.
pub fn mean<const D: usize, const N: usize>(values: &[Vector<D>; N]) -> Vector<D> {
    std::array::from_fn(|k| values.iter().map(|value| value[k]).sum::<f64>() / N as f64)
}

/// The edge of a square or cube of this size.
fn root<const D: usize>(size: f64) -> f64 {
    if D == 2 { size.sqrt() } else { size.cbrt() }
}
