//! A void that is closed in on all sides and small is filled at once: its collapse is not resolved.

use super::super::draft::{Draft, area};
use super::super::tessellation::{Scratch, Tessellation};
use crate::backend::pfem::cloud::Cloud;
use delaunay::HULL;

/// A void smaller than this many h² is filled.
const SMALLEST: f64 = 0.5;

/// Fills small voids; returns their number and area.
pub fn fill_small_voids(cloud: &Cloud<2, 3>, draft: &Draft, triangles: &mut Tessellation) -> (u32, f64) {
    let (mut count, mut volume) = (0, 0.0);
    let mut scratch = std::mem::take(&mut triangles.scratch);
    let Scratch { seen, front: void, .. } = &mut scratch;
    seen.clear();
    seen.extend((0..triangles.len()).map(|t| triangles.fluid[t] || triangles.along_one_wall(cloud, t)));
    for seed in 0..triangles.len() {
        if seen[seed] {
            continue;
        }
        seen[seed] = true;
        void.clear();
        void.push(seed);
        let (mut open, mut total, mut visited) = (false, 0.0, 0);
        while let Some(&triangle) = void.get(visited) {
            visited += 1;
            total += area(&triangles.vertices(triangle));
            for (i, next) in triangles.neighbours(triangle).into_iter().enumerate() {
                if next == HULL {
                    let nodes = triangles.nodes(triangle);
                    let [a, b] = [nodes[(i + 1) % 3], nodes[(i + 2) % 3]];
                    open |= cloud.contacts[a as usize].common(cloud.contacts[b as usize]).is_empty();
                } else if !seen[next as usize] {
                    seen[next as usize] = true;
                    void.push(next as usize);
                }
            }
        }
        let h = draft.size[triangles.nodes(seed)[0] as usize];
        if !open && total < SMALLEST * h * h {
            void.iter().for_each(|&triangle| triangles.fluid[triangle] = true);
            count += 1;
            volume += total;
        }
    }
    triangles.scratch = scratch;
    (count, volume)
}
