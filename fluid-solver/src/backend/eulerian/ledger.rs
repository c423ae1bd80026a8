//! The books of a window.

use super::compensated::CompensatedSum;
use super::flow::Flow;
use super::krylov::split;
use super::time_rule::TimeRule;
use crate::backend::Step;
use crate::element::simplex::{Vector, dot, in_space};
use crate::grains::{Exchange, Recovered, gradient_changes};
use crate::weak_form::{Facet, PorousCell};
use interface::ledger::FluidLedger;
use rayon::prelude::*;
use std::ops::Range;

/// Cells summed in one go; fixed, so that nothing depends on the number of threads.
const CELLS: usize = 1024;

/// A sum of vectors and of the sizes of its terms.
#[derive(Debug, Clone, Copy)]
struct Sum<const D: usize> {
    components: [CompensatedSum; D],
    scale: f64,
}

impl<const D: usize> Sum<D> {
    fn new() -> Self {
        Self { components: [CompensatedSum::default(); D], scale: 0.0 }
    }

    fn add(&mut self, term: Vector<D>) {
        for k in 0..D {
            self.components[k].add(term[k]);
            self.scale += term[k].abs();
        }
    }

    fn join(&mut self, part: &Self) {
        for k in 0..D {
            self.components[k].add(part.components[k].value());
        }
        self.scale += part.scale;
    }

    fn value(&self) -> Vector<D> {
        self.components.map(CompensatedSum::value)
    }
}

impl<const D: usize, const N: usize> Flow<D, N> {
    /// The books of the step solved last; volumes, momenta and forces are those of a slab of `depth` (m) in 2D.
    ///
    /// Every entry is an integral of its own, none is the remainder of the others: `boundary` is the residual of the
    /// constrained rows, the tractions and fluxes of the outlets, and the traction ∮(1 − ε)(τ − p)n that the grains at
    /// the boundary would else be given by it twice.
    pub fn ledger(
        &self,
        step: Step,
        depth: f64,
        exchange: &Exchange<D>,
        recovered: &[Recovered<D>],
    ) -> FluidLedger {
        let (density, state) = (self.properties.density, &self.state);
        let (rows, _) = split::<D>(&self.work.rows);
        let rule = self.work.rule;

        let inertia = self.inertia(rule);
        let mut boundary = Sum::new();
        boundary.add(self.constraints.sum_of_constrained(rows));
        for node in self.constraints.nodes() {
            boundary.scale += rows[node.node as usize].iter().map(|force| force.abs()).sum::<f64>();
        }
        let (value, scale) =
            self.outlets.force(density, &state.void_fraction, &self.work.convecting, &state.velocity);
        boundary.add(value);
        boundary.scale += scale;
        let mut stress = Sum::new();
        if !recovered.is_empty() {
            self.add_traction_on_solids(&mut boundary);
            for (a, recovered) in recovered.iter().enumerate() {
                let solids = (1.0 - state.void_fraction[a]) * self.mesh.measure()[a];
                let [slope, viscous] = [&recovered.pressure_gradient, &recovered.stress_divergence];
                stress.add(std::array::from_fn(|k| solids * (viscous[k] - slope[k])));
            }
        }
        let (drag, explicit, exchanged) = if exchange.is_silent() {
            ([0.0; D], [0.0; D], 0.0)
        } else {
            exchange.totals(&state.velocity, &gradient_changes(recovered))
        };
        let scale = inertia.rate.scale + inertia.body.scale + boundary.scale + stress.scale + exchanged;

        let impulse = |force: Vector<D>| in_space(&force).map(|force| force * depth * step.length);
        FluidLedger {
            volume: depth * linear::vector::dot(self.mesh.measure(), &state.void_fraction),
            momentum: in_space(&inertia.momentum.value()).map(|momentum| depth * momentum),
            rate: impulse(inertia.rate.value()),
            body: impulse(inertia.body.value()),
            boundary: impulse(boundary.value()),
            drag: impulse(drag),
            stress: impulse(stress.value()),
            explicit: impulse(explicit),
            scale: depth * step.length * scale,
            volume_defect: depth * step.length * self.volume_rate(rule),
            kinetic_energy: depth * inertia.kinetic_energy,
        }
    }

    fn inertia(&self, rule: TimeRule) -> Inertia<D> {
        let cells = self.mesh.cells().len();
        let chunk = |index: usize| self.inertia_of(index * CELLS..cells.min((index + 1) * CELLS), rule);
        let parts: Vec<_> = (0..cells.div_ceil(CELLS)).into_par_iter().map(chunk).collect();
        parts.iter().fold(Inertia::new(), |mut sum, part| {
            sum.join(part);
            sum
        })
    }

    fn inertia_of(&self, cells: Range<usize>, rule: TimeRule) -> Inertia<D> {
        let (density, state) = (self.properties.density, &self.state);
        let mut sum = Inertia::new();
        for cell in cells {
            let nodes = self.mesh.cell_nodes(cell);
            let void = |field| PorousCell::new(&self.mesh, cell, &nodes, field).void_fraction;
            let [new, old, older] =
                [&state.void_fraction, &state.void_fraction_old, &state.void_fraction_older]
                    .map(|field| void(field));
            let moments = new.moments(&nodes.map(|node| state.velocity[node as usize]));
            let mass = density * self.mesh.volumes()[cell];
            for (i, node) in nodes.map(|node| node as usize).into_iter().enumerate() {
                let times = |share: f64, field: &Vector<D>| field.map(|component| mass * share * component);
                let momentum = times(new.first(i), &state.velocity[node]);
                sum.momentum.add(momentum);
                sum.rate.add(momentum.map(|component| rule.new * component));
                sum.rate.add(times(rule.old() * old.first(i), &state.velocity_old[node]));
                sum.rate.add(times(rule.older * older.first(i), &state.velocity_older[node]));
                sum.body.add(times(new.first(i), &self.acceleration[node]));
                sum.kinetic_energy += 0.5 * mass * dot(&state.velocity[node], &moments[i]);
            }
        }
        sum
    }

    /// ∮(1 − ε)(τ − p I)·n over the whole boundary.
    fn add_traction_on_solids(&self, sum: &mut Sum<D>) {
        for face in self.mesh.boundary() {
            let facet = Facet { area: self.mesh.area_vector(face) };
            let nodes = face.points.map(|point| self.mesh.node_of(point) as usize);
            let solids = nodes.map(|node| 1.0 - self.state.void_fraction[node]);
            let pressure = facet.product(&solids, &nodes.map(|node| self.state.pressure[node]));
            let mean = solids.iter().sum::<f64>() / D as f64;
            let stress = self.felt().stress(&self.mesh, face.cell as usize);
            sum.add(std::array::from_fn(|k| mean * dot(&stress[k], &facet.area) - pressure[k]));
        }
    }

    /// ∫ D_t ε + ∮ ε u·n (m³/s): zero but for the solver's tolerance, and where nothing can leave for the volume that
    /// the grains displace without an outlet.
    fn volume_rate(&self, rule: TimeRule) -> f64 {
        let state = &self.state;
        let outflow: f64 =
            (0..self.mesh.node_count()).map(|i| self.work.matrices.divergence(i, &state.velocity)).sum();
        let rate = |i: usize| {
            rule.rate(state.void_fraction[i], state.void_fraction_old[i], state.void_fraction_older[i])
        };
        outflow + self.mesh.measure().iter().enumerate().map(|(i, measure)| measure * rate(i)).sum::<f64>()
    }
}

struct Inertia<const D: usize> {
    momentum: Sum<D>,
    rate: Sum<D>,
    body: Sum<D>,
    kinetic_energy: f64,
}

impl<const D: usize> Inertia<D> {
    fn new() -> Self {
        Self { momentum: Sum::new(), rate: Sum::new(), body: Sum::new(), kinetic_energy: 0.0 }
    }

    fn join(&mut self, part: &Self) {
        self.momentum.join(&part.momentum);
        self.rate.join(&part.rate);
        self.body.join(&part.body);
        self.kinetic_energy += part.kinetic_energy;
    }
}
