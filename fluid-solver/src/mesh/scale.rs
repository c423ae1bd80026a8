//! Change of the unit of length.

use super::{Mesh, Period};

impl<const D: usize, const N: usize> Mesh<D, N> {
    /// The mesh with all lengths multiplied by a positive factor.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        let volume = factor.powi(D as i32);
        self.points.as_flattened_mut().iter_mut().for_each(|x| *x *= factor);
        self.volumes.iter_mut().chain(&mut self.measure).for_each(|v| *v *= volume);
        self.gradients.as_flattened_mut().as_flattened_mut().iter_mut().for_each(|slope| *slope /= factor);
        self.size.iter_mut().for_each(|size| *size *= factor);
        for period in self.periodicity.0.iter_mut().flatten() {
            *period = Period { lower: factor * period.lower, length: factor * period.length };
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::Mesh;
    use crate::mesh::generate::BoxMesh;

    #[test]
    fn a_box_in_millimetres_is_the_box_in_metres() {
        let generate = |length: f64| -> Mesh<2, 3> {
            let cells = [4, 3];
            BoxMesh { lower: [-length; 2], upper: [length; 2], cells, periodic: [true, false], jitter: None }
                .generate()
                .unwrap()
        };
        let (scaled, direct) = (generate(1024.0).scaled(1.0 / 1024.0), generate(1.0));
        assert_eq!(scaled, direct);
    }
}
