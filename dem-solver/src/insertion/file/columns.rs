//! Where the values of a grain stand in a row.

use super::FileGrain;
use surface::Flaw;

/// Names of the columns of x, y, z, of the velocity, of the angular velocity, and of the size.
pub(super) type Names = [&'static str; 10];

/// Where each value of a grain stands in a row.
pub(super) struct Columns {
    names: &'static Names,
    at: [Option<usize>; 10],
    width: usize,
    radius_per_size: f64,
}

impl Columns {
    /// Of a header with these names; sizes times `radius_per_size` are radii.
    pub(super) fn of(
        line: usize,
        names: &[&str],
        wanted: &'static Names,
        radius_per_size: f64,
    ) -> Result<Self, Flaw> {
        let at = wanted.map(|wanted| names.iter().position(|name| *name == wanted));
        match at[..2].iter().position(Option::is_none) {
            Some(missing) => {
                Err(Flaw::at(line, format!("no column {:?}; found: {}", wanted[missing], names.join(", "))))
            }
            None => Ok(Self { names: wanted, at, width: names.len(), radius_per_size }),
        }
    }

    /// The grain in the cells of a row.
    pub(super) fn grain(&self, line: usize, cells: &[&str]) -> Result<FileGrain, Flaw> {
        if cells.len() != self.width {
            let what = format!("{} values where the header has {}", cells.len(), self.width);
            return Err(Flaw::at(line, what));
        }
        let value = |column: usize| match self.at[column] {
            None => Ok(None),
            Some(at) => match cells[at].parse::<f64>() {
                Ok(value) if value.is_finite() => Ok(Some(value)),
                _ => {
                    let what = format!("{}: {:?} is not a finite number", self.names[column], cells[at]);
                    Err(Flaw::at(line, what))
                }
            },
        };
        let vector = |first: usize| -> Result<[f64; 3], Flaw> {
            let component = |axis: usize| value(first + axis).map(Option::unwrap_or_default);
            Ok([component(0)?, component(1)?, component(2)?])
        };
        let optional = |first: usize| -> Result<Option<[f64; 3]>, Flaw> {
            let stated = self.at[first..first + 3].iter().any(Option::is_some);
            if stated { vector(first).map(Some) } else { Ok(None) }
        };
        let radius = value(9)?.map(|size| size * self.radius_per_size);
        if let Some(radius) = radius.filter(|radius| *radius <= 0.0) {
            let what = format!("{}: a radius of {radius} m; it must be positive", self.names[9]);
            return Err(Flaw::at(line, what));
        }
        let (velocity, angular_velocity) = (optional(3)?, optional(6)?);
        Ok(FileGrain { centre: vector(0)?, velocity, angular_velocity, radius })
    }
}
