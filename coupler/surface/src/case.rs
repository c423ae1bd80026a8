//! What a case states of a surface.

use case_io::document::{self, Case, MotionTable, SurfaceFile, unit_vector};

use crate::error::InputError;
use crate::facet::Facet;
use crate::motion::{Motion, Table, TableRow};
use crate::triangles::{Format, read_triangles};
use crate::vector::{Spin, Vector};

/// The sum of the motions stated at a key.
///
/// # Errors
/// A table in a file that cannot be read or is none.
pub fn motion<const D: usize>(
    case: &Case,
    key: &str,
    stated: &document::Motion,
) -> Result<Motion<D>, InputError> {
    let none = Motion::none();
    let (rotation, over_time) = (stated.rotation.as_ref(), stated.table.as_ref());
    let oscillation = stated.oscillation.as_ref();
    let point = rotation.map(|rotation| &rotation.point).or(over_time.and_then(|table| table.point.as_ref()));
    let table = over_time.map(|stated| table(case, &format!("{key}.table"), stated, rotation.is_some()));
    Ok(Motion {
        translation: stated.translation.as_ref().map_or(none.translation, |v| v.to_array().into()),
        amplitude: oscillation.map_or(none.amplitude, |oscillation| {
            Vector::from(unit_vector(&oscillation.direction)) * oscillation.amplitude.si()
        }),
        frequency: oscillation.map_or(none.frequency, |oscillation| oscillation.frequency.si()),
        point: point.map_or(none.point, |point| point.to_array().into()),
        angular_velocity: rotation
            .map_or(none.angular_velocity, |rotation| axis(rotation.axis.as_deref()) * rotation.rate.si()),
        table: table.transpose()?,
    })
}

/// A stated axis; in 2D it is z.
fn axis(stated: Option<&[f64]>) -> Spin {
    Spin::from(stated.map_or([0.0, 0.0, 1.0], unit_vector))
}

fn table<const D: usize>(
    case: &Case,
    key: &str,
    stated: &MotionTable,
    rotates: bool,
) -> Result<Table<D>, InputError> {
    // Loading has checked that the point of an axis is there where an angle is.
    let turns = stated.point.is_some() && !rotates;
    let axis = if turns { axis(stated.axis.as_deref()) } else { Spin::zeros() };
    if let Some(path) = &stated.path {
        let read = Table::read(&case.folder.join(path), axis);
        return read.map_err(|error| error.at_key(case, &format!("{key}.path")));
    }
    let rows = stated.time.iter().flatten().enumerate().map(|(row, time)| TableRow {
        time: time.si(),
        displacement: stated.place.as_ref().map_or(Vector::zeros(), |places| places[row].to_array().into()),
        angle: stated.angle.as_ref().map_or(0.0, |angles| angles[row].si()),
    });
    Ok(Table::new(axis, rows.collect()))
}

/// The triangles of the file that is stated at a key.
///
/// # Errors
/// As [`read_triangles`].
pub fn triangles(
    case: &Case,
    key: &str,
    format: Format,
    file: &SurfaceFile,
) -> Result<Vec<Facet<3>>, InputError> {
    read_triangles(&case.folder.join(&file.path), format, file.scale, file.rims)
        .map_err(|error| error.at_key(case, &format!("{key}.path")))
}
