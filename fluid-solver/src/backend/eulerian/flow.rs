//! The flow: a mesh, what holds on its boundary, and the fields.

use super::incidence::{Corner, Incidence};
use super::outlet::Outlets;
use super::state::State;
use super::step::Workspace;
use crate::backend::{Stages, Step};
use crate::boundary::{Boundaries, Constraints};
use crate::element::simplex::{Vector, difference, dot};
use crate::error::FluidError;
use crate::grains::{Felt, Rate, Recovered, Viscosity, recover};
use crate::mesh::Mesh;
use linear::Pattern;
use std::sync::Arc;

/// What the fluid is and what drives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Properties<const D: usize> {
    /// Density ρ (kg/m³).
    pub density: f64,
    /// Dynamic viscosity μ (Pa s).
    pub viscosity: f64,
    /// Gravity g (m/s²).
    pub gravity: Vector<D>,
    /// Residual at which the linear solver stops, relative to the forces of the step.
    pub tolerance: f64,
}

/// An incompressible fluid between grains, model A of the volume-averaged Navier–Stokes equations:
///
/// ∂(ρεu)/∂t + ∇·(ρε u⊗u) = −ε∇p + ε∇·τ + ρε(g + b) − drag, ∂ε/∂t + ∇·(εu) = 0.
///
/// P1 for u and p with orthogonal subscales, second-order backward differences, convecting velocity extrapolated.
///
/// Source: Anderson and Jackson, *Ind. Eng. Chem. Fundam.* 6 (1967) 527; Codina, *Comput. Methods Appl. Mech. Engrg.*
/// 191 (2002) 4295.
pub struct Flow<const D: usize, const N: usize> {
    pub(super) mesh: Mesh<D, N>,
    pub(super) incidence: Incidence<N>,
    pub(super) constraints: Constraints<D>,
    pub(super) outlets: Outlets<D>,
    pub(super) enclosed: bool,
    pub(super) properties: Properties<D>,
    /// g + b at the nodes (m/s²).
    pub(super) acceleration: Vec<Vector<D>>,
    pub(super) state: State<D>,
    pub(super) work: Workspace<D, N>,
}

impl<const D: usize, const N: usize> Flow<D, N> {
    /// A fluid at rest in hydrostatic pressure, with conditions on its boundaries.
    ///
    /// # Errors
    /// An inlet that cannot pass the speed stated.
    pub fn new(
        mesh: Mesh<D, N>,
        boundaries: &Boundaries<D>,
        properties: Properties<D>,
    ) -> Result<Self, FluidError> {
        let nodes = mesh.node_count();
        let elements = (0..mesh.cells().len()).map(|cell| mesh.cell_nodes(cell));
        let pattern = Arc::new(Pattern::from_elements(nodes, elements)?);
        let weight: Vector<D> = std::array::from_fn(|k| match mesh.periodicity().0[k] {
            // No pressure balances gravity along a periodic axis.
            Some(_) => 0.0,
            None => properties.density * properties.gravity[k],
        });
        let outlets = Outlets::new(&mesh, boundaries, &weight);
        let mut state = State::new(nodes);
        let (origin, pressure) = outlets.reference().unwrap_or_else(|| (highest(&mesh, &weight), 0.0));
        for (p, x) in state.pressure.iter_mut().zip(mesh.nodes()) {
            *p = pressure + dot(&weight, &difference(x, &origin));
        }
        let enclosed = boundaries.enclosed();
        Ok(Self {
            incidence: Incidence::new(&mesh, &pattern),
            constraints: Constraints::new(&mesh, boundaries)?,
            acceleration: vec![properties.gravity; nodes],
            mesh,
            outlets,
            enclosed,
            properties,
            state,
            work: Workspace::new(&pattern, enclosed),
        })
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh<D, N> {
        &self.mesh
    }

    /// What the fluid is.
    pub fn properties(&self) -> &Properties<D> {
        &self.properties
    }

    /// Where the time went.
    pub fn spent(&self) -> Stages {
        self.work.spent
    }

    /// The fields.
    pub fn state(&self) -> &State<D> {
        &self.state
    }

    /// The fields, to be changed between steps.
    pub fn state_mut(&mut self) -> &mut State<D> {
        &mut self.state
    }

    /// Sets the initial velocity (m/s); prescribed components take their values at time 0.
    pub fn set_velocity(&mut self, velocity: impl Fn(&Vector<D>) -> Vector<D>) {
        let State { velocity: new, velocity_old, void_fraction, .. } = &mut self.state;
        for (u, x) in new.iter_mut().zip(self.mesh.nodes()) {
            *u = velocity(x);
        }
        self.constraints.prescribe(0.0, void_fraction, new);
        velocity_old.copy_from_slice(new);
    }

    /// Sets the body force per mass b (m/s²) besides gravity.
    pub fn set_body_force(&mut self, force: impl Fn(&Vector<D>) -> Vector<D>) {
        for (sum, x) in self.acceleration.iter_mut().zip(self.mesh.nodes()) {
            let force = force(x);
            *sum = std::array::from_fn(|k| self.properties.gravity[k] + force[k]);
        }
    }

    /// What grains feel of the present iterate.
    pub(super) fn felt(&self) -> Felt<'_, D> {
        Felt {
            velocity: &self.state.velocity,
            pressure: &self.state.pressure,
            pressure_before: &self.work.felt_pressure,
            rate: Rate::Local(&self.state.acceleration),
            viscosity: Viscosity::Uniform(self.properties.viscosity),
        }
    }

    /// Recovers it at the nodes.
    pub fn recover(&self, recovered: &mut Vec<Recovered<D>>) {
        let corner = |corner: &Corner<N>| (corner.cell as usize, corner.local as usize);
        let corners = |node: usize| self.incidence.of(node).iter().map(corner);
        recover(&self.mesh, self.mesh.measure(), corners, self.felt(), recovered);
    }

    /// The present step becomes history.
    pub fn commit(&mut self, step: Step) {
        self.state.commit(step.length);
    }
}

/// The node against the weight most.
fn highest<const D: usize, const N: usize>(mesh: &Mesh<D, N>, weight: &Vector<D>) -> Vector<D> {
    let height = |x: &&Vector<D>| -dot(weight, x);
    mesh.nodes().iter().max_by(|a, b| height(a).total_cmp(&height(b))).copied().unwrap_or([0.0; D])
}
