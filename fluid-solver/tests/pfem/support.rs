//! Clouds on boxes, and walls around them.

use fluid_solver::backend::Step;
use fluid_solver::backend::pfem::cloud::{Cloud, OUTSIDE};
use fluid_solver::backend::pfem::flow::{Control, Flow, FlowSolution, Fluid, Forces, Newtonian, Rheology};
use fluid_solver::backend::pfem::remesh::volumes;
use fluid_solver::backend::pfem::wall::{Contacts, Grip, Plane, Shape, Wall};
use fluid_solver::element::simplex::{dot, volume_and_areas};
use fluid_solver::mesh::generate::{BoxMesh, Jitter};
use std::collections::HashMap;

pub const WATER: Fluid = newtonian(1000.0, 1e-3);
pub const G: f64 = 9.81;

pub const fn newtonian(density: f64, viscosity: f64) -> Fluid {
    Fluid { density, rheology: Rheology::Newtonian(Newtonian { viscosity }), bulk_modulus: None }
}

/// Gravity along the last axis.
pub fn gravity<const D: usize>() -> Forces<'static, D> {
    let mut gravity = [0.0; D];
    gravity[D - 1] = -G;
    Forces { gravity, grains: None }
}

pub fn flow<const D: usize, const N: usize>(fluid: Fluid, tolerance: f64) -> Flow<D, N> {
    Flow::new(fluid, Control { tolerance, ..Control::default() })
}

/// The fluid in a box at rest, without contacts; inner nodes displaced by a share of the spacing.
pub fn block<const D: usize, const N: usize>(size: [f64; D], cells: [usize; D], jitter: f64) -> Cloud<D, N> {
    let jitter = (jitter > 0.0).then_some(Jitter { fraction: jitter, seed: 7 });
    let mesh = BoxMesh { lower: [0.0; D], upper: size, cells, periodic: [false; D], jitter }
        .generate::<N>()
        .unwrap();
    let nodes = mesh.node_count();
    let cells: Vec<[u32; N]> = (0..mesh.cells().len()).map(|cell| mesh.cell_nodes(cell)).collect();
    Cloud {
        place: mesh.nodes().to_vec(),
        velocity: vec![[0.0; D]; nodes],
        pressure: vec![0.0; nodes],
        contacts: vec![Contacts::default(); nodes],
        drop: vec![0.0; nodes],
        birth: (0..nodes as u32).collect(),
        neighbours: neighbours(&cells),
        cells,
    }
}

pub fn neighbours<const N: usize>(cells: &[[u32; N]]) -> Vec<[u32; N]> {
    let face = |cell: usize, opposite: usize| {
        let mut face: Vec<u32> =
            (0..N).filter(|&corner| corner != opposite).map(|corner| cells[cell][corner]).collect();
        face.sort_unstable();
        face
    };
    let mut sides: HashMap<Vec<u32>, Vec<u32>> = HashMap::new();
    for cell in 0..cells.len() {
        (0..N).for_each(|corner| sides.entry(face(cell, corner)).or_default().push(cell as u32));
    }
    let across = |cell: usize, corner: usize| {
        sides[&face(cell, corner)].iter().copied().find(|&other| other != cell as u32).unwrap_or(OUTSIDE)
    };
    (0..cells.len()).map(|cell| std::array::from_fn(|corner| across(cell, corner))).collect()
}

/// A box open at the top.
pub fn tank<const D: usize>(size: [f64; D], grip: Grip) -> Vec<Wall<D>> {
    let mut walls = Vec::new();
    for axis in 0..D {
        let sides: &[(f64, f64)] =
            if axis == D - 1 { &[(0.0, 1.0)] } else { &[(0.0, 1.0), (size[axis], -1.0)] };
        for &(at, sign) in sides {
            let (mut point, mut normal) = ([0.0; D], [0.0; D]);
            (point[axis], normal[axis]) = (at, sign);
            let shape = Shape::Plane(Plane { point, normal });
            walls.push(Wall::new(format!("{axis}"), shape, grip));
        }
    }
    walls
}

/// Gives the nodes the contacts that they have.
pub fn touch<const D: usize, const N: usize>(cloud: &mut Cloud<D, N>, walls: &[Wall<D>]) {
    for (x, contacts) in cloud.place.iter().zip(&mut cloud.contacts) {
        for (index, wall) in walls.iter().enumerate() {
            if wall.touch(x, 0.0).gap.abs() < 1e-9 {
                contacts.insert(index);
            }
        }
    }
}

/// Steps on the same mesh.
pub fn advance<const D: usize, const N: usize>(
    flow: &mut Flow<D, N>,
    cloud: &mut Cloud<D, N>,
    walls: &[Wall<D>],
    forces: &Forces<'_, D>,
    length: f64,
    steps: std::ops::Range<usize>,
    mut after: impl FnMut(&Cloud<D, N>, &FlowSolution<D>),
) {
    for n in steps {
        let step = Step { time: n as f64 * length, length };
        let solution = flow.solve(cloud, walls, step, forces).unwrap();
        solution.advance(cloud, step);
        after(cloud, &solution);
    }
}

pub fn largest_speed<const D: usize, const N: usize>(cloud: &Cloud<D, N>) -> f64 {
    cloud.velocity.iter().map(|v| dot(v, v).sqrt()).fold(0.0, f64::max)
}

pub fn volume<const D: usize, const N: usize>(cloud: &Cloud<D, N>) -> f64 {
    cloud.cells.iter().map(|cell| volume_and_areas(&cloud.vertices(cell)).0).sum()
}

/// Σ V_i v_i, drops with it.
pub fn momentum<const D: usize, const N: usize>(cloud: &Cloud<D, N>) -> [f64; D] {
    let mut nodes = Vec::new();
    volumes(cloud, &mut nodes);
    std::array::from_fn(|k| nodes.iter().zip(&cloud.velocity).map(|(volume, v)| volume * v[k]).sum())
}

/// A drop in flight.
pub fn add_drop<const D: usize, const N: usize>(cloud: &mut Cloud<D, N>, place: [f64; D], volume: f64) {
    cloud.birth.push(cloud.place.len() as u32);
    cloud.place.push(place);
    cloud.velocity.push([0.0; D]);
    cloud.pressure.push(0.0);
    cloud.contacts.push(Contacts::default());
    cloud.drop.push(volume);
}
