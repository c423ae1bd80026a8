//! Cost of remeshing in space, in the break of a dam: processor time per node and step of the flow and of the parts of
//! remeshing, one thread, over stretches of steps.
//!
//! `cargo run --release -p fluid-solver --example remeshing -- [cells across the column] [steps]`

use fluid_solver::backend::Step;
use fluid_solver::backend::pfem::Renewal;
use fluid_solver::backend::pfem::body::Body;
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::flow::{Control, Flow, FlowFault, Fluid, Forces, Newtonian, Rheology};
use fluid_solver::backend::pfem::remesh::{Books, SpaceRemesher, Spent, TargetSize};
use fluid_solver::backend::pfem::wall::{Grip, Plane, Shape, Wall};
use interface::usage::ThreadClock;

/// Width of the column (m); it is twice as high.
const SIDE: f64 = 0.146;
const G: f64 = 9.81;
/// Steps of a line of the table.
const STRETCH: usize = 10;

fn main() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    let mut numbers = std::env::args().skip(1).map(|word| word.parse::<usize>());
    let cells = numbers.next().transpose()?.unwrap_or(28);
    let steps = numbers.next().transpose()?.unwrap_or(40);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    pool.install(|| run(cells, steps))
}

#[allow(clippy::print_stdout)]
fn run(cells: usize, steps: usize) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    let h = SIDE / cells as f64;
    let walls = tank([4.0 * SIDE, SIDE]);
    let mut cloud = Body::<3, 4>::of_box([0.0; 3], [SIDE, SIDE, 2.0 * SIDE], h)?.cloud();
    for (x, contacts) in cloud.place.iter().zip(&mut cloud.contacts) {
        let touched = walls.iter().enumerate().filter(|(_, wall)| wall.touch(x, 0.0).gap.abs() < 1e-6 * h);
        touched.for_each(|(index, _)| contacts.insert(index));
    }
    let rheology = Rheology::Newtonian(Newtonian { viscosity: 1e-3 });
    let water = Fluid { density: 1000.0, rheology, bulk_modulus: None };
    let mut flow = Flow::<3, 4>::new(water, Control { tolerance: 1e-6, ..Control::default() });
    let (mut remesher, mut books) = (SpaceRemesher::default(), Books::start(&cloud));
    println!(
        "time [s], nodes, cells, halved steps | us per node: flow, remeshing = management + mesh + recognition + settling + transfer"
    );
    let (mut time, mut halved, mut flowing, mut nodes, mut before) = (0.0, 0, 0.0, 0, Spent::default());
    for step in 1..=steps {
        let mut clock = ThreadClock::start();
        // A quarter of a cell at the speed of the fall.
        let at = Step { time, length: 0.25 * h / (2.0 * G * SIDE).sqrt() };
        let (length, refused) = advance(&mut flow, &mut cloud, &walls, at)?;
        (time, halved) = (time + length, halved + refused);
        flowing += clock.lap();
        nodes += cloud.place.len();
        remesher.remesh(&mut cloud, &walls, time, &TargetSize::Constant(h), &mut books)?;
        if step % STRETCH == 0 || step == steps {
            let spent = remesher.spent();
            let each = |seconds: f64| 1e6 * seconds / nodes as f64;
            println!(
                "{time:.4} {:>11} {:>8} {halved:>6} | {:.1}, {:.2} = {:.2} + {:.2} + {:.2} + {:.2} + {:.2}",
                cloud.place.len(),
                cloud.cells.len(),
                each(flowing),
                each(spent.total() - before.total()),
                each(spent.management - before.management),
                each(spent.mesh - before.mesh),
                each(spent.recognition - before.recognition),
                each(spent.settling - before.settling),
                each(spent.transfer - before.transfer),
            );
            (halved, flowing, nodes, before) = (0, 0.0, 0, spent);
        }
    }
    println!("volume in error by {:.1e}", -books.volume.missing() / books.volume.target);
    Ok(())
}

/// Solves a step, shorter where it would turn a cell over, and moves the nodes; returns its length (s) and how often it was
/// refused.
fn advance(
    flow: &mut Flow<3, 4>,
    cloud: &mut Cloud<3, 4>,
    walls: &[Wall<3>],
    mut step: Step,
) -> Result<(f64, usize), FlowFault> {
    let gravity = Forces { gravity: [0.0, 0.0, -G], grains: None };
    let mut refused = 0;
    loop {
        match flow.solve(cloud, walls, step, &gravity) {
            Ok(solution) => {
                solution.advance(cloud, step);
                return Ok((step.length, refused));
            }
            Err(FlowFault::Inverted { bound, .. }) => step.length = bound.min(0.5 * step.length),
            Err(FlowFault::NotConverged { .. }) if refused < 20 => step.length *= 0.5,
            Err(fault) => return Err(fault),
        }
        refused += 1;
    }
}

/// A floor and four sides.
fn tank([length, width]: [f64; 2]) -> Vec<Wall<3>> {
    let plane = |name: &str, point, normal| {
        Wall::new(name.to_string(), Shape::Plane(Plane { point, normal }), Grip::Slip)
    };
    vec![
        plane("left", [0.0; 3], [1.0, 0.0, 0.0]),
        plane("right", [length, 0.0, 0.0], [-1.0, 0.0, 0.0]),
        plane("front", [0.0; 3], [0.0, 1.0, 0.0]),
        plane("back", [0.0, width, 0.0], [0.0, -1.0, 0.0]),
        plane("floor", [0.0; 3], [0.0, 0.0, 1.0]),
    ]
}
