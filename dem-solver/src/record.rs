//! What the grains leave on disk: `series/{grains,bulk,walls,bonds,turnover}.csv`, `frames/grains-N.vtp`.

use crate::bond_series::{bond_row, bond_titles};
use crate::bulk::{bulk_row, bulk_titles};
use crate::error::DemError;
use crate::grain_fields::write_grains;
use crate::grains::Place;
use crate::kinetic_energy::kinetic_energies;
use crate::scene::Scene;
use crate::turnover_series::{turnover_row, turnover_titles};
use crate::vector::embed;
use crate::world::World;
use case_io::document::{GrainField, OutputTable};
use case_io::output::series::{SeriesWriter, cut_after};
use case_io::output::vtk::{Collection, Compression, Format, Precision};
use std::path::{Path, PathBuf};

const TITLES: [&str; 11] = [
    "t[s]",
    "count[-]",
    "x[m]",
    "y[m]",
    "z[m]",
    "vx[m/s]",
    "vy[m/s]",
    "vz[m/s]",
    "speed-max[m/s]",
    "height-max[m]",
    "kinetic-energy[J]",
];

/// Open files of one run.
pub struct Record {
    out: PathBuf,
    format: Format,
    /// Those of the grains in frames.
    fields: Vec<GrainField>,
    /// Whether the initial state is a frame.
    films_start: bool,
    series: Option<SeriesWriter>,
    /// Only where grains can touch.
    bulk: Option<SeriesWriter>,
    /// Only where there is a wall.
    walls: Option<SeriesWriter>,
    /// Only where there are bonds.
    bonds: Option<SeriesWriter>,
    /// Only where grains may come or go.
    turnover: Option<SeriesWriter>,
    frames: Option<Collection>,
}

impl Record {
    /// Nothing is written before `start` or `resume`.
    pub fn new(out: &Path, output: &OutputTable) -> Record {
        let compression = if output.compress { Compression::Lz4 } else { Compression::None };
        let format = Format { precision: Precision::Single, compression };
        Record {
            out: out.to_path_buf(),
            format,
            fields: output.fields().to_vec(),
            films_start: output.films_start(),
            series: None,
            bulk: None,
            walls: None,
            bonds: None,
            turnover: None,
            frames: None,
        }
    }

    fn paths(&self) -> [PathBuf; 6] {
        [
            "series/grains.csv",
            "series/bulk.csv",
            "series/walls.csv",
            "series/bonds.csv",
            "series/turnover.csv",
            "frames/grains.pvd",
        ]
        .map(|path| self.out.join(path))
    }

    /// Starts the series, and the frames if they are wanted in time, with the initial state.
    ///
    /// # Errors
    /// The disk's.
    pub fn start<const D: usize>(&mut self, scene: &Scene<D>, world: &World<D>) -> Result<(), DemError> {
        let [series, of_bulk, of_walls, of_bonds, of_turnover, frames] = self.paths();
        self.series = Some(SeriesWriter::create(&series, &TITLES)?);
        self.frames = Some(Collection::create(&frames)?);
        // Of walls there are means over intervals: none ends here. Contacts are not known before the first window.
        self.grain_row(world)?;
        self.bulk = begin(&of_bulk, &bulk_titles(scene))?;
        self.walls = begin(&of_walls, &wall_titles(scene))?;
        self.bonds = begin(&of_bonds, &bond_titles(scene))?;
        self.bond_row(scene, world)?;
        self.turnover = begin(&of_turnover, &turnover_titles(scene, world))?;
        self.turnover_row(scene, world)?;
        if self.films_start { self.frame(scene, world, 0) } else { Ok(()) }
    }

    /// Goes on after the world's time; later rows and frames are cut.
    ///
    /// # Errors
    /// The disk's, or files of another program.
    pub fn resume<const D: usize>(&mut self, scene: &Scene<D>, world: &World<D>) -> Result<(), DemError> {
        let time = world.time;
        let [series, of_bulk, of_walls, of_bonds, of_turnover, frames] = self.paths();
        cut_after(&series, time)?;
        self.series = Some(SeriesWriter::append(&series, &TITLES)?);
        self.bulk = go_on(&of_bulk, &bulk_titles(scene), time)?;
        self.walls = go_on(&of_walls, &wall_titles(scene), time)?;
        self.bonds = go_on(&of_bonds, &bond_titles(scene), time)?;
        self.turnover = go_on(&of_turnover, &turnover_titles(scene, world), time)?;
        let mut collection = Collection::open(&frames)?;
        collection.truncate_after(time)?;
        self.frames = Some(collection);
        Ok(())
    }

    /// Appends a row of the grains, one of their contacts, one of the walls, one of the bonds and one of those that
    /// came and went.
    ///
    /// # Errors
    /// The disk's.
    pub fn row<const D: usize>(&mut self, scene: &Scene<D>, world: &World<D>) -> Result<(), DemError> {
        self.grain_row(world)?;
        self.bulk_row(scene, world)?;
        self.wall_row(scene, world)?;
        self.bond_row(scene, world)?;
        self.turnover_row(scene, world)
    }

    fn bond_row<const D: usize>(&mut self, scene: &Scene<D>, world: &World<D>) -> Result<(), DemError> {
        let Some(series) = &mut self.bonds else { return Ok(()) };
        Ok(series.row(&bond_row(scene, world)?)?)
    }

    fn bulk_row<const D: usize>(&mut self, scene: &Scene<D>, world: &World<D>) -> Result<(), DemError> {
        let Some(series) = &mut self.bulk else { return Ok(()) };
        Ok(series.row(&bulk_row(scene, world))?)
    }

    fn turnover_row<const D: usize>(&mut self, scene: &Scene<D>, world: &World<D>) -> Result<(), DemError> {
        let Some(series) = &mut self.turnover else { return Ok(()) };
        Ok(series.row(&turnover_row(scene, world))?)
    }

    /// Force and torque of the grains on each wall, means over the time since the last row.
    fn wall_row<const D: usize>(&mut self, scene: &Scene<D>, world: &World<D>) -> Result<(), DemError> {
        let Some(series) = &mut self.walls else { return Ok(()) };
        let duration = world.time - world.received.since;
        let mut row = vec![world.time];
        for (impulse, point) in world.received.impulse.iter().zip(&scene.walls.torque_about) {
            row.extend(&(embed(&impulse.linear) / duration));
            row.extend(&(impulse.about(point) / duration));
        }
        Ok(series.row(&row)?)
    }

    /// Means over all grains and clumps: place, velocity (not weighted), and what is largest.
    fn grain_row<const D: usize>(&mut self, world: &World<D>) -> Result<(), DemError> {
        let Some(series) = &mut self.series else { return Ok(()) };
        let World { grains, bodies, .. } = world;
        let rows = grains.place.iter().zip(&grains.motion).filter(|(_, motion)| !motion.is_carried());
        let of_grains = rows.map(|(at, motion)| (at.centre, motion.velocity));
        let of_clumps = bodies.as_slice().iter().map(|clump| (clump.body.centre, clump.body.velocity));
        let all = of_grains.chain(of_clumps);
        let count = all.clone().count() as f64;
        let (mut place, mut velocity, mut fastest) = ([0.0; 3], [0.0; 3], 0.0_f64);
        for (centre, speed) in all {
            (0..3).for_each(|k| {
                place[k] += centre[k] / count;
                velocity[k] += speed[k] / count;
            });
            fastest = fastest.max(speed.norm());
        }
        let top = |at: &Place| at.centre[D - 1] + at.radius;
        let highest = grains.place.iter().map(top).fold(f64::NEG_INFINITY, f64::max);
        let energy = kinetic_energies(world).iter().sum();
        let [x, y, z] = place;
        let [vx, vy, vz] = velocity;
        let row = [world.time, count, x, y, z, vx, vy, vz, fastest, highest, energy];
        Ok(series.row(&row)?)
    }

    /// Writes a frame and enters it in the index.
    ///
    /// # Errors
    /// The disk's.
    pub fn frame<const D: usize>(
        &mut self,
        scene: &Scene<D>,
        world: &World<D>,
        number: u64,
    ) -> Result<(), DemError> {
        let Some(frames) = &mut self.frames else { return Ok(()) };
        let name = format!("grains-{number:05}.vtp");
        write_grains(&self.out.join("frames").join(&name), self.format, &self.fields, scene, world)?;
        Ok(frames.push(world.time, &name)?)
    }
}

/// A new series, unless it would hold nothing but the time.
fn begin(path: &Path, titles: &[String]) -> Result<Option<SeriesWriter>, DemError> {
    if titles.is_empty() {
        return Ok(None);
    }
    Ok(Some(SeriesWriter::create(path, &timed(titles))?))
}

/// A series that goes on after a time \[s\].
fn go_on(path: &Path, titles: &[String], time: f64) -> Result<Option<SeriesWriter>, DemError> {
    if titles.is_empty() {
        return Ok(None);
    }
    cut_after(path, time)?;
    Ok(Some(SeriesWriter::append(path, &timed(titles))?))
}

fn timed(titles: &[String]) -> Vec<&str> {
    std::iter::once("t[s]").chain(titles.iter().map(String::as_str)).collect()
}

/// Force f and torque t, three components each.
fn wall_titles<const D: usize>(scene: &Scene<D>) -> Vec<String> {
    let of_wall = |name: &String| {
        let title = |(quantity, unit): (&str, &str)| format!("{name}-{quantity}[{unit}]");
        [("fx", "N"), ("fy", "N"), ("fz", "N"), ("tx", "N m"), ("ty", "N m"), ("tz", "N m")].map(title)
    };
    scene.walls.names.iter().flat_map(of_wall).collect()
}
