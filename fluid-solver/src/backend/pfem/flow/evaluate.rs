//! The residual of an iterate.

use super::chunks::for_each;
use super::contact::moved;
use super::krylov::split_mut;
use super::nodal::{Fields, Part};
use super::setting::Fluid;
use super::solve::{Flow, Start};
use super::suspended::Suspended;
use super::topology::Topology;
use crate::element::simplex::{Vector, dot};
use linear::vector;

impl<const D: usize, const N: usize> Flow<D, N> {
    /// All rows at (v, p), on the geometry that v leads to.
    pub(super) fn evaluate(
        &mut self,
        start: Start<'_, D, N>,
        topology: &Topology<N>,
        velocity: &[Vector<D>],
        pressure: &[f64],
    ) {
        let Start { cloud, step, forces, .. } = start;
        let (inertia, compressibility) = (self.inertia(step), self.compressibility(step));
        let Fluid { density, rheology, .. } = self.fluid;
        // In the middle, whatever θ is: there ∫∇·v is the change of volume.
        let place = |node: usize| moved(&cloud.place[node], 0.5 * step.length, &velocity[node]);
        self.assembly.place(topology, place, velocity, inertia, &rheology);
        if let Some(suspension) = &forces.grains {
            let cells = &self.assembly.cells;
            let implicitness = self.implicitness;
            Suspended::fill(suspension, implicitness, topology.cells(), cells, &mut self.porous);
            self.assembly.share_volume(topology, &self.porous);
        }
        for_each(&mut self.excess, |node, e| {
            let (v, before) = (&velocity[node], &self.projected.velocity[node]);
            *e = std::array::from_fn(|k| inertia * (v[k] - before[k]) - density * forces.gravity[k]);
        });
        let (momentum, volumes) = split_mut::<D>(&mut self.rows);
        let grains = start.suspended(&self.porous, self.implicitness);
        let excess = &self.excess;
        let fields = Fields { velocity, pressure, excess, density, bulk: 0.0, part: Part::Affine, grains };
        let curvature = if D == 3 { 0.25 * step.length * step.length } else { 0.0 };
        self.assembly.evaluate(topology, fields, curvature, momentum, volumes);
        self.friction.evaluate(&self.fluid, self.implicitness, velocity, &self.projected.velocity);
        self.friction.add(momentum);
        for_each(volumes, |node, row| {
            let change = pressure[node] - cloud.pressure[node];
            *row += compressibility * self.assembly.volumes[node] * change;
            *row += forces.grains.map_or(0.0, |grains| grains.source[node]);
        });
        self.scheme.add_volumes(cloud, &self.assembly, pressure, volumes);
    }

    /// Rows of volume times (ρ/(θΔt) + d/(θV)) and the spacing have the size of forces (N s/m³).
    pub(super) fn volume_scale(&self, start: Start<'_, D, N>) -> f64 {
        let (nodes, volumes) = (start.cloud.place.len(), vector::sum(&self.assembly.volumes));
        let drag = start.suspended(&self.porous, self.implicitness).map_or(0.0, |grains| {
            let resistance: f64 = (0..nodes).map(|node| grains.resistance(node)).sum();
            resistance / volumes
        });
        let spacing = (volumes / nodes as f64).powf(1.0 / D as f64);
        (self.inertia(start.step) + drag) * spacing
    }

    /// Norm of V_i ρ/(θΔt) |x_i|/Δt over the nodes at walls (N): gaps are differences of places, and v_m closes them in the step.
    pub(super) fn gap_size(&self, start: Start<'_, D, N>) -> f64 {
        let Start { cloud, step, .. } = start;
        let rate = self.inertia(step) / step.length;
        let held = cloud.place.iter().enumerate().filter(|(node, _)| !self.contact.touched[*node].is_empty());
        held.map(|(node, x)| (rate * self.assembly.volumes[node]).powi(2) * dot(x, x)).sum::<f64>().sqrt()
    }

    /// Norms of (V_i ρ/(θΔt) + d/θ)v with the stresses on the node, and of the sizes of the terms that make up a force (N).
    pub(super) fn sizes(
        &mut self,
        start: Start<'_, D, N>,
        topology: &Topology<N>,
        (velocity, pressure): (&[Vector<D>], &[f64]),
        scale: f64,
    ) -> (f64, f64) {
        let inertia = self.inertia(start.step);
        let weight = self.fluid.density * dot(&start.forces.gravity, &start.forces.gravity).sqrt();
        let implicitness = self.implicitness;
        let Self { assembly, porous, right, .. } = self;
        let grains = start.suspended(porous, implicitness);
        let (momentum, force) = right.split_at_mut(velocity.len());
        for_each(momentum, |node, size| {
            let resistance = grains.map_or(0.0, |grains| grains.resistance(node));
            let speed = dot(&velocity[node], &velocity[node]).sqrt();
            *size = (inertia * assembly.volumes[node] + resistance) * speed;
            for corner in topology.corners(node) {
                let cell = &assembly.cells[corner.cell as usize];
                let area = &cell.areas[corner.local as usize];
                *size += cell.shear_stress * dot(area, area).sqrt();
            }
        });
        let force = &mut force[..velocity.len()];
        for_each(force, |node, size| {
            *size = weight * assembly.volumes[node];
            for corner in topology.corners(node) {
                let area = &assembly.cells[corner.cell as usize].areas[corner.local as usize];
                *size += pressure[node].abs() * dot(area, area).sqrt();
            }
            let Some(grains) = &grains else { return };
            // Drag scales volumes where there is none.
            for corner in topology.corners(node) {
                let cell = corner.cell as usize;
                let (area, inverse) =
                    (&assembly.cells[cell].areas[corner.local as usize], assembly.cells[cell].inverse);
                let area = dot(area, area).sqrt();
                let slope = weight + pressure[node].abs() * area * inverse;
                *size += scale * grains.cells[cell].relaxation() * area * slope;
            }
        });
        (vector::norm(momentum), vector::norm(force))
    }
}
