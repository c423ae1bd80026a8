//! Pieces of fluid that are too small for cells become one drop in flight.

use super::super::draft::{Draft, area};
use super::super::tessellation::{Scratch, Tessellation};
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::{Wall, inlet_of};
use crate::element::simplex::Vector;
use delaunay::HULL;

/// A piece smaller than this many h² is a drop.
const SMALLEST: f64 = 0.3;

/// Makes a drop of every small piece that hangs at no inlet; returns their number and the area that is in none of them.
pub fn release_droplets(
    cloud: &mut Cloud<2, 3>,
    draft: &mut Draft,
    triangles: &mut Tessellation,
    walls: &[Wall<2>],
) -> (u32, f64) {
    let (mut count, mut lost) = (0, 0.0);
    let mut scratch = std::mem::take(&mut triangles.scratch);
    let Scratch { seen, front: piece, marks, .. } = &mut scratch;
    seen.clear();
    seen.extend(triangles.fluid.iter().map(|fluid| !fluid));
    for seed in 0..triangles.len() {
        if seen[seed] {
            continue;
        }
        seen[seed] = true;
        piece.clear();
        piece.push(seed);
        let (mut volume, mut moment, mut momentum, mut visited) = (0.0, [0.0; 2], [0.0; 2], 0);
        while let Some(&triangle) = piece.get(visited) {
            visited += 1;
            let part = area(&triangles.vertices(triangle));
            volume += part;
            for node in triangles.nodes(triangle) {
                let (x, v) = (cloud.place[node as usize], cloud.velocity[node as usize]);
                moment = [0, 1].map(|k| moment[k] + part / 3.0 * x[k]);
                momentum = [0, 1].map(|k| momentum[k] + part / 3.0 * v[k]);
            }
            for next in triangles.neighbours(triangle) {
                if next != HULL && !seen[next as usize] {
                    seen[next as usize] = true;
                    piece.push(next as usize);
                }
            }
        }
        let h = draft.size[triangles.nodes(seed)[0] as usize];
        let in_inlet = |node: u32| inlet_of(walls, cloud.contacts[node as usize]).is_some();
        let grows = || piece.iter().flat_map(|&triangle| triangles.nodes(triangle)).any(in_inlet);
        if volume < SMALLEST * h * h && !grows() {
            piece.iter().for_each(|&triangle| triangles.fluid[triangle] = false);
            triangles.mark_wet(cloud.place.len(), marks);
            lost += gather(cloud, draft, (triangles, marks), piece, volume, moment, momentum);
            count += 1;
        }
    }
    triangles.scratch = scratch;
    (count, lost)
}

/// Gathers a piece in its first node that belongs to no other; returns the area lost if there is none.
fn gather(
    cloud: &mut Cloud<2, 3>,
    draft: &mut Draft,
    (triangles, wet): (&Tessellation, &[bool]),
    piece: &[usize],
    volume: f64,
    moment: Vector<2>,
    momentum: Vector<2>,
) -> f64 {
    let mut own: Vec<u32> = piece.iter().flat_map(|&triangle| triangles.nodes(triangle)).collect();
    own.retain(|&node| !wet[node as usize] && cloud.drop[node as usize] == 0.0);
    own.sort_unstable();
    own.dedup();
    let Some((&first, others)) = own.split_first() else { return volume };
    let common = own.iter().map(|&n| cloud.contacts[n as usize]).reduce(|a, b| a.common(b));
    let node = first as usize;
    cloud.drop[node] = volume;
    cloud.place[node] = moment.map(|m| m / volume);
    cloud.velocity[node] = momentum.map(|m| m / volume);
    cloud.contacts[node] = common.unwrap_or_default();
    others.iter().for_each(|&other| draft.remove(other));
    0.0
}
