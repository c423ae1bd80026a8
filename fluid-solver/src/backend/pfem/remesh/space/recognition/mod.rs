//! Which tetrahedra between the moved nodes are fluid.

mod alpha_shape;
mod diagonals;
mod faces;
mod moved_domain;
mod quads;
mod samples;
mod stars;

use super::super::draft::Draft;
use super::super::recognition::Recognition;
use super::tetrahedra::Tetrahedra;
use crate::backend::pfem::cloud::Cloud;
use moved_domain::MovedDomain;

/// Marks the cells that are fluid; all of it is scratch.
#[derive(Default)]
pub struct Recogniser {
    moved_domain: MovedDomain,
}

impl Recogniser {
    /// Marks the cells that are fluid by a rule. The cells of the cloud are those before, its nodes have moved.
    pub fn recognise(
        &mut self,
        rule: Recognition,
        cloud: &Cloud<3, 4>,
        draft: &Draft<3>,
        tetrahedra: &mut Tetrahedra,
    ) {
        match rule {
            Recognition::MovedDomain => self.moved_domain.recognise(cloud, draft, tetrahedra),
            Recognition::AlphaShape { alpha } => alpha_shape::recognise(cloud, draft, alpha, tetrahedra),
        }
    }

    /// Gives the fluid, now the cells of the cloud, the edges of the moved surface that it lacks.
    pub fn restore_edges(&mut self, rule: Recognition, cloud: &mut Cloud<3, 4>) {
        if rule == Recognition::MovedDomain {
            self.moved_domain.restore_edges(cloud);
        }
    }
}

/// Mean h of the corners (m).
fn size(draft: &Draft<3>, corners: &[u32; 4]) -> f64 {
    corners.iter().map(|&node| draft.size[node as usize]).sum::<f64>() / 4.0
}
