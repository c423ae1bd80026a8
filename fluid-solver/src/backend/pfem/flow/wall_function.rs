//! What walls take of the momentum of fluid that they do not hold, by their law of the wall.

use super::contact::moved;
use super::setting::Fluid;
use crate::backend::Step;
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::backend::pfem::wall::{Grip, Wall};
use crate::element::simplex::{Vector, dot, volume_and_areas};

/// u⁺ = A y⁺^B above the sublayer, u⁺ = y⁺ in it.
const FACTOR: f64 = 8.3;
const POWER: f64 = 1.0 / 7.0;

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

/// The friction of walls that have a law: F_i = −Σ_w A_iw τ(|u|, V_i/A_iw) u/|u|, u = v_m − v_w along the wall.
///
/// The lumped volume of a node over its area is the thickness of the layer that its velocity is the mean of: about half the
/// height of the cells, in a film all of it. The faces are those at t_n.
#[derive(Debug, Default)]
pub struct Friction<const D: usize> {
    layers: Vec<Layer<D>>,
    /// V_i (m³).
    volumes: Vec<f64>,
    /// r (kg/s), F = −r(v_m − v_w).
    pub resistance: Vec<f64>,
    /// −F (N).
    pub force: Vec<Vector<D>>,
    /// Σ −F·(v_m − v_w) (W): what becomes heat.
    pub power: f64,
}

impl<const D: usize> Friction<D> {
    /// Finds the layers at the start of a step.
    pub fn begin<const N: usize>(&mut self, cloud: &Cloud<D, N>, walls: &[Wall<D>], step: Step) {
        let nodes = cloud.place.len();
        self.layers.clear();
        self.resistance.clear();
        self.resistance.resize(nodes, 0.0);
        self.force.clear();
        self.force.resize(nodes, [0.0; D]);
        self.power = 0.0;
        if walls.iter().all(|wall| wall.grip != Grip::WallFunction) {
            return;
        }
        self.volumes.clear();
        self.volumes.resize(nodes, 0.0);
        for (corners, neighbours) in cloud.cells.iter().zip(&cloud.neighbours) {
            let (volume, areas) = volume_and_areas(&cloud.vertices(corners));
            corners.iter().for_each(|&node| self.volumes[node as usize] += volume / N as f64);
            for opposite in (0..N).filter(|&corner| neighbours[corner] == OUTSIDE) {
                let face = (0..N).filter(|&corner| corner != opposite).map(|corner| corners[corner] as usize);
                let common = face.clone().map(|node| cloud.contacts[node]).reduce(|a, b| a.common(b));
                let rubbing = common.into_iter().flat_map(|common| common.iter());
                for wall in rubbing.filter(|&wall| walls[wall].grip == Grip::WallFunction) {
                    // |V∇N| of the opposite corner is the face over D.
                    let area = dot(&areas[opposite], &areas[opposite]).sqrt();
                    let layer = |node| Layer { node, wall, area, normal: [0.0; D], velocity: [0.0; D] };
                    self.layers.extend(face.clone().map(layer));
                }
            }
        }
        self.layers.sort_by_key(|layer| (layer.node, layer.wall));
        self.layers.dedup_by(|more, kept| {
            let is_same = (more.node, more.wall) == (kept.node, kept.wall);
            kept.area += if is_same { more.area } else { 0.0 };
            is_same
        });
        for layer in &mut self.layers {
            let touch = walls[layer.wall].touch(&cloud.place[layer.node], step.time);
            (layer.normal, layer.velocity) = (touch.normal, touch.velocity);
        }
    }

    /// Takes v_m. A step of Δt with θ leaves a layer with nothing else acting on it what backward Euler does,
    /// v_{n+1} = v_n/(1 + rΔt/m): F = −r v_m/(1 + (1−θ)rΔt/m).
    pub fn evaluate(&mut self, fluid: &Fluid, step: Step, implicitness: f64, velocity: &[Vector<D>]) {
        let Self { layers, volumes, resistance, force, power } = self;
        for &Layer { node, .. } in layers.iter() {
            resistance[node] = 0.0;
            force[node] = [0.0; D];
        }
        *power = 0.0;
        for layer in layers.iter() {
            let Layer { node, area, .. } = *layer;
            let relative = moved(&velocity[node], -1.0, &layer.velocity);
            let along = moved(&relative, -dot(&relative, &layer.normal), &layer.normal);
            let speed = dot(&along, &along).sqrt();
            let thickness = volumes[node] / area;
            if thickness <= 0.0 {
                continue;
            }
            let rate = fluid.friction_rate(thickness, speed);
            let share = rate / (1.0 + (1.0 - implicitness) * rate * step.length);
            let own = fluid.density * volumes[node] * share;
            resistance[node] += own;
            force[node] = moved(&force[node], own, &along);
            *power += own * speed * speed;
        }
    }
}

impl Fluid {
    /// τ/(ρyu) (1/s) of a layer of thickness y (m) that moves at u (m/s) along a wall.
    pub fn friction_rate(&self, thickness: f64, speed: f64) -> f64 {
        use super::rheology::Law;
        // At rest the sublayer's law is the limit.
        let speed = speed.max(f64::MIN_POSITIVE.sqrt());
        let viscosity = self.rheology.viscosity(speed / thickness);
        wall_stress(self.density, viscosity, thickness, speed) / (self.density * thickness * speed)
    }
}
