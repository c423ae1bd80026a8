//! What the fluid leaves on disk: `series/fluid.csv`, `series/probes.csv`, `series/surface.csv`, `frames/fluid-N.vtu`.

use crate::backend::FluidBackend;
use crate::error::FluidError;
use crate::gauge::Gauge;
use case_io::output::series::{SeriesWriter, cut_after};
use case_io::output::vtk::Collection;
use std::path::{Path, PathBuf};

/// Open files of one run.
pub struct Record {
    out: PathBuf,
    probes: Vec<Gauge>,
    compress: bool,
    /// Whether the initial state is a frame.
    films_start: bool,
    fluid: Option<SeriesWriter>,
    probe: Option<SeriesWriter>,
    /// Only where there is a free surface.
    elevation: Option<SeriesWriter>,
    frames: Option<Collection>,
}

impl Record {
    /// Nothing is written before `start` or `resume`.
    pub fn new(out: &Path, probes: Vec<Gauge>, compress: bool, films_start: bool) -> Record {
        Record {
            out: out.to_path_buf(),
            probes,
            compress,
            films_start,
            fluid: None,
            probe: None,
            elevation: None,
            frames: None,
        }
    }

    fn series_path(&self, name: &str) -> PathBuf {
        self.out.join("series").join(format!("{name}.csv"))
    }

    fn index_path(&self) -> PathBuf {
        self.out.join("frames/fluid.pvd")
    }

    fn probe_titles(&self) -> Vec<String> {
        let mut titles = vec!["t[s]".to_string()];
        for Gauge { name, .. } in &self.probes {
            for column in ["ux[m/s]", "uy[m/s]", "uz[m/s]", "p[Pa]", "n_f[-]"] {
                titles.push(format!("{name}.{column}"));
            }
        }
        titles
    }

    /// Starts the series, and the frames if they are wanted in time, with the initial state.
    ///
    /// # Errors
    /// The disk's.
    pub fn start(&mut self, backend: &dyn FluidBackend) -> Result<(), FluidError> {
        let statistics = backend.statistics(0.0);
        if !statistics.is_empty() {
            let titles: Vec<&str> =
                std::iter::once("t[s]").chain(statistics.iter().map(|(title, _)| *title)).collect();
            self.fluid = Some(SeriesWriter::create(&self.series_path("fluid"), &titles)?);
        }
        if !self.probes.is_empty() {
            let titles = self.probe_titles();
            let titles: Vec<&str> = titles.iter().map(String::as_str).collect();
            self.probe = Some(SeriesWriter::create(&self.series_path("probes"), &titles)?);
            if backend.has_surface() {
                let titles = self.probes.iter().map(|Gauge { name, .. }| format!("{name}.height[m]"));
                let titles: Vec<String> = std::iter::once("t[s]".to_string()).chain(titles).collect();
                let titles: Vec<&str> = titles.iter().map(String::as_str).collect();
                self.elevation = Some(SeriesWriter::create(&self.series_path("surface"), &titles)?);
            }
        }
        if backend.nodes() > 0 {
            self.frames = Some(Collection::create(&self.index_path())?);
        }
        self.series(0.0, backend)?;
        if self.films_start { self.frame(0.0, 0, backend) } else { Ok(()) }
    }

    /// Goes on after `time`; later rows and frames are cut.
    ///
    /// # Errors
    /// The disk's, or series of another case.
    pub fn resume(&mut self, time: f64) -> Result<(), FluidError> {
        let reopen = |path: PathBuf| -> Result<Option<SeriesWriter>, FluidError> {
            if !path.exists() {
                return Ok(None);
            }
            cut_after(&path, time)?;
            let text = std::fs::read_to_string(&path).unwrap_or_default();
            let titles: Vec<&str> = text.lines().next().unwrap_or_default().split(',').collect();
            Ok(Some(SeriesWriter::append(&path, &titles)?))
        };
        self.fluid = reopen(self.series_path("fluid"))?;
        self.probe = reopen(self.series_path("probes"))?;
        self.elevation = reopen(self.series_path("surface"))?;
        if self.index_path().exists() {
            let mut frames = Collection::open(&self.index_path())?;
            frames.truncate_after(time)?;
            self.frames = Some(frames);
        }
        Ok(())
    }

    /// Appends a row to each series.
    ///
    /// # Errors
    /// The disk's.
    pub fn series(&mut self, time: f64, backend: &dyn FluidBackend) -> Result<(), FluidError> {
        if let Some(writer) = &mut self.fluid {
            let values = backend.statistics(time).into_iter().map(|(_, value)| value);
            writer.row(&std::iter::once(time).chain(values).collect::<Vec<f64>>())?;
        }
        if let Some(writer) = &mut self.probe {
            let mut row = vec![time];
            for probe in &self.probes {
                let value = probe.read(backend, time);
                row.extend(value.velocity);
                row.extend([value.pressure, value.void_fraction]);
            }
            writer.row(&row)?;
        }
        if let Some(writer) = &mut self.elevation {
            let heights = self.probes.iter().map(|probe| backend.elevation(probe.at).unwrap_or(f64::NAN));
            writer.row(&std::iter::once(time).chain(heights).collect::<Vec<f64>>())?;
        }
        Ok(())
    }

    /// Writes a frame and enters it in the index.
    ///
    /// # Errors
    /// The disk's.
    pub fn frame(&mut self, time: f64, number: u64, backend: &dyn FluidBackend) -> Result<(), FluidError> {
        let Some(frames) = &mut self.frames else { return Ok(()) };
        let stem = self.out.join(format!("frames/fluid-{number:05}"));
        if let Some(name) = backend.write_frame(&stem, self.compress)?.as_deref().and_then(Path::file_name) {
            frames.push(time, &name.to_string_lossy())?;
        }
        Ok(())
    }
}
