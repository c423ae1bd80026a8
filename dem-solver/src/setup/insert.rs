//! The grains of a case.

use case_io::document::{self, Case, Insertion, Placement};

use super::clumps::start;
use super::refused_at;
use super::region::region;
use super::sizes::sizes;
use super::surroundings::material_index;
use crate::error::DemError;
use crate::insertion::{
    Amount, Ball, Batch, Distribution, Feed, Flow, Lattice, LatticeKind, Random, RandomFill, Sizes,
    read_grains,
};
use crate::scene::Scene;
use crate::vector::{Spin, Vector, restrict};
use crate::world::World;

/// More grains than this from one lattice are taken for a mistake in its spacing.
const MOST_GRAINS: f64 = 1e8;

/// The world of a case at the start: each insertion in the order of the case, with random numbers of its own; and
/// the row of the first grain of each.
pub fn insert<const D: usize>(case: &Case, scene: &Scene<D>) -> Result<(World<D>, Vec<usize>), DemError> {
    let mut world = World::new();
    let mut firsts = Vec::new();
    for (index, insertion) in case.document.insertion.iter().enumerate() {
        firsts.push(world.grains.len());
        let mut random = Random::new(case.document.case.seed ^ (index as u64) << 32);
        let batch = batch(case, scene, index, insertion)?;
        let place = Place { case, index, scene, insertion };
        match insertion.placement() {
            Some(Placement::At(points)) => {
                for point in points {
                    let radius = batch.sizes.draw(&mut random);
                    let place = Ball { centre: Vector::from(point.to_array()), radius };
                    batch.add(scene, &mut world, &place, &mut random);
                }
            }
            Some(Placement::Lattice(lattice)) => place.lattice(lattice, &batch, &mut random, &mut world)?,
            Some(Placement::Random(stated)) => {
                let amount = match (stated.count, stated.solid_fraction) {
                    (Some(count), _) => Amount::Count(count as usize),
                    (None, fraction) => Amount::SolidFraction(fraction.unwrap_or_default()),
                };
                let key = format!("insertion[{index}].{}", stated.key);
                let fill = RandomFill { region: region(case, &key, stated.region)?, amount };
                fill.insert(scene, &mut world, &batch, &mut random)
                    .map_err(|error| refused_at(case, &key, error))?;
            }
            Some(Placement::File(file)) => place.file(file, &batch, &mut random, &mut world)?,
            Some(Placement::Rate(rate)) => world.feeds.push(feed(case, index, rate, batch, random)?),
            None => {
                let allowed = "one way to place grains";
                return Err(case.error(&format!("insertion[{index}]"), "no placement", allowed, "").into());
            }
        }
    }
    Ok((world, firsts))
}

fn batch<const D: usize>(
    case: &Case,
    scene: &Scene<D>,
    index: usize,
    insertion: &Insertion,
) -> Result<Batch<D>, DemError> {
    let clump = start(case, index);
    let material = material_index(case, &insertion.material, &format!("insertion[{index}].material"))?;
    Ok(Batch {
        name: insertion.name.clone(),
        material,
        sizes: match clump {
            Some(start) => Sizes::All(scene.clumps[start.kind as usize].shape.bounding_radius()),
            None => sizes::<D>(case, index, insertion)?,
        },
        clump,
        velocity: insertion
            .velocity
            .as_ref()
            .map_or(Vector::zeros(), |velocity| Vector::from(velocity.to_array())),
        frozen: insertion.frozen,
    })
}

fn feed<const D: usize>(
    case: &Case,
    index: usize,
    rate: &document::Rate,
    batch: Batch<D>,
    random: Random,
) -> Result<Feed<D>, DemError> {
    let Some(stated) = rate.region() else {
        return Err(case.error(&format!("insertion[{index}].rate"), "no region", "", "state one").into());
    };
    let flow = match (rate.mass_rate, rate.number_rate) {
        (Some(mass), _) => Flow::Mass(mass.si()),
        (None, number) => Flow::Number(number.map_or(0.0, |number| number.si())),
    };
    Ok(Feed {
        batch,
        region: region(case, &format!("insertion[{index}].rate.stl"), stated)?,
        flow,
        start: rate.start.map_or(0.0, |start| start.si()),
        stop: rate.stop.unwrap_or(case.document.time.end).si(),
        random,
        fed: 0.0,
        count: 0,
        refused: 0,
        waiting: None,
    })
}

/// One insertion of the case.
struct Place<'a, const D: usize> {
    case: &'a Case,
    index: usize,
    scene: &'a Scene<D>,
    insertion: &'a Insertion,
}

impl<const D: usize> Place<'_, D> {
    fn lattice(
        &self,
        lattice: &document::Lattice,
        batch: &Batch<D>,
        random: &mut Random,
        world: &mut World<D>,
    ) -> Result<(), DemError> {
        let lattice = Lattice {
            lower: Vector::from(lattice.lower.to_array()),
            upper: Vector::from(lattice.upper.to_array()),
            spacing: lattice.spacing.si(),
            kind: match lattice.kind {
                document::LatticeKind::SimpleCubic => LatticeKind::SimpleCubic,
                document::LatticeKind::Hexagonal => LatticeKind::Hexagonal,
            },
            turn: lattice.turn.map_or(0.0, |turn| turn.si()),
        };
        if lattice.estimate() > MOST_GRAINS {
            let found = format!("about {:.1e} grains", lattice.estimate());
            let key = format!("insertion[{}].lattice.spacing", self.index);
            return Err(self.case.error(&key, found, "no more than 1e8", "take a larger spacing").into());
        }
        for centre in lattice.centres() {
            let radius = batch.sizes.draw(random);
            batch.add(self.scene, world, &Ball { centre, radius }, random);
        }
        Ok(())
    }

    fn file(
        &self,
        file: &document::GrainFile,
        batch: &Batch<D>,
        random: &mut Random,
        world: &mut World<D>,
    ) -> Result<(), DemError> {
        let key = format!("insertion[{}].file.path", self.index);
        let grains =
            read_grains(&self.case.folder.join(&file.path)).map_err(|error| error.at_key(self.case, &key))?;
        for stated in grains {
            let own = !self.insertion.is_sized();
            let radius = if own { stated.radius } else { Some(batch.sizes.draw(random)) };
            let radius = radius.ok_or_else(|| {
                let key = format!("insertion[{}].diameter", self.index);
                self.case.error(
                    &key,
                    "missing, and the file has no diameters either",
                    "",
                    "state one of them",
                )
            })?;
            let mut grain = batch.grain(restrict(&stated.centre.into()), radius);
            if let (Some(velocity), None, false) = (stated.velocity, &self.insertion.velocity, batch.frozen) {
                grain.velocity = restrict(&velocity.into());
            }
            grain.angular_velocity = stated.angular_velocity.map_or(Spin::zeros(), Spin::from);
            world.add(self.scene, &grain);
        }
        Ok(())
    }
}
