//! Curves over time as SVG.

mod chart;
mod curve;
mod group;
mod scale;
mod ticked_range;

pub(crate) use chart::svg;
pub(crate) use curve::Curve;
pub(crate) use group::{Plot, plots_of};
pub(crate) use scale::Scale;

/// Colour-blind safe colours of the curves, Okabe and Ito (2008), darkest first.
pub(crate) const PALETTE: [(u8, u8, u8); 8] = [
    (0, 114, 178),
    (213, 94, 0),
    (0, 158, 115),
    (204, 121, 167),
    (230, 159, 0),
    (86, 180, 233),
    (0, 0, 0),
    (160, 140, 20),
];
