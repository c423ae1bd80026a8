//! Sheets and necks break where they are too thin for the cells.

use super::super::buried::is_buried;
use super::super::draft::{Draft, area, height};
use super::super::tessellation::Tessellation;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::{Contacts, Wall, inlet_of};
use delaunay::HULL;

/// A cell between two surfaces breaks when it is thinner than this share of h.
const THINNEST: f64 = 0.05;

/// A drop has at least this many h².
const SMALLEST_DROP: f64 = 1e-3;

/// Breaks thin cells that have all corners on the surface and a side that is open: others would leave a hole; and those that cut
/// the corner of an obstacle. Cells with a side in an inlet stay: they grow. Nodes that lose their last cell become drops with
/// its volume.
///
/// Returns the number of cells and the area that is in none of the drops.
pub fn break_thin_cells(
    cloud: &mut Cloud<2, 3>,
    draft: &Draft,
    triangles: &mut Tessellation,
    walls: &[Wall<2>],
    time: f64,
) -> (u32, f64) {
    let mut scratch = std::mem::take(&mut triangles.scratch);
    let exposed = &mut scratch.marks;
    exposed.clear();
    exposed.resize(cloud.place.len(), false);
    for triangle in (0..triangles.len()).filter(|&triangle| triangles.fluid[triangle]) {
        let nodes = triangles.nodes(triangle);
        for i in (0..3).filter(|&i| !triangles.fluid_across(triangle, i)) {
            exposed[nodes[(i + 1) % 3] as usize] = true;
            exposed[nodes[(i + 2) % 3] as usize] = true;
        }
    }
    let mut broken = Vec::new();
    for triangle in (0..triangles.len()).filter(|&triangle| triangles.fluid[triangle]) {
        let nodes = triangles.nodes(triangle);
        let h = nodes.map(|node| draft.size[node as usize]).iter().sum::<f64>() / 3.0;
        let thin = || height(&triangles.vertices(triangle)) < THINNEST * h;
        let between_surfaces = || nodes.iter().all(|&node| exposed[node as usize]);
        let ends = || triangles.along_one_wall(cloud, triangle) || open(cloud, triangles, triangle);
        let grows = || (0..3).any(|i| inlet_of(walls, contacts_across(cloud, &nodes, i)).is_some());
        let buried = || is_buried(cloud, walls, time, &nodes, h);
        if (between_surfaces() && thin() && ends() && !grows()) || buried() {
            broken.push(triangle);
        }
    }
    broken.iter().for_each(|&triangle| triangles.fluid[triangle] = false);
    let mut lost = 0.0;
    if !broken.is_empty() {
        let wet = &mut scratch.marks;
        triangles.mark_wet(cloud.place.len(), wet);
        for &triangle in &broken {
            let volume = area(&triangles.vertices(triangle));
            let h = draft.size[triangles.nodes(triangle)[0] as usize];
            let dry: Vec<u32> = triangles.nodes(triangle).into_iter().filter(|&n| !wet[n as usize]).collect();
            if dry.is_empty() || volume < SMALLEST_DROP * h * h {
                lost += volume;
                continue;
            }
            for &node in &dry {
                cloud.drop[node as usize] += volume / dry.len() as f64;
            }
        }
    }
    triangles.scratch = scratch;
    (broken.len() as u32, lost)
}

/// Whether a side of the triangle borders on void.
fn open(cloud: &Cloud<2, 3>, triangles: &Tessellation, triangle: usize) -> bool {
    let nodes = triangles.nodes(triangle);
    (0..3).any(|i| match triangles.neighbours(triangle)[i] {
        HULL => contacts_across(cloud, &nodes, i).is_empty(),
        next => !triangles.fluid[next as usize],
    })
}

/// Walls that the side opposite to a corner is at.
fn contacts_across(cloud: &Cloud<2, 3>, nodes: &[u32; 3], corner: usize) -> Contacts {
    let [a, b] = [1, 2].map(|k| cloud.contacts[nodes[(corner + k) % 3] as usize]);
    a.common(b)
}
