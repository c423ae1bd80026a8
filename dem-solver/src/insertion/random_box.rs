//! Random places without overlap in a box.

use super::batch::Batch;
use super::occupancy::Occupancy;
use super::random::Random;
use crate::error::DemError;
use crate::grains::{Place, volume};
use crate::scene::Scene;
use crate::vector::Vector;
use crate::world::World;

/// A box is full when so many places in a row were taken.
const MOST_MISSES: u32 = 100_000;

/// How much a random box holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// So many grains.
    Count(usize),
    /// Grains that fill this fraction of the box.
    SolidFraction(f64),
}

/// Random sequential addition: each grain at a uniformly random place that is still free (Feder, J. Theor. Biol.
/// 87 (1980) 237–254; full at a solid fraction of about 0.38 in 3D and 0.55 in 2D).
#[derive(Clone, Debug, PartialEq)]
pub struct RandomBox<const D: usize> {
    /// Corner of smallest coordinates \[m\].
    pub lower: Vector<D>,
    /// Corner of largest coordinates \[m\].
    pub upper: Vector<D>,
    /// How much.
    pub amount: Amount,
}

impl<const D: usize> RandomBox<D> {
    /// Adds the grains to the world, none overlapping another or a wall.
    ///
    /// # Errors
    /// [`DemError::NoRoom`] with the number that fitted.
    pub fn insert(
        &self,
        scene: &Scene<D>,
        world: &mut World<D>,
        batch: &Batch<D>,
        random: &mut Random,
    ) -> Result<(), DemError> {
        let radii = self.radii(scene, batch, random);
        let mut occupancy = Occupancy::new(scene, self.lower, self.upper, world, batch.sizes.largest);
        for (fitted, &radius) in radii.iter().enumerate() {
            let place = (0..MOST_MISSES).find_map(|_| {
                let place =
                    Place { centre: place_in_box(scene, self.lower, self.upper, radius, random)?, radius };
                occupancy.take_if_free(place).then_some(place)
            });
            let Some(place) = place else {
                return Err(DemError::NoRoom { insertion: batch.name.clone(), fitted, wanted: radii.len() });
            };
            world.add(scene, &batch.grain(place.centre, radius));
        }
        Ok(())
    }

    fn radii(&self, scene: &Scene<D>, batch: &Batch<D>, random: &mut Random) -> Vec<f64> {
        match self.amount {
            Amount::Count(count) => (0..count).map(|_| batch.sizes.draw(random)).collect(),
            Amount::SolidFraction(fraction) => {
                let depth = if D == 2 { scene.depth } else { 1.0 };
                let mut left = fraction * (self.upper - self.lower).product() * depth;
                let mut radii = Vec::new();
                loop {
                    // The grain that overshoots is taken if that comes nearer to the fraction.
                    let radius = batch.sizes.draw(random);
                    let volume = volume::<D>(radius, scene.depth);
                    if left < 0.5 * volume {
                        return radii;
                    }
                    left -= volume;
                    radii.push(radius);
                }
            }
        }
    }
}

/// A uniformly random centre of a grain that lies inside the box; where the box spans a periodic axis, the grain
/// may reach across its ends. Nothing if the box is too narrow.
pub(super) fn place_in_box<const D: usize>(
    scene: &Scene<D>,
    lower: Vector<D>,
    upper: Vector<D>,
    radius: f64,
    random: &mut Random,
) -> Option<Vector<D>> {
    let domain = &scene.domain;
    let mut centre = Vector::zeros();
    for axis in 0..D {
        let spans =
            domain.periodic[axis] && lower[axis] <= domain.lower[axis] && upper[axis] >= domain.upper[axis];
        let margin = if spans { 0.0 } else { radius };
        let (low, high) = (lower[axis] + margin, upper[axis] - margin);
        if low > high {
            return None;
        }
        centre[axis] = random.between(low, high);
    }
    Some(centre)
}
