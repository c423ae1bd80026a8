//! What walls take of the momentum of fluid that they do not hold, by their law of the wall.

use super::contact::moved;
use super::rheology::Law;
use super::setting::Fluid;
use crate::backend::Step;
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::backend::pfem::wall::{Contacts, Grip, Wall};
use crate::element::simplex::{Vector, difference, dot, volume_and_areas};

/// u⁺ = A y⁺^B above the sublayer, u⁺ = y⁺ in it.
const FACTOR: f64 = 8.3;
const POWER: f64 = 1.0 / 7.0;
/// A speed (m/s) like rest, whose square is a number.
const SLOWEST: f64 = 1e-150;

/// Stress (Pa) of a wall on a layer of fluid of a thickness y (m) whose mean velocity along the wall is u (m/s):
///
/// τ = 2μu/y for u ≤ ½(ν/y)A^{2/(1−B)}, else
/// τ = ρ[½(1−B)A^{(1+B)/(1−B)}(ν/y)^{1+B} + ((1+B)/A)(ν/y)^B u]^{2/(1+B)},
///
/// the mean over the layer of u⁺ = min(y⁺, 8.3 y⁺^{1/7}), solved for τ.
///
/// Source: Werner and Wengle, in *Turbulent Shear Flows* 8 (1993) 155.
pub fn wall_stress(density: f64, viscosity: f64, thickness: f64, speed: f64) -> f64 {
    let (a, b) = (FACTOR, POWER);
    let diffusion = viscosity / (density * thickness);
    if speed <= 0.5 * diffusion * a.powf(2.0 / (1.0 - b)) {
        return 2.0 * viscosity * speed / thickness;
    }
    let sublayer = 0.5 * (1.0 - b) * a.powf((1.0 + b) / (1.0 - b)) * diffusion.powf(1.0 + b);
    let outside = (1.0 + b) / a * diffusion.powf(b) * speed;
    density * (sublayer + outside).powf(2.0 / (1.0 + b))
}

impl Fluid {
    /// τ/(ρyu) (1/s) of a layer of thickness y (m) that moves at u (m/s) along a wall with a wall function.
    pub fn friction_rate(&self, thickness: f64, speed: f64) -> f64 {
        // At rest the limit: that of the sublayer.
        let speed = speed.max(SLOWEST);
        let viscosity = self.rheology.viscosity(speed / thickness);
        wall_stress(self.density, viscosity, thickness, speed) / (self.density * thickness * speed)
    }
}

/// The share of a node in the fluid along a wall.
#[derive(Clone, Copy, Debug)]
struct Layer<const D: usize> {
    node: usize,
    wall: usize,
    /// A (m²): its share of the faces on the wall.
    area: f64,
    /// The wall's unit normal and velocity (m/s) there.
    normal: Vector<D>,
    velocity: Vector<D>,
}

/// The friction of walls with a wall function: F_i = −Σ_w A_iw τ(|u|, V_i/A_iw) u/|u|, u = v_{n+1} − v_w along the wall, so
/// that a film that a step stops is not turned round; v_{n+1} = v_n + (v_m − v_n)/θ.
///
/// The lumped volume of a node over its area is the thickness of the layer that its velocity is the mean of: half the height
/// of the cells, in a film all of it. Faces, volumes and walls are those at t_n.
#[derive(Debug, Default)]
pub struct Friction<const D: usize> {
    layers: Vec<Layer<D>>,
    /// V_i (m³).
    volumes: Vec<f64>,
    /// r/θ (kg/s), F = −ru; empty where no wall has a wall function.
    resistance: Vec<f64>,
    /// −F (N).
    force: Vec<Vector<D>>,
    /// −Σ F·(v_m − v_w) (W).
    power: f64,
}

impl<const D: usize> Friction<D> {
    /// Finds the layers at the start of a step.
    pub fn begin<const N: usize>(&mut self, cloud: &Cloud<D, N>, walls: &[Wall<D>], step: Step) {
        let Self { layers, volumes, resistance, force, power } = self;
        let has_friction = walls.iter().any(|wall| wall.grip == Grip::WallFunction);
        let nodes = if has_friction { cloud.place.len() } else { 0 };
        layers.clear();
        *power = 0.0;
        for values in [&mut *volumes, resistance] {
            values.clear();
            values.resize(nodes, 0.0);
        }
        force.clear();
        force.resize(nodes, [0.0; D]);
        if !has_friction {
            return;
        }
        for (corners, neighbours) in cloud.cells.iter().zip(&cloud.neighbours) {
            let (volume, areas) = volume_and_areas(&cloud.vertices(corners));
            corners.iter().for_each(|&node| volumes[node as usize] += volume / N as f64);
            for opposite in (0..N).filter(|&corner| neighbours[corner] == OUTSIDE) {
                let face = (0..N).filter(|&corner| corner != opposite).map(|corner| corners[corner] as usize);
                let common = face.clone().map(|node| cloud.contacts[node]).reduce(Contacts::common);
                let touched = common.into_iter().flat_map(Contacts::iter);
                for wall in touched.filter(|&wall| walls[wall].grip == Grip::WallFunction) {
                    // |V∇N| of the opposite corner is the area of the face over D.
                    let area = dot(&areas[opposite], &areas[opposite]).sqrt();
                    let layer = |node| Layer { node, wall, area, normal: [0.0; D], velocity: [0.0; D] };
                    layers.extend(face.clone().map(layer));
                }
            }
        }
        layers.sort_by_key(|layer| (layer.node, layer.wall));
        layers.dedup_by(|more, kept| {
            let is_same = (more.node, more.wall) == (kept.node, kept.wall);
            kept.area += if is_same { more.area } else { 0.0 };
            is_same
        });
        layers.retain(|layer| volumes[layer.node] > 0.0);
        for layer in layers {
            let touch = walls[layer.wall].touch(&cloud.place[layer.node], step.time);
            (layer.normal, layer.velocity) = (touch.normal, touch.velocity);
        }
    }

    /// Takes v_m and v_n.
    pub fn evaluate(
        &mut self,
        fluid: &Fluid,
        implicitness: f64,
        velocity: &[Vector<D>],
        before: &[Vector<D>],
    ) {
        let Self { layers, volumes, resistance, force, power } = self;
        resistance.fill(0.0);
        force.fill([0.0; D]);
        *power = 0.0;
        for layer in layers.iter() {
            let volume = volumes[layer.node];
            let (middle, before) = (&velocity[layer.node], &before[layer.node]);
            let end = moved(before, 1.0 / implicitness, &difference(middle, before));
            let [middle, end] = [middle, &end].map(|v| {
                let relative = difference(v, &layer.velocity);
                moved(&relative, -dot(&relative, &layer.normal), &layer.normal)
            });
            let rate = fluid.friction_rate(volume / layer.area, dot(&end, &end).sqrt());
            let own = fluid.density * volume * rate;
            resistance[layer.node] += own / implicitness;
            force[layer.node] = moved(&force[layer.node], own, &end);
            *power += own * dot(&end, &middle);
        }
    }

    /// r/θ (kg/s) of a node: what resists a change of v_m, which walls keep along themselves.
    pub fn resistance(&self, node: usize) -> f64 {
        self.resistance.get(node).copied().unwrap_or(0.0)
    }

    /// F (N) on a node.
    pub fn force(&self, node: usize) -> Vector<D> {
        self.force.get(node).map_or([0.0; D], |force| force.map(|force| -force))
    }

    /// −Σ F·(v_m − v_w) (W): what becomes heat.
    pub fn power(&self) -> f64 {
        self.power
    }

    /// Adds −F to the rows of momentum (N).
    pub fn add(&self, rows: &mut [Vector<D>]) {
        for (row, force) in rows.iter_mut().zip(&self.force) {
            *row = moved(row, 1.0, force);
        }
    }

    /// Adds what a change of v_m adds to −F to the rows of momentum (N).
    pub fn add_change(&self, change: &[Vector<D>], rows: &mut [Vector<D>]) {
        for ((row, change), resistance) in rows.iter_mut().zip(change).zip(&self.resistance) {
            *row = moved(row, *resistance, change);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DENSITY: f64 = 1000.0;
    const VISCOSITY: f64 = 1e-3;

    /// Mean over a layer of u⁺ = min(y⁺, A y⁺^B) times the friction velocity √(τ/ρ).
    fn mean(stress: f64, thickness: f64) -> f64 {
        let friction_velocity = (stress / DENSITY).sqrt();
        let points = 2_000_000;
        let profile = |k: usize| {
            let y = (k as f64 + 0.5) / points as f64 * thickness * friction_velocity * DENSITY / VISCOSITY;
            y.min(FACTOR * y.powf(POWER))
        };
        friction_velocity * (0..points).map(profile).sum::<f64>() / points as f64
    }

    #[test]
    fn the_stress_is_that_whose_profile_has_the_mean_velocity() {
        for (thickness, speed) in [(1e-3, 0.01), (1e-3, 0.1), (1e-3, 3.0), (0.02, 0.5), (0.02, 5.0)] {
            let stress = wall_stress(DENSITY, VISCOSITY, thickness, speed);
            let found = mean(stress, thickness);
            assert!((found / speed - 1.0).abs() < 1e-5, "{thickness} m, {speed} m/s: {found}");
        }
    }

    #[test]
    fn the_two_branches_meet() {
        let (thickness, factor) = (1e-3, FACTOR.powf(2.0 / (1.0 - POWER)));
        let speed = 0.5 * VISCOSITY / (DENSITY * thickness) * factor;
        let [below, above] =
            [1.0 - 1e-9, 1.0 + 1e-9].map(|share| wall_stress(DENSITY, VISCOSITY, thickness, share * speed));
        assert!((above / below - 1.0).abs() < 1e-8, "{below} {above}");
    }

    #[test]
    #[allow(clippy::print_stdout, reason = "the friction is a figure of the documentation")]
    fn a_thick_layer_has_the_friction_of_a_smooth_plate() {
        // Blasius: τ = 0.0225 ρU²(ν/Uδ)^{1/4}, U = (8/7)u at the edge of the layer, which is u⁺ = 8.74 y⁺^{1/7}: the law of a
        // wall with 8.3 is 9.5 % above it where the sublayer is thin (10.5 % at 0.01 m, 1 m/s).
        for (thickness, speed) in [(0.02, 3.0), (0.05, 5.0), (0.1, 5.0)] {
            let edge = 8.0 / 7.0 * speed;
            let plate =
                0.0225 * DENSITY * edge * edge * (VISCOSITY / (DENSITY * edge * thickness)).powf(0.25);
            let stress = wall_stress(DENSITY, VISCOSITY, thickness, speed);
            println!("{thickness} m, {speed} m/s: friction over that of a plate {:.4}", stress / plate);
            assert!(
                (stress / plate - 1.0).abs() < 0.1,
                "{thickness} m, {speed} m/s: {stress} Pa, plate {plate} Pa"
            );
        }
    }
}
