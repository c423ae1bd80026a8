//! This program's run of the case, by the coupler as every run, with a window and a frame or row for each sample.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use case_io::document::Case;
use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use case_io::output::series::{Column, Series};
use case_io::output::vtk::{Collection, Frame, FrameField};

use super::error::PeerError;
use super::own_case::own_case;
use super::results::{State, Statistics, Trajectories};
use super::task::Task;

/// A run of this program.
pub struct OwnRun {
    /// Its folder.
    pub out: PathBuf,
}

impl OwnRun {
    /// Runs the case with the step and the samples of the task, on so many threads (0: all cores), beside the case
    /// as it is run, with all changes applied.
    ///
    /// # Errors
    /// No coupler beside this program; a run that did not get to its end.
    pub fn run(out: PathBuf, case: &Case, task: &Task, threads: usize) -> Result<Self, PeerError> {
        let file = out.with_extension("toml");
        fs::write(&file, own_case(case, task)?).map_err(OutputError::system("write", &file))?;
        let path = std::env::current_exe().map(|own| own.with_file_name("coupler")).unwrap_or_default();
        let mut command = Command::new(&path);
        command.arg("run").arg(&file).arg("--out").arg(&out).args([
            "--quiet",
            "--threads",
            &threads.to_string(),
        ]);
        let status = command.stdin(Stdio::null()).stdout(Stdio::null()).status();
        let status = status.map_err(|source| PeerError::NoCoupler { path, source })?;
        let code = status.code().and_then(|code| u8::try_from(code).ok());
        match code.and_then(|code| ExitCode::try_from(code).ok()) {
            Some(ExitCode::Done) => Ok(Self { out }),
            code => Err(PeerError::OwnRun { code: code.unwrap_or(ExitCode::PeerDied), out }),
        }
    }

    /// The trajectories, of single precision as frames are.
    ///
    /// # Errors
    /// Frames that are missing or are not of these grains.
    pub fn trajectories(&self, task: &Task) -> Result<Trajectories, PeerError> {
        let index = self.out.join("frames/grains.pvd");
        let collection = Collection::open(&index)?;
        let bad = |problem: &str| PeerError::BadResult {
            path: index.clone(),
            problem: problem.into(),
            expected: format!("{} grains at each of {} samples", task.grains.len(), task.samples),
        };
        let entries = collection.entries();
        if entries.len() != task.samples as usize + 1 {
            return Err(bad(&format!("{} frames", entries.len())));
        }
        let states = entries[1..].iter().map(|entry| {
            let frame = Frame::read(&index.with_file_name(&entry.file))?;
            states(&frame, task.grains.len())
                .ok_or_else(|| bad(&format!("{}: other grains or fields", entry.file)))
        });
        states.collect()
    }

    /// The statistics.
    ///
    /// # Errors
    /// Series that are missing or of other columns.
    pub fn statistics(&self, task: &Task) -> Result<Statistics, PeerError> {
        let samples = task.samples as usize;
        let read = |name: &str| {
            let path = self.out.join(name);
            let series = Series::read(&path)?;
            // The last rows: the series of the grains has one of the start.
            let column = move |name: &str| {
                let values = series.column(name).map(|Column { values, .. }| values);
                let skip = values.and_then(|values| values.len().checked_sub(samples));
                values.zip(skip).map(|(values, skip)| values[skip..].to_vec()).ok_or_else(|| {
                    PeerError::BadResult {
                        path: path.clone(),
                        problem: format!("no column {name} of {samples} rows"),
                        expected: "the series of this run".into(),
                    }
                })
            };
            Ok::<_, PeerError>(column)
        };
        let grains = read("series/grains.csv")?;
        let mut on_walls = Vec::new();
        if !task.walls.is_empty() {
            let walls = read("series/walls.csv")?;
            for wall in &task.walls {
                let force = |axis: &str| walls(&format!("{}-f{axis}", wall.name));
                on_walls.push([force("x")?, force("y")?, force("z")?]);
            }
        }
        Ok(Statistics {
            count: grains("count")?,
            centre: [grains("x")?, grains("y")?, grains("z")?],
            kinetic_energy: grains("kinetic-energy")?,
            on_walls,
        })
    }
}

/// The grains of a frame by their identity.
fn states(frame: &Frame, count: usize) -> Option<Vec<State>> {
    let field = |name: &str| frame.point_field(name).map(|FrameField { values, .. }| values);
    let (ids, velocity, spin) = (field("id")?, field("velocity")?, field("angular_velocity")?);
    let three = |values: &[f64], row: usize| -> Option<[f64; 3]> {
        values.get(3 * row..3 * row + 3)?.try_into().ok()
    };
    let mut states = vec![None; count];
    for (row, (&id, point)) in ids.iter().zip(&frame.points).enumerate() {
        *states.get_mut(id as usize)? = Some(State {
            centre: (*point).into(),
            velocity: three(velocity, row)?.into(),
            angular_velocity: three(spin, row)?.into(),
        });
    }
    states.into_iter().collect()
}
