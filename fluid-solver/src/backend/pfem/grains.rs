//! Grains in a cloud: where they are in it, what they do to a step, and what they feel of it.

use super::cloud::{Cloud, OUTSIDE};
use super::flow::{Fluid, viscosity};
use super::remesh::{transfer, volumes_between_grains};
use crate::backend::{Response, Step};
use crate::element::simplex::{Vector, dot, in_space};
use crate::error::FluidError;
use crate::grains::{
    Compliance, FREE_SURFACE, Felt, FreeSurface, Given, GrainsOnMesh, Medium, NodalDrag, Rate, Recovered,
    Spreading, Suspension, Taken, Viscosity, recover,
};
use crate::mesh::locate::Locator;
use crate::mesh::{Corners, Linked, Mesh};
use crate::weak_form::Facet;
use interface::frames::{GrainRow, ReactionRow, SampleRow};
use interface::ledger::FluidLedger;

/// The solution of a step.
#[derive(Debug, Clone, Copy)]
pub struct Solved<'a, const D: usize> {
    /// Velocity v_m of the step, that moves the nodes and makes the viscous stress (m/s).
    pub carrier: &'a [Vector<D>],
    /// v_{n+1} (m/s).
    pub velocity: &'a [Vector<D>],
    /// p (Pa).
    pub pressure: &'a [f64],
}

/// The grains placed last, in the mesh of a cloud that moves while a step is computed.
///
/// A step's equations take the void fraction of the grains at t_{n+1} on the nodes at t_{n+1}, as the latest iterate has them;
/// the fields are recovered on the mesh that the equations hold on. So what grains take is what the fluid gives, to
/// round-off, iteration by iteration.
pub struct GrainsInCloud<const D: usize, const N: usize> {
    fluid: Fluid,
    /// Depth of the slab in 2D (m).
    depth: f64,
    mesh: Mesh<D, N>,
    corners: Corners,
    placing: FreeSurface<D>,
    grains: GrainsOnMesh<D>,
    rows: Vec<GrainRow>,
    /// ε and |N_a| at t_n.
    void_fraction_before: Vec<f64>,
    measure_before: Vec<f64>,
    /// |N_a| where the grains are placed (m³).
    measure: Vec<f64>,
    /// v̂, by which the nodes went there (m/s).
    carrier: Vec<Vector<D>>,
    /// u′ and p′: what the grains have felt.
    velocity_felt: Vec<Vector<D>>,
    pressure_felt: Vec<f64>,
    source: Vec<f64>,
    drag: NodalDrag<D>,
    compliance: Vec<Compliance>,
    /// u that is sampled, at the end of the step (m/s).
    velocity: Vec<Vector<D>>,
    recovered: Vec<Recovered<D>>,
    places: Vec<Vector<D>>,
    /// μ of the cells where the fields were recovered, less in slivers, as the flow has it (Pa s).
    viscosity: Vec<f64>,
    /// What the grains sampled last.
    samples: Vec<SampleRow>,
    /// Those are of the run that is gone on with: the mesh that they were taken on is no more.
    resumed: bool,
}

impl<const D: usize, const N: usize> GrainsInCloud<D, N> {
    /// No grains among this many nodes; in 2D a slab of `depth` (m).
    pub fn new(fluid: Fluid, depth: f64, nodes: usize, spreading: Spreading) -> Self {
        let mesh = Mesh::of_particles(vec!["free-surface".to_string(), "walls".to_string()]);
        Self {
            fluid,
            depth,
            corners: Corners::default(),
            placing: FreeSurface::new(&mesh, spreading),
            grains: GrainsOnMesh::new(nodes),
            mesh,
            rows: Vec::new(),
            void_fraction_before: Vec::new(),
            measure_before: Vec::new(),
            measure: Vec::new(),
            carrier: Vec::new(),
            velocity_felt: Vec::new(),
            pressure_felt: Vec::new(),
            source: Vec::new(),
            drag: NodalDrag::default(),
            compliance: Vec::new(),
            velocity: Vec::new(),
            recovered: Vec::new(),
            places: Vec::new(),
            viscosity: Vec::new(),
            samples: Vec::new(),
            resumed: false,
        }
    }

    /// Number of grains.
    pub fn count(&self) -> usize {
        self.rows.len()
    }

    /// The mesh as grains were placed last.
    pub fn mesh(&self) -> &Mesh<D, N> {
        &self.mesh
    }

    /// Where points are in it.
    pub fn locator(&self) -> &Locator<D> {
        self.placing.locator()
    }

    /// Where the grains were that were placed last (m).
    pub fn positions(&self) -> impl Iterator<Item = Vector<D>> + '_ {
        self.rows.iter().map(|row| std::array::from_fn(|k| row.position[k]))
    }

    /// ε of the grains placed last.
    pub fn void_fraction(&self) -> &[f64] {
        &self.grains.void_fraction
    }

    /// Volume of the grains that is in the fluid (m³; m² in 2D).
    pub fn wetted_volume(&self) -> f64 {
        self.grains.wetted_volume()
    }

    /// What the grains sampled last, for a checkpoint.
    pub fn samples(&self) -> &[SampleRow] {
        &self.samples
    }

    /// Goes on with grains that sampled this; they are to be populated.
    pub fn resume(&mut self, samples: Vec<SampleRow>) {
        (self.samples, self.resumed) = (samples, true);
    }

    /// Takes the grains at t_n, and what the fluid is then; whether they are others than those gone on with.
    ///
    /// # Errors
    /// A position that is not finite, ε below its floor.
    pub fn populate(&mut self, cloud: &Cloud<D, N>, rows: &[GrainRow]) -> Result<bool, FluidError> {
        self.resumed &= rows.len() == self.samples.len();
        self.rows.clear();
        self.rows.extend_from_slice(rows);
        self.begin(cloud)?;
        if !rows.is_empty() {
            let steady = vec![[0.0; D]; cloud.place.len()];
            self.velocity.clone_from(&cloud.velocity);
            self.recover(&cloud.velocity, &cloud.pressure, &steady);
        }
        Ok(!self.resumed)
    }

    /// Begins a window on a cloud with other cells, the grains where they are: ε(t_n) is theirs.
    ///
    /// # Errors
    /// As [`Self::populate`].
    pub fn begin(&mut self, cloud: &Cloud<D, N>) -> Result<(), FluidError> {
        if self.rows.is_empty() {
            self.grains = GrainsOnMesh::new(cloud.place.len());
            return Ok(());
        }
        let on_wall = |points: &[u32; D]| {
            let contacts = points.map(|point| cloud.contacts[point as usize]);
            !contacts.iter().fold(contacts[0], |all, other| all.common(*other)).is_empty()
        };
        let group = |points: &[u32; D]| FREE_SURFACE + u32::from(on_wall(points));
        let linked = Linked { cells: &cloud.cells, neighbours: &cloud.neighbours, outside: OUTSIDE };
        self.mesh.relink(&cloud.place, linked, group);
        self.corners.relink(&self.mesh);
        self.place()?;
        self.void_fraction_before.clone_from(&self.grains.void_fraction);
        self.measure_before.clone_from(&self.measure);
        self.forget(cloud);
        Ok(())
    }

    /// Momentum per density of the fluid between the grains, Σ ε_a |N_a| v_a (m⁴/s; m³/s in 2D); none without grains.
    pub fn momentum(&self, cloud: &Cloud<D, N>) -> Option<Vector<D>> {
        // Where drops have left, others have their numbers.
        let is_of = !self.rows.is_empty() && self.void_fraction().len() == cloud.place.len();
        is_of.then(|| {
            transfer::momentum(&volumes_between_grains(cloud, self.void_fraction()), &cloud.velocity)
        })
    }

    /// Gives what the fluid has less than this momentum to the nodes that touch no wall, as one velocity for all of them.
    pub fn keep_momentum(&mut self, cloud: &mut Cloud<D, N>, momentum: Option<Vector<D>>) {
        if let Some(momentum) = momentum {
            let volumes = volumes_between_grains(cloud, self.void_fraction());
            transfer::keep_momentum(cloud, &volumes, momentum, &volumes);
            self.forget(cloud);
        }
    }

    /// Goes back to the start of the window: as if no iterate had been felt.
    pub fn forget(&mut self, cloud: &Cloud<D, N>) {
        if self.rows.is_empty() {
            return;
        }
        self.carrier.clone_from(&cloud.velocity);
        self.velocity_felt.clone_from(&cloud.velocity);
        self.pressure_felt.clone_from(&cloud.pressure);
    }

    /// Takes an iterate for what the grains have felt.
    pub fn remember(&mut self, solved: Solved<'_, D>) {
        if self.rows.is_empty() {
            return;
        }
        self.carrier.copy_from_slice(solved.carrier);
        self.velocity_felt.copy_from_slice(solved.velocity);
        self.pressure_felt.copy_from_slice(solved.pressure);
    }

    /// Places the grains at t_{n+1} among the nodes at x_n + Δt v̂.
    ///
    /// # Errors
    /// As [`Self::populate`].
    pub fn project(&mut self, cloud: &Cloud<D, N>, step: Step, rows: &[GrainRow]) -> Result<(), FluidError> {
        self.rows.clear();
        self.rows.extend_from_slice(rows);
        if rows.is_empty() {
            return Ok(());
        }
        self.move_mesh(cloud, step.length);
        self.place()?;
        self.source.clear();
        let change = self.grains.void_fraction.iter().zip(&self.void_fraction_before);
        let rates = change.zip(&self.measure_before);
        self.source.extend(rates.map(|((new, old), measure)| measure * (new - old) / step.length));
        Ok(())
    }

    /// What the grains do to the fluid with these reactions; none if there are no grains.
    pub fn react(&mut self, step: Step, reactions: &[ReactionRow]) -> Option<Suspension<'_, D>> {
        if self.rows.is_empty() {
            return None;
        }
        self.grains.react(reactions, self.depth);
        let instant = (1.0 / step.length, step.length);
        self.grains.exchange.lump(&self.measure, instant, &mut self.drag, &mut self.compliance);
        Some(Suspension {
            void_fraction: &self.grains.void_fraction,
            source: &self.source,
            carrier: &self.carrier,
            drag: &self.drag,
            measure: &self.measure,
            given: Given {
                compliance: &self.compliance,
                velocity: &self.velocity_felt,
                pressure: &self.pressure_felt,
            },
        })
    }

    /// Recovers what the grains feel of a solution.
    pub fn feel(&mut self, cloud: &Cloud<D, N>, step: Step, solved: Solved<'_, D>) {
        if self.rows.is_empty() {
            return;
        }
        self.carrier.copy_from_slice(solved.carrier);
        self.move_mesh(cloud, 0.5 * step.length);
        let change = solved.velocity.iter().zip(&cloud.velocity);
        let rate: Vec<Vector<D>> =
            change.map(|(new, old)| std::array::from_fn(|k| (new[k] - old[k]) / step.length)).collect();
        self.velocity.clear();
        self.velocity.extend_from_slice(solved.velocity);
        self.recover(solved.carrier, solved.pressure, &rate);
    }

    /// Adds what crosses between grains and fluid to the books of a step that has been felt: drag, stress, explicit forces,
    /// and at the boundary the traction ∮(1 − ε)(τ − p)n that the grains there would else be given twice.
    ///
    /// Where the fluid does not feel the grains, whatever drives it takes what they give.
    pub fn book(&self, step: Step, solved: Solved<'_, D>, response: Response, ledger: &mut FluidLedger) {
        if self.rows.is_empty() {
            return;
        }
        let Taken { drag, stress, explicit, scale } =
            self.grains.taken(&self.velocity, &self.recovered, &self.measure);
        let held: Vector<D> = match response {
            Response::TwoWay => self.traction_on_solids(solved),
            Response::OneWay => std::array::from_fn(|k| drag[k] + stress[k] - explicit[k]),
        };
        let impulse = self.depth * step.length;
        let [drag, stress, explicit, held] =
            [drag, stress, explicit, held].map(|force| in_space(&force).map(|f| f * impulse));
        for k in 0..3 {
            ledger.drag[k] += drag[k];
            ledger.stress[k] += stress[k];
            ledger.explicit[k] += explicit[k];
            ledger.boundary[k] += held[k];
            ledger.scale += stress[k].abs() + held[k].abs();
        }
        ledger.scale += impulse * scale;
    }

    /// Samples the fields recovered last at all grains.
    pub fn prepare_samples(&mut self) {
        if std::mem::take(&mut self.resumed) {
            return;
        }
        let mut samples = std::mem::take(&mut self.samples);
        samples.clear();
        if !self.rows.is_empty() {
            self.grains.sample(&self.velocity, &self.recovered);
            let row = |row: usize| self.grains.row(row, &self.measure, self.medium(row), self.depth);
            samples.extend((0..self.rows.len()).map(row));
        }
        self.samples = samples;
    }

    /// What a grain is in, by the fields sampled last.
    fn medium(&self, row: usize) -> Medium {
        let Fluid { density, rheology, .. } = &self.fluid;
        let (grain, (velocity, shear_rate)) = (&self.rows[row], self.grains.motion(row));
        let slip = (0..D).map(|k| (velocity[k] - grain.velocity[k]).powi(2)).sum::<f64>().sqrt();
        let viscosity = rheology.around_grain::<D>(shear_rate, slip, 2.0 * grain.radius);
        Medium { density: *density, viscosity }
    }

    /// What a grain samples.
    pub fn sample(&self, row: usize) -> SampleRow {
        self.samples[row]
    }

    /// The nodes at x_n + t v̂.
    fn move_mesh(&mut self, cloud: &Cloud<D, N>, time: f64) {
        self.places.clear();
        let moved = cloud.place.iter().zip(&self.carrier);
        self.places.extend(moved.map(|(x, v)| std::array::from_fn(|k| x[k] + time * v[k])));
        self.mesh.move_to(&self.places);
    }

    /// Places the grains in the mesh as it is.
    fn place(&mut self) -> Result<(), FluidError> {
        self.placing.follow(&self.mesh);
        self.grains.place(&self.mesh, &self.rows, &mut self.placing)?;
        self.measure.clear();
        self.measure.extend_from_slice(self.mesh.measure());
        Ok(())
    }

    /// Recovers the fields on the mesh as it is.
    fn recover(&mut self, velocity: &[Vector<D>], pressure: &[f64], rate: &[Vector<D>]) {
        let (mesh, rheology) = (&self.mesh, &self.fluid.rheology);
        self.viscosity.clear();
        self.viscosity.extend((0..mesh.volumes().len()).map(|cell| {
            let v = mesh.cell_nodes(cell).map(|node| velocity[node as usize]);
            viscosity(&mesh.vertices(cell), &v, rheology)
        }));
        let felt = Felt {
            velocity,
            pressure,
            pressure_before: &self.pressure_felt,
            rate: Rate::Material(rate),
            viscosity: Viscosity::OfCells(&self.viscosity),
        };
        recover(&self.mesh, &self.measure, |node| self.corners.of(node), felt, &mut self.recovered);
    }

    /// ∮(1 − ε)(τ − p I)·n over the boundary of the mesh as it is (N; N/m in 2D).
    fn traction_on_solids(&self, solved: Solved<'_, D>) -> Vector<D> {
        let felt = Felt {
            velocity: solved.carrier,
            pressure: solved.pressure,
            pressure_before: solved.pressure,
            rate: Rate::Material(&[]),
            viscosity: Viscosity::OfCells(&self.viscosity),
        };
        let mut sum = [0.0; D];
        for face in self.mesh.boundary() {
            let facet = Facet { area: self.mesh.area_vector(face) };
            let solids = face.points.map(|node| 1.0 - self.grains.void_fraction[node as usize]);
            let pressure = facet.product(&solids, &face.points.map(|node| solved.pressure[node as usize]));
            let mean = solids.iter().sum::<f64>() / D as f64;
            let stress = felt.stress(&self.mesh, face.cell as usize);
            for k in 0..D {
                sum[k] += mean * dot(&stress[k], &facet.area) - pressure[k];
            }
        }
        sum
    }
}
