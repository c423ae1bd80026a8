//! A tank of water with grains, window by window on the same cells.

use crate::support::{G, WATER, block, flow, gravity, tank, touch};
use fluid_solver::backend::pfem::Renewal;
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::flow::{Flow, FlowSolution, Fluid, Forces};
use fluid_solver::backend::pfem::grains::{GrainsInCloud, Solved};
use fluid_solver::backend::pfem::remesh::{Books, Recognition, SpaceRemesher, TargetSize};
use fluid_solver::backend::pfem::wall::{Grip, Wall};
use fluid_solver::backend::{Response, Step};
use fluid_solver::element::simplex::{in_space, longest_edge, volume_and_gradients};
use fluid_solver::grains::Spreading;
use interface::frames::{GrainRow, ReactionRow};
use interface::ledger::FluidLedger;

pub const SIDE: f64 = 0.2;
/// Depth of the slab of planar tanks.
pub const DEPTH: f64 = 0.7;

/// Volume of a regular tetrahedron of edge 1.
const REGULAR: f64 = 0.117_851_130_197_757_93;

pub struct Tank<const D: usize, const N: usize> {
    pub flow: Flow<D, N>,
    pub cloud: Cloud<D, N>,
    pub walls: Vec<Wall<D>>,
    pub grains: GrainsInCloud<D, N>,
    pub time: f64,
}

impl<const D: usize, const N: usize> Tank<D, N> {
    /// Water at rest, as high as wide.
    pub fn new(cells: usize, grip: Grip) -> Self {
        Self::of(WATER, cells, grip, Spreading::Kernel)
    }

    /// Another fluid in it, its grains on nodes by some way.
    pub fn of(fluid: Fluid, cells: usize, grip: Grip, spreading: Spreading) -> Self {
        let size = [SIDE; D];
        let (mut cloud, walls) = (block::<D, N>(size, [cells; D], 0.2), tank(size, grip));
        touch(&mut cloud, &walls);
        cloud.pressure = cloud.place.iter().map(|x| fluid.density * G * (SIDE - x[D - 1])).collect();
        let depth = if D == 2 { DEPTH } else { 1.0 };
        let grains = GrainsInCloud::new(fluid, depth, cloud.place.len(), spreading);
        Self { flow: flow(fluid, 1e-8), cloud, walls, grains, time: 0.0 }
    }

    /// A window of some iterations with these grains at its end; what the last gave.
    pub fn window(
        &mut self,
        length: f64,
        rows: &[GrainRow],
        iterations: usize,
        mut reactions: impl FnMut(&GrainsInCloud<D, N>) -> Vec<ReactionRow>,
    ) -> (FlowSolution<D>, FluidLedger) {
        let step = Step { time: self.time, length };
        self.grains.forget(&self.cloud);
        let mut last = None;
        for _ in 0..iterations {
            if let Some((solution, _)) = &last {
                self.grains.remember(solved(solution));
            }
            self.grains.project(&self.cloud, step, rows).unwrap();
            let reactions = reactions(&self.grains);
            let forces = Forces { grains: self.grains.react(step, &reactions), ..gravity() };
            let solution = self.flow.solve(&self.cloud, &self.walls, step, &forces).unwrap();
            self.grains.feel(&self.cloud, step, solved(&solution));
            let ledger = self.ledger(step, &solution);
            self.grains.prepare_samples();
            last = Some((solution, ledger));
        }
        last.expect("an iteration")
    }

    /// The window becomes history; the cells stay.
    pub fn commit(&mut self, length: f64, solution: &FlowSolution<D>) {
        solution.advance(&mut self.cloud, Step { time: self.time, length });
        self.grains.begin(&self.cloud).unwrap();
        self.time += length;
    }

    fn ledger(&self, step: Step, solution: &FlowSolution<D>) -> FluidLedger {
        let depth = if D == 2 { DEPTH } else { 1.0 };
        let mut ledger = FluidLedger::default();
        for node in 0..self.cloud.place.len() {
            let mass = solution.mass[node];
            let (new, old) = (&solution.end_velocity[node], &self.cloud.velocity[node]);
            let rate: [f64; D] = std::array::from_fn(|k| mass * (new[k] - old[k]));
            let body: [f64; D] =
                std::array::from_fn(|k| if k == D - 1 { -mass * G * step.length } else { 0.0 });
            let wall = solution.reaction[node].map(|force| force * step.length);
            let [rate, body, wall] = [rate, body, wall].map(|i| in_space(&i).map(|i| depth * i));
            for k in 0..3 {
                ledger.rate[k] += rate[k];
                ledger.body[k] += body[k];
                ledger.boundary[k] += wall[k];
                ledger.scale += rate[k].abs() + body[k].abs() + wall[k].abs();
            }
        }
        self.grains.book(step, solved(solution), Response::TwoWay, &mut ledger);
        ledger
    }

    /// Volume of all cells.
    pub fn volume(&self) -> f64 {
        self.cloud.cells.iter().map(|cell| volume_and_gradients(&self.cloud.vertices(cell)).0).sum()
    }
}

impl Tank<3, 4> {
    /// New cells between the nodes as they are.
    pub fn remesh(&mut self) {
        let (mut remesher, size) =
            (SpaceRemesher::new(Recognition::MovedDomain), TargetSize::Constant(SIDE / 6.0));
        let mut books = Books::start(&self.cloud);
        // Enough to leave the cells of the box for those of Delaunay.
        self.cloud.place.iter_mut().for_each(|x| x[0] += 1e-3 * x[2] * (SIDE - x[0]) * x[0] / SIDE.powi(2));
        remesher.remesh(&mut self.cloud, &self.walls, 0.0, &size, &mut books).unwrap();
    }

    /// Least volume of a cell over that of a regular one with its longest edge.
    pub fn thinnest_cell(&self) -> f64 {
        let share = |cell: &[u32; 4]| {
            let vertices = self.cloud.vertices(cell);
            volume_and_gradients(&vertices).0 / (REGULAR * longest_edge(&vertices).powi(3))
        };
        self.cloud.cells.iter().map(share).fold(f64::INFINITY, f64::min)
    }
}

pub fn solved<const D: usize>(solution: &FlowSolution<D>) -> Solved<'_, D> {
    Solved { carrier: &solution.velocity, velocity: &solution.end_velocity, pressure: &solution.pressure }
}

/// |rate − (body + boundary − drag − stress + explicit)| over the scale.
pub fn defect(ledger: &FluidLedger) -> f64 {
    let defect = |k: usize| {
        let gained =
            ledger.body[k] + ledger.boundary[k] - ledger.drag[k] - ledger.stress[k] + ledger.explicit[k];
        (ledger.rate[k] - gained).abs()
    };
    (0..3).map(defect).fold(0.0, f64::max) / ledger.scale
}

/// Grains at random places of a box, some close to walls, some in the surface and above.
pub fn grains<const D: usize>(count: usize, height: f64, random: &mut Random) -> Vec<GrainRow> {
    let grain = |id: usize| {
        let radius = SIDE * (0.012 + 0.005 * random.unit());
        let position = std::array::from_fn(|k| match k {
            _ if k >= D => 0.0,
            _ if k == D - 1 => radius + (height - radius) * random.unit(),
            _ => radius + (SIDE - 2.0 * radius) * random.unit(),
        });
        let velocity = std::array::from_fn(|k| if k < D { random.unit() - 0.5 } else { 0.0 });
        let mass = 2500.0 * 4.0 * radius.powi(3);
        GrainRow { id: id as u64, position, velocity, radius, mass, ..GrainRow::default() }
    };
    (0..count).map(grain).collect()
}

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}
