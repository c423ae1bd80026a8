//! What the fluid writes: statistics and frames.

use super::backend::Setting;
use super::cloud::Cloud;
use super::flow::Residuals;
use super::grains::GrainsInCloud;
use super::remesh::volumes_between_grains;
use super::state::State;
use crate::element::simplex::{Vector, dot};
use crate::error::FluidError;
use case_io::output::vtk::{Compression, Field, Format, Precision, UnstructuredGrid};
use std::path::{Path, PathBuf};

/// Volume and energy, by what changed them: name with unit, value. In 2D those of the slab.
pub fn audits<const D: usize, const N: usize>(
    state: &State<D, N>,
    setting: &Setting<D>,
    grains: &GrainsInCloud<D, N>,
) -> Vec<(&'static str, f64)> {
    let (books, depth, density) = (&state.books.volume, setting.depth, setting.density);
    let (kinetic, potential) = state.energies(density, &setting.acceleration, grains.void_fraction());
    let remeshing = &state.books.energy;
    let lifted: f64 = (0..D).map(|k| setting.acceleration[k] * remeshing.moment[k].sum).sum();
    let by_remeshing = density * (remeshing.kinetic.sum - remeshing.limiter.sum - lifted);
    vec![
        ("volume[m^3]", depth * (books.cells + books.drops)),
        ("volume-error[-]", books.error()),
        ("volume-error-max[-]", books.largest_error),
        ("volume-entered[m^3]", depth * state.passed.entered.volume),
        ("volume-left[m^3]", depth * state.passed.left.volume),
        ("drops[m^3]", depth * books.drops),
        ("volume-by-flow[m^3]", depth * books.flow.sum),
        ("volume-by-management[m^3]", depth * books.management.sum),
        ("volume-by-overlap[m^3]", depth * books.overlap.sum),
        ("volume-by-merging[m^3]", depth * books.merging.sum),
        ("volume-by-separation[m^3]", depth * books.separation.sum),
        ("volume-by-absorption[m^3]", depth * books.absorption.sum),
        ("volume-by-correction[m^3]", depth * books.correction.sum),
        ("volume-moved-by-correction[m^3]", depth * books.correction.absolute),
        ("kinetic-energy[J]", depth * kinetic),
        ("potential-energy[J]", depth * potential),
        ("energy[J]", depth * (kinetic + potential)),
        ("energy-by-remeshing[J]", depth * by_remeshing),
        ("energy-by-limiter[J]", depth * density * remeshing.limiter.sum),
        ("energy-lost[J]", depth * (state.given - kinetic - potential)),
    ]
}

/// The audits, momentum, extremes, what the last step left of its equations: name with unit, value. In 2D those of the slab.
pub fn statistics<const D: usize, const N: usize>(
    state: &State<D, N>,
    setting: &Setting<D>,
    grains: &GrainsInCloud<D, N>,
    residuals: Residuals,
) -> Vec<(&'static str, f64)> {
    const MOMENTUM: [&str; 3] = ["momentum-x[kg m/s]", "momentum-y[kg m/s]", "momentum-z[kg m/s]"];
    const REACH: [[&str; 2]; 3] =
        [["x-min[m]", "x-max[m]"], ["y-min[m]", "y-max[m]"], ["z-min[m]", "z-max[m]"]];
    let (cloud, depth) = (&state.cloud, setting.depth);
    let mut found = audits(state, setting, grains);
    let mass = volumes_between_grains(cloud, grains.void_fraction());
    let momentum = |k: usize| mass.iter().zip(&cloud.velocity).map(|(mass, v)| mass * v[k]).sum::<f64>();
    found.extend((0..D).map(|k| (MOMENTUM[k], depth * setting.density * momentum(k))));
    const ENTERED: [&str; 3] =
        ["momentum-entered-x[kg m/s]", "momentum-entered-y[kg m/s]", "momentum-entered-z[kg m/s]"];
    const LEFT: [&str; 3] = ["momentum-left-x[kg m/s]", "momentum-left-y[kg m/s]", "momentum-left-z[kg m/s]"];
    for (names, amount) in [(ENTERED, &state.passed.entered), (LEFT, &state.passed.left)] {
        found.extend((0..D).map(|k| (names[k], depth * setting.density * amount.momentum[k])));
    }
    // A fluid without nodes has no extremes.
    let largest = |values: &mut dyn Iterator<Item = f64>| values.reduce(f64::max).unwrap_or(0.0);
    for (k, [lowest, highest]) in REACH.into_iter().take(D).enumerate() {
        let wet = mass.iter().zip(&cloud.drop).map(|(mass, drop)| *drop == 0.0 && *mass > 0.0);
        let reach = |sign: f64| {
            let places = cloud.place.iter().zip(wet.clone()).filter(|(_, wet)| *wet);
            sign * largest(&mut places.map(|(x, _)| sign * x[k]))
        };
        found.extend([(lowest, reach(-1.0)), (highest, reach(1.0))]);
    }
    let drops = cloud.drop.iter().filter(|&&drop| drop > 0.0).count();
    found.extend([
        ("speed-max[m/s]", largest(&mut cloud.velocity.iter().map(|v| dot(v, v).sqrt()))),
        ("pressure-min[Pa]", -largest(&mut cloud.pressure.iter().map(|p| -p))),
        ("pressure-max[Pa]", largest(&mut cloud.pressure.iter().copied())),
        ("momentum-residual[-]", residuals.momentum),
        ("volume-residual[-]", residuals.volume),
        ("grains-volume[m^3]", depth * grains.wetted_volume()),
        ("void-fraction-min[-]", -largest(&mut grains.void_fraction().iter().map(|void| -void))),
        ("nodes[-]", cloud.place.len() as f64),
        ("cells[-]", cloud.cells.len() as f64),
        ("drop-count[-]", drops as f64),
    ]);
    found
}

/// Writes nodes and cells with velocity, pressure, void fraction and the volume of drops, which belong to no cell, to a VTU file.
///
/// # Errors
/// The disk's.
pub fn write_frame<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    void_fraction: &[f64],
    path: &Path,
    compress: bool,
) -> Result<PathBuf, FluidError> {
    let velocity: &[Vector<D>] = &cloud.velocity;
    let grid = UnstructuredGrid {
        points: &cloud.place,
        cells: &cloud.cells,
        point_fields: &[
            Field::vector("velocity", velocity),
            Field::scalar("pressure", &cloud.pressure),
            Field::scalar("void_fraction", void_fraction),
            Field::scalar("drop", &cloud.drop),
        ],
        cell_fields: &[],
    };
    let compression = if compress { Compression::Lz4 } else { Compression::None };
    grid.write(path, Format { precision: Precision::default(), compression })?;
    Ok(path.to_path_buf())
}
