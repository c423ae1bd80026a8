//! The frames of a run in time.

use std::path::{Path, PathBuf};

use case_io::output::vtk::{Collection, CollectionEntry, Frame};

use super::scene_of;
use crate::picture::Scene;

/// The frames of the grains and of the fluid, dated.
#[derive(Debug, Default)]
pub(crate) struct Films {
    grains: Vec<Dated>,
    fluid: Vec<Dated>,
}

#[derive(Debug)]
struct Dated {
    time: f64,
    path: PathBuf,
}

/// A scene and its time \[s\].
#[derive(Debug)]
pub(crate) struct Moment {
    pub(crate) time: f64,
    pub(crate) scene: Scene,
}

impl Films {
    pub(super) fn open(indices: &[PathBuf], notes: &mut Vec<String>) -> Self {
        let mut films = Self::default();
        for index in indices {
            match Collection::open(index) {
                Ok(collection) => collection.entries().iter().for_each(|entry| films.add(index, entry)),
                Err(fault) => notes.push(fault.to_string()),
            }
        }
        for film in [&mut films.grains, &mut films.fluid] {
            film.sort_by(|a, b| a.time.total_cmp(&b.time));
        }
        films
    }

    fn add(&mut self, index: &Path, CollectionEntry { time, file }: &CollectionEntry) {
        let path = index.with_file_name(file);
        let dated = Dated { time: *time, path };
        match dated.path.extension().and_then(|extension| extension.to_str()) {
            Some("vtp") => self.grains.push(dated),
            Some("vtu") => self.fluid.push(dated),
            _ => {}
        }
    }

    /// First, middle and last moment; fewer if the run was short.
    pub(crate) fn moments(&self, notes: &mut Vec<String>) -> Vec<Moment> {
        let mut times: Vec<f64> = self.grains.iter().chain(&self.fluid).map(|dated| dated.time).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        let Some(last) = times.len().checked_sub(1) else { return Vec::new() };
        let mut chosen = vec![0, last / 2, last];
        chosen.dedup();
        chosen
            .into_iter()
            .map(|number| {
                let time = times[number];
                let mut read = |film: &[Dated]| {
                    // A participant that writes more rarely shows its latest frame.
                    let dated = film.iter().rev().find(|dated| dated.time <= time)?;
                    Frame::read(&dated.path).map_err(|fault| notes.push(fault.to_string())).ok()
                };
                let (grains, fluid) = (read(&self.grains), read(&self.fluid));
                Moment { time, scene: scene_of(grains.as_ref(), fluid.as_ref()) }
            })
            .filter(|moment| moment.scene.bounds().is_some())
            .collect()
    }
}
