//! The report as a whole.

use std::path::Path;

use case_io::output::replace_file;
use case_io::summary::Summary;

use crate::page::{self, Figure};
use crate::picture::{Bounds, FluidView, PictureOptions, picture_of};
use crate::run::{Moment, Run};
use crate::{ReportError, Scene};

/// Reads what the run in `directory` has left and writes `report.html`, and `picture.png` if there are frames.
///
/// A file that cannot be read is named in the report; a run without `summary.json` is reported as unfinished.
///
/// # Errors
/// No run in the directory, or a report that cannot be written.
pub fn report(directory: &Path) -> Result<(), ReportError> {
    let mut run = Run::read(directory)?;
    let moments = run.films.moments(&mut run.notes);
    let figures = figures(&moments)?;
    if let Some(last) = figures.last() {
        replace_file(&directory.join("picture.png"), &[&last.png])?;
    }
    let html = page::html(&run, &figures)?;
    Ok(replace_file(&directory.join("report.html"), &[html.as_bytes()])?)
}

/// Writes `report.html` over all runs of a sweep; each has its own report in the folder of its name beside it.
///
/// # Errors
/// A report that cannot be written.
pub fn report_of_sweep(directory: &Path, title: &str, runs: &[(String, Summary)]) -> Result<(), ReportError> {
    let html = page::sweep_html(title, runs);
    Ok(replace_file(&directory.join("report.html"), &[html.as_bytes()])?)
}

/// Pictures in one frame and with one scale of colours, so that they can be compared.
fn figures(moments: &[Moment]) -> Result<Vec<Figure>, ReportError> {
    let scenes = || moments.iter().map(|moment| &moment.scene);
    let largest = |which: usize| {
        scenes()
            .filter_map(|scene| scene.value_ranges()[which])
            .map(|range| (0.0, range.1))
            .reduce(|a, b| (0.0, f64::max(a.1, b.1)))
    };
    let mut options = PictureOptions {
        bounds: scenes().filter_map(Scene::bounds).reduce(Bounds::union),
        fluid_view: if mesh_moves(moments) { FluidView::Surface } else { FluidView::Slice },
        grain_range: largest(0),
        fluid_range: largest(1),
        size: [900, 560],
        ..PictureOptions::default()
    };
    moments
        .iter()
        .map(|moment| {
            options.caption = format!("t = {} s", page::number(moment.time));
            Ok(Figure { caption: options.caption.clone(), png: picture_of(&moment.scene, &options)? })
        })
        .collect()
}

/// A Lagrangian mesh has a surface worth seeing; a fixed one has the walls of its box.
fn mesh_moves(moments: &[Moment]) -> bool {
    let mut meshes = moments.iter().filter_map(|moment| moment.scene.mesh.as_ref());
    meshes.next().is_some_and(|first| meshes.any(|later| later.points != first.points))
}
