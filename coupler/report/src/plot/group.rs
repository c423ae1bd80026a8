//! Which columns of a series share a plot.

use case_io::output::series::{Column, Series, Title};

use super::{Curve, PALETTE, Scale};

/// Curves of one unit over time, or over something else.
#[derive(Debug)]
pub(crate) struct Plot {
    pub(crate) title: String,
    pub(crate) across: Title,
    pub(crate) across_scale: Scale,
    pub(crate) unit: String,
    pub(crate) scale: Scale,
    pub(crate) curves: Vec<Curve>,
}

/// Values that differ by more than this factor do not share an axis: the smaller would be a flat line.
const LARGEST_RATIO: f64 = 100.0;

/// The plots of a series: columns of one unit and of like size share one, in the order of the columns, and so do the parts
/// of a sum (`volume-by-flow`, `volume-by-overlap`), whatever their sizes.
pub(crate) fn plots_of(title: &str, series: &Series, choose_scale: fn(&[&Column]) -> Scale) -> Vec<Plot> {
    let Some((time, columns)) = series.columns().split_first() else { return Vec::new() };
    let mut groups: Vec<Vec<&Column>> = Vec::new();
    for column in columns {
        let fits = |group: &&mut Vec<&Column>| {
            let like = |other: &&Column| {
                let (one, two) = (largest(column), largest(other));
                let of_one_size = one == 0.0 || two == 0.0 || one.max(two) <= LARGEST_RATIO * one.min(two);
                match (sum_of(column), sum_of(other)) {
                    (None, None) => of_one_size,
                    (sum, other) => sum == other,
                }
            };
            group.len() < PALETTE.len() && group[0].title.unit == column.title.unit && group.iter().all(like)
        };
        match groups.iter_mut().find(fits) {
            Some(group) => group.push(column),
            None => groups.push(vec![column]),
        }
    }
    groups
        .into_iter()
        .map(|group| {
            let scale = choose_scale(&group);
            let curve = |column: &&Column| {
                let places: Vec<f64> = column.values.iter().map(|&value| scale.place(value)).collect();
                Curve::new(&column.title.name, &time.values, &places)
            };
            Plot {
                title: title.to_owned(),
                across: time.title.clone(),
                across_scale: Scale::Linear,
                unit: group[0].title.unit.clone(),
                scale,
                curves: group.iter().map(curve).collect(),
            }
        })
        .collect()
}

/// The sum that a column is a part of.
fn sum_of(column: &Column) -> Option<&str> {
    Some(column.title.name.split_once("-by-")?.0)
}

fn largest(column: &Column) -> f64 {
    column
        .values
        .iter()
        .filter(|value| value.is_finite())
        .fold(0.0, |largest, value| value.abs().max(largest))
}
