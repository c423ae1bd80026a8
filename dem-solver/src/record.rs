//! What the grains leave on disk: `series/grains.csv`, `series/walls.csv`, `frames/grains-N.vtp`.

use crate::error::DemError;
use crate::vector::embed;
use crate::wall::Walls;
use crate::world::World;
use case_io::output::series::{SeriesWriter, cut_after};
use case_io::output::vtk::{Collection, Compression, Field, Format, GrainPoints, Precision};
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
    /// Whether the initial state is a frame.
    films_start: bool,
    series: Option<SeriesWriter>,
    /// Only where there is a wall.
    walls: Option<SeriesWriter>,
    frames: Option<Collection>,
}

impl Record {
    /// Nothing is written before `start` or `resume`.
    pub fn new(out: &Path, compress: bool, films_start: bool) -> Record {
        let compression = if compress { Compression::Lz4 } else { Compression::None };
        let format = Format { precision: Precision::Single, compression };
        Record { out: out.to_path_buf(), format, films_start, series: None, walls: None, frames: None }
    }

    fn paths(&self) -> [PathBuf; 3] {
        ["series/grains.csv", "series/walls.csv", "frames/grains.pvd"].map(|path| self.out.join(path))
    }

    /// Starts the series, and the frames if they are wanted in time, with the initial state.
    ///
    /// # Errors
    /// The disk's.
    pub fn start<const D: usize>(&mut self, walls: &Walls<D>, world: &World<D>) -> Result<(), DemError> {
        let [series, of_walls, frames] = self.paths();
        self.series = Some(SeriesWriter::create(&series, &TITLES)?);
        self.frames = Some(Collection::create(&frames)?);
        // Of walls there are means over intervals: none ends here.
        self.grain_row(world)?;
        if !walls.is_empty() {
            let titles = wall_titles(walls);
            let titles: Vec<&str> = titles.iter().map(String::as_str).collect();
            self.walls = Some(SeriesWriter::create(&of_walls, &titles)?);
        }
        if self.films_start { self.frame(world, 0) } else { Ok(()) }
    }

    /// Goes on after `time`; later rows and frames are cut.
    ///
    /// # Errors
    /// The disk's, or files of another program.
    pub fn resume<const D: usize>(&mut self, walls: &Walls<D>, time: f64) -> Result<(), DemError> {
        let [series, of_walls, frames] = self.paths();
        cut_after(&series, time)?;
        self.series = Some(SeriesWriter::append(&series, &TITLES)?);
        if !walls.is_empty() {
            let titles = wall_titles(walls);
            let titles: Vec<&str> = titles.iter().map(String::as_str).collect();
            cut_after(&of_walls, time)?;
            self.walls = Some(SeriesWriter::append(&of_walls, &titles)?);
        }
        let mut collection = Collection::open(&frames)?;
        collection.truncate_after(time)?;
        self.frames = Some(collection);
        Ok(())
    }

    /// Appends a row of the grains and one of the walls.
    ///
    /// # Errors
    /// The disk's.
    pub fn row<const D: usize>(&mut self, walls: &Walls<D>, world: &World<D>) -> Result<(), DemError> {
        self.grain_row(world)?;
        self.wall_row(walls, world)
    }

    /// Force and torque of the grains on each wall, means over the time since the last row.
    fn wall_row<const D: usize>(&mut self, walls: &Walls<D>, world: &World<D>) -> Result<(), DemError> {
        let Some(series) = &mut self.walls else { return Ok(()) };
        let duration = world.time - world.received.since;
        let mut row = vec![world.time];
        for (impulse, point) in world.received.impulse.iter().zip(&walls.torque_about) {
            row.extend(&(embed(&impulse.linear) / duration));
            row.extend(&(impulse.about(point) / duration));
        }
        Ok(series.row(&row)?)
    }

    /// Means over all grains: place, velocity (not weighted), and what is largest.
    fn grain_row<const D: usize>(&mut self, world: &World<D>) -> Result<(), DemError> {
        let Some(series) = &mut self.series else { return Ok(()) };
        let grains = &world.grains;
        let count = grains.len() as f64;
        let (mut place, mut velocity) = ([0.0; 3], [0.0; 3]);
        let (mut fastest, mut highest, mut energy) = (0.0_f64, f64::NEG_INFINITY, 0.0);
        for (at, motion) in grains.place.iter().zip(&grains.motion) {
            let (centre, speed) = (embed(&at.centre), embed(&motion.velocity));
            (0..3).for_each(|k| {
                place[k] += centre[k] / count;
                velocity[k] += speed[k] / count;
            });
            fastest = fastest.max(motion.velocity.norm());
            highest = highest.max(at.centre[D - 1] + at.radius);
            if !motion.is_frozen() {
                energy += 0.5
                    * (motion.velocity.norm_squared() / motion.inverse_mass
                        + motion.angular_velocity.norm_squared() / motion.inverse_inertia);
            }
        }
        let [x, y, z] = place;
        let [vx, vy, vz] = velocity;
        let row = [world.time, count, x, y, z, vx, vy, vz, fastest, highest, energy];
        Ok(series.row(&row)?)
    }

    /// Writes a frame and enters it in the index.
    ///
    /// # Errors
    /// The disk's.
    pub fn frame<const D: usize>(&mut self, world: &World<D>, number: u64) -> Result<(), DemError> {
        let Some(frames) = &mut self.frames else { return Ok(()) };
        let grains = &world.grains;
        let centres: Vec<[f64; D]> = grains.place.iter().map(|place| place.centre.into()).collect();
        let radii: Vec<f64> = grains.place.iter().map(|place| place.radius).collect();
        let velocities: Vec<[f64; D]> = grains.motion.iter().map(|motion| motion.velocity.into()).collect();
        let spins: Vec<[f64; 3]> =
            grains.motion.iter().map(|motion| motion.angular_velocity.into()).collect();
        let materials: Vec<u64> = grains.material.iter().map(|material| u64::from(*material)).collect();
        let fields = [
            Field::whole("id", &grains.id),
            Field::scalar("radius", &radii),
            Field::vector("velocity", &velocities),
            Field::vector("angular_velocity", &spins),
            Field::whole("material", &materials),
        ];
        let name = format!("grains-{number:05}.vtp");
        let points = GrainPoints { centres: &centres, fields: &fields };
        points.write(&self.out.join("frames").join(&name), self.format)?;
        Ok(frames.push(world.time, &name)?)
    }
}

/// Force f and torque t, three components each.
fn wall_titles<const D: usize>(walls: &Walls<D>) -> Vec<String> {
    let of_wall = |name: &String| {
        let title = |(quantity, unit): (&str, &str)| format!("{name}-{quantity}[{unit}]");
        [("fx", "N"), ("fy", "N"), ("fz", "N"), ("tx", "N m"), ("ty", "N m"), ("tz", "N m")].map(title)
    };
    std::iter::once("t[s]".to_string()).chain(walls.names.iter().flat_map(of_wall)).collect()
}
