//! A plane at which fluid leaves.

use crate::backend::pfem::cloud::{Cloud, retain};
use crate::backend::pfem::wall::Plane;
use crate::element::simplex::{Vector, volume_and_areas};

/// A point is in a box to this share of the box.
const ROUND_OFF: f64 = 1e-9;

/// The fluid leaves where it comes behind a plane; its end there is free: p = 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Outlet<const D: usize> {
    /// Its name in messages.
    pub name: String,
    /// The plane, its normal towards the fluid that stays.
    pub plane: Plane<D>,
    /// Corners of the box in which it is an outlet; none: everywhere.
    pub within: Option<[Vector<D>; 2]>,
}

/// A node that is behind the plane, and what the fluid is where it came there.
#[derive(Clone, Copy, Debug)]
struct Stop<const D: usize> {
    node: usize,
    place: Vector<D>,
    velocity: Vector<D>,
    pressure: f64,
    /// The least of the barycentric coordinates that these were interpolated with; the best cell has the largest.
    least: f64,
}

impl<const D: usize> Outlet<D> {
    /// Stops the nodes that went behind the plane where they came to it, with the velocity and the pressure of the moved
    /// fluid there, and takes out the drops that did. `before` are the places at the start of the step.
    pub fn stop<const N: usize>(&self, cloud: &mut Cloud<D, N>, before: &mut Vec<Vector<D>>) {
        let mut stops: Vec<Stop<D>> = Vec::new();
        let mut gone = Vec::new();
        for (node, (x, was)) in cloud.place.iter().zip(before.iter()).enumerate() {
            let Some(place) = self.crossing(was, x) else { continue };
            if cloud.drop[node] > 0.0 {
                gone.push(node);
                continue;
            }
            let (velocity, pressure) = (cloud.velocity[node], cloud.pressure[node]);
            stops.push(Stop { node, place, velocity, pressure, least: f64::NEG_INFINITY });
        }
        interpolate(cloud, &mut stops);
        for stop in &stops {
            cloud.place[stop.node] = stop.place;
            cloud.velocity[stop.node] = stop.velocity;
            cloud.pressure[stop.node] = stop.pressure;
        }
        if !gone.is_empty() {
            let removed: Vec<bool> = (0..before.len()).map(|node| gone.contains(&node)).collect();
            cloud.remove(&removed, &mut Vec::new());
            retain(&removed, before);
        }
    }

    /// Where a node that is behind the plane came to it; none for others.
    fn crossing(&self, was: &Vector<D>, x: &Vector<D>) -> Option<Vector<D>> {
        let [before, after] = [was, x].map(|x| self.plane.touch(x).gap);
        if after >= 0.0 {
            return None;
        }
        let share = (before / (before - after)).clamp(0.0, 1.0);
        let there: Vector<D> = std::array::from_fn(|k| was[k] + share * (x[k] - was[k]));
        let gap = self.plane.touch(&there).gap;
        let there: Vector<D> = std::array::from_fn(|k| there[k] - gap * self.plane.normal[k]);
        self.holds(&there).then_some(there)
    }

    /// Whether a point is in the part of space where this is an outlet.
    pub fn holds(&self, x: &Vector<D>) -> bool {
        self.within.as_ref().is_none_or(|[lower, upper]| {
            (0..D).all(|k| {
                let room = ROUND_OFF * (upper[k] - lower[k]);
                x[k] >= lower[k] - room && x[k] <= upper[k] + room
            })
        })
    }
}

/// Interpolates velocity and pressure at the places of the stops, each in a cell around its node, as the nodes moved.
fn interpolate<const D: usize, const N: usize>(cloud: &Cloud<D, N>, stops: &mut [Stop<D>]) {
    if stops.is_empty() {
        return;
    }
    for cell in &cloud.cells {
        for node in cell.map(|node| node as usize) {
            let Ok(index) = stops.binary_search_by_key(&node, |stop| stop.node) else { continue };
            let (stop, vertices) = (&mut stops[index], cloud.vertices(cell));
            let (volume, areas) = volume_and_areas(&vertices);
            let weights: [f64; N] = std::array::from_fn(|i| {
                let along: f64 = (0..D).map(|k| areas[i][k] * (stop.place[k] - vertices[i][k])).sum();
                1.0 + along / volume
            });
            let least = weights.iter().copied().fold(f64::INFINITY, f64::min);
            if least.is_finite() && least > stop.least {
                // Beside the mesh the nearest place in the cell stands for it.
                let inside = weights.map(|weight| weight.max(0.0));
                let sum: f64 = inside.iter().sum();
                let mean = |value: &dyn Fn(usize) -> f64| {
                    let terms = inside.iter().zip(cell);
                    terms.map(|(weight, &node)| weight * value(node as usize)).sum::<f64>() / sum
                };
                stop.velocity = std::array::from_fn(|k| mean(&|node| cloud.velocity[node][k]));
                stop.pressure = mean(&|node| cloud.pressure[node]);
                stop.least = least;
            }
        }
    }
}
