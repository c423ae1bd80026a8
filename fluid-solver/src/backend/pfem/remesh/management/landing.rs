//! The surface meets a wall that is wet: its node lands there.

use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::backend::pfem::remesh::draft::{Draft, area};
use crate::backend::pfem::wall::Wall;
use crate::element::simplex::{distance, dot};

/// Puts nodes of the surface onto a wall that they are closer to than 0.05 h, with nothing but a film between.
pub fn land_on_walls(cloud: &mut Cloud<2, 3>, draft: &Draft, walls: &[Wall<2>], time: f64) {
    for c in 0..cloud.cells.len() {
        let cell = cloud.cells[c];
        for i in (0..3).filter(|&i| cloud.neighbours[c][i] == OUTSIDE) {
            let (node, base) = (cell[i] as usize, [1, 2].map(|k| cell[(i + k) % 3] as usize));
            let common = cloud.contacts[base[0]].common(cloud.contacts[base[1]]);
            let height =
                2.0 * area(&cloud.vertices(&cell)) / distance(&cloud.place[base[0]], &cloud.place[base[1]]);
            if !draft.exposed[node] || height > super::FILM * draft.size[node] {
                continue;
            }
            let untouched = |wall: &usize| !cloud.contacts[node].contains(*wall);
            if let Some(wall) = common.iter().find(untouched) {
                let touch = walls[wall].touch(&cloud.place[node], time);
                let v = cloud.velocity[node];
                let into = dot(&v, &touch.normal) - dot(&touch.velocity, &touch.normal);
                cloud.contacts[node].insert(wall);
                cloud.place[node] = [0, 1].map(|k| cloud.place[node][k] - touch.gap * touch.normal[k]);
                cloud.velocity[node] = [0, 1].map(|k| v[k] - into * touch.normal[k]);
            }
        }
    }
}
