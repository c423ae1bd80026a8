//! The nodes in inlets.

use crate::backend::Step;
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::backend::pfem::wall::{Contacts, Inflow, Wall, inlet_of, inlet_velocity};
use crate::element::simplex::{Vector, dot, volume_and_areas};

/// Of an inlet, at a time.
#[derive(Clone, Copy, Debug, Default)]
struct Flux {
    /// Area of the faces that have all of their nodes in it (m²).
    area: f64,
    /// ∫u·n dA over those, u the stated velocity (m³/s).
    stated: f64,
    /// ∫u·n dA over all faces at walls with a node in it, u the velocity of the nodes in it, zero at others (m³/s).
    given: f64,
}

impl Flux {
    /// What comes in: the mean of the stated velocity through the stated area (m³/s).
    fn rate<const D: usize>(&self, inflow: &Inflow<D>) -> f64 {
        if self.area > 0.0 { self.stated * inflow.area / self.area } else { 0.0 }
    }
}

/// Gives the nodes in inlets their share of the stated velocity, such that ∫u·n dA over the boundary is the rate of the inlet.
pub fn prescribe<const D: usize, const N: usize>(walls: &mut [Wall<D>], cloud: &Cloud<D, N>, step: Step) {
    let inflows = |walls: &mut [Wall<D>], share: &dyn Fn(usize, &Inflow<D>) -> f64| {
        for (index, wall) in walls.iter_mut().enumerate() {
            if let Some(inflow) = &mut wall.inflow {
                inflow.share = share(index, inflow);
            }
        }
    };
    if walls.iter().all(|wall| wall.inflow.is_none()) {
        return;
    }
    inflows(walls, &|_, _| 1.0);
    let fluxes = fluxes(cloud, walls, step);
    inflows(walls, &|index, inflow| {
        let flux = &fluxes[index];
        if flux.given == 0.0 { 1.0 } else { flux.rate(inflow) / flux.given }
    });
}

/// Volume that comes in through all inlets (m³/s).
pub fn rate<const D: usize, const N: usize>(cloud: &Cloud<D, N>, walls: &[Wall<D>], step: Step) -> f64 {
    let fluxes = fluxes(cloud, walls, step);
    walls.iter().zip(&fluxes).filter_map(|(wall, flux)| Some(flux.rate(wall.inflow.as_ref()?))).sum()
}

/// Puts the nodes in inlets back to where they were.
pub fn put_back<const D: usize, const N: usize>(
    cloud: &mut Cloud<D, N>,
    walls: &[Wall<D>],
    before: &[Vector<D>],
) {
    for ((x, contacts), was) in cloud.place.iter_mut().zip(&cloud.contacts).zip(before) {
        if inlet_of(walls, *contacts).is_some() {
            *x = *was;
        }
    }
}

/// Nodes that run along a wall into an inlet in it are in the inlet from then on, with its velocity: what comes in takes them along.
pub fn take_in<const D: usize, const N: usize>(cloud: &mut Cloud<D, N>, walls: &[Wall<D>], time: f64) {
    for (index, wall) in walls.iter().enumerate() {
        let Some(inflow) = &wall.inflow else { continue };
        for (node, x) in cloud.place.iter().enumerate().filter(|(node, _)| cloud.drop[*node] == 0.0) {
            let contacts = &mut cloud.contacts[node];
            let runs_along_wall = !contacts.is_empty() && inlet_of(walls, *contacts).is_none();
            if runs_along_wall && inflow.holds(x) {
                contacts.insert(index);
                if let Some(given) = inlet_velocity(walls, *contacts, x, time) {
                    cloud.velocity[node] = given;
                }
            }
        }
    }
}

/// The fluxes in the middle of a step of all walls that are inlets. Nodes in inlets are put back when the others have moved: faces
/// are where v_n takes these.
fn fluxes<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    walls: &[Wall<D>],
    step: Step,
) -> [Flux; Contacts::MOST] {
    let mut fluxes = [Flux::default(); Contacts::MOST];
    let time = step.time + 0.5 * step.length;
    let end = |node: usize| match inlet_of(walls, cloud.contacts[node]) {
        Some(_) => cloud.place[node],
        None => std::array::from_fn(|k| cloud.place[node][k] + step.length * cloud.velocity[node][k]),
    };
    for (cell, around) in cloud.cells.iter().zip(&cloud.neighbours) {
        for opposite in (0..N).filter(|&i| around[i] == OUTSIDE) {
            let face = || (0..N).filter(|&i| i != opposite).map(|i| cell[i] as usize);
            let common = face().map(|node| cloud.contacts[node]).reduce(Contacts::common);
            let is_free = common.is_none_or(Contacts::is_empty);
            if is_free || face().all(|node| inlet_of(walls, cloud.contacts[node]).is_none()) {
                continue;
            }
            // V∇N of the node opposite to a face is a D-th of its area, inwards.
            let inwards = volume_and_areas(&cell.map(|node| end(node as usize))).1[opposite];
            for node in face() {
                let (x, contacts) = (&cloud.place[node], cloud.contacts[node]);
                let Some((index, inflow)) = inlet_of(walls, contacts) else { continue };
                let flux = &mut fluxes[index];
                flux.given +=
                    inlet_velocity(walls, contacts, x, time).map_or(0.0, |given| dot(&inwards, &given));
                if face().all(|other| cloud.contacts[other].contains(index)) {
                    flux.stated += dot(&inwards, &inflow.stated(x, time));
                    flux.area += dot(&inwards, &inflow.normal);
                }
            }
        }
    }
    fluxes
}
