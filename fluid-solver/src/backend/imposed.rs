//! `imposed`: a flow stated by expressions of x, y, z, t. It pushes grains and is not pushed: whatever holds
//! the field as it is takes the grains' reactions.

use super::{Attempt, FluidBackend, PointValue, Solution, Step};
use crate::error::FluidError;
use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use case_io::document::{Document, Field};
use interface::frames::{GrainRow, ReactionRow, SampleRow};
use interface::ledger::FluidLedger;
use interface::message::Surface;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};

/// The field, where the grains are, and the field there.
pub struct Imposed {
    field: Field,
    density: f64,
    viscosity: f64,
    dimension: usize,
    depth: f64,
    time: f64,
    saved_time: f64,
    grains: Vec<GrainRow>,
    samples: Vec<SampleRow>,
    saved_grains: Vec<GrainRow>,
    saved_samples: Vec<SampleRow>,
}

impl Imposed {
    /// The field of a case; none if the case states none.
    pub fn of(document: &Document) -> Option<Imposed> {
        let fluid = document.fluid.as_ref()?;
        Some(Imposed {
            field: fluid.field.clone()?,
            density: fluid.density.si(),
            viscosity: fluid.viscosity.si(),
            dimension: document.case.dimension.count(),
            depth: document.case.depth(),
            time: 0.0,
            saved_time: 0.0,
            grains: Vec::new(),
            samples: Vec::new(),
            saved_grains: Vec::new(),
            saved_samples: Vec::new(),
        })
    }

    fn velocity(&self, point: [f64; 3], time: f64) -> [f64; 3] {
        let component = |axis: usize| self.field.velocity.get(axis).map_or(0.0, |e| e.evaluate(point, time));
        std::array::from_fn(component)
    }

    fn pressure(&self, point: [f64; 3], time: f64) -> f64 {
        self.field.pressure.evaluate(point, time)
    }

    fn volume(&self, radius: f64) -> f64 {
        match self.dimension {
            2 => PI * radius.powi(2) * self.depth,
            _ => 4.0 / 3.0 * PI * radius.powi(3),
        }
    }

    /// Velocity near a grain, which must be finite.
    fn velocity_near(&self, grain: u64, point: [f64; 3], time: f64) -> Result<[f64; 3], FluidError> {
        let velocity = self.velocity(point, time);
        match velocity.iter().position(|component| !component.is_finite()) {
            None => Ok(velocity),
            Some(axis) => Err(FluidError::FieldNotFinite {
                key: format!("fluid.field.velocity[{axis}]"),
                expression: self.field.velocity[axis].text().to_string(),
                grain,
                position: point,
                time,
                value: velocity[axis],
            }),
        }
    }

    /// Pressure near a grain, which must be finite.
    fn pressure_near(&self, grain: u64, point: [f64; 3], time: f64) -> Result<f64, FluidError> {
        let pressure = self.pressure(point, time);
        if pressure.is_finite() {
            return Ok(pressure);
        }
        Err(FluidError::FieldNotFinite {
            key: "fluid.field.pressure".to_string(),
            expression: self.field.pressure.text().to_string(),
            grain,
            position: point,
            time,
            value: pressure,
        })
    }

    /// Central differences over a length `h` that the rounding of a smooth field allows.
    fn sample_at(&self, grain: &GrainRow) -> Result<SampleRow, FluidError> {
        let (x, t) = (grain.position, self.time);
        let h = 1e-4 * grain.radius.max(1e-3);
        let shifted = |axis: usize, by: f64| {
            let mut point = x;
            point[axis] += by;
            point
        };
        let velocity = |point: [f64; 3], time: f64| self.velocity_near(grain.id, point, time);
        let pressure = |point: [f64; 3]| self.pressure_near(grain.id, point, t);
        let u = velocity(x, t)?;
        let mut gradient = [[0.0; 3]; 3];
        let mut laplacian = [0.0; 3];
        let mut pressure_gradient = [0.0; 3];
        for axis in 0..self.dimension {
            let (ahead, behind) = (shifted(axis, h), shifted(axis, -h));
            let (u_ahead, u_behind) = (velocity(ahead, t)?, velocity(behind, t)?);
            for i in 0..3 {
                gradient[i][axis] = (u_ahead[i] - u_behind[i]) / (2.0 * h);
            }
            // Second differences want a wider stencil: their rounding grows as 1/h².
            let wide = 100.0 * h;
            let (far, near) = (velocity(shifted(axis, wide), t)?, velocity(shifted(axis, -wide), t)?);
            for i in 0..3 {
                laplacian[i] += (far[i] - 2.0 * u[i] + near[i]) / (wide * wide);
            }
            pressure_gradient[axis] = (pressure(ahead)? - pressure(behind)?) / (2.0 * h);
        }
        let dt = 1e-6;
        let (later, earlier) = (velocity(x, t + dt)?, velocity(x, t - dt)?);
        let acceleration = std::array::from_fn(|i| {
            (later[i] - earlier[i]) / (2.0 * dt) + (0..3).map(|j| u[j] * gradient[i][j]).sum::<f64>()
        });
        Ok(SampleRow {
            velocity: u,
            pressure_gradient,
            viscous_stress_divergence: laplacian.map(|value| self.viscosity * value),
            acceleration,
            vorticity: [
                gradient[2][1] - gradient[1][2],
                gradient[0][2] - gradient[2][0],
                gradient[1][0] - gradient[0][1],
            ],
            void_fraction: 1.0,
            wetted_fraction: 1.0,
            kernel_width: 2.0 * grain.radius,
            own_share: 0.0,
            density: self.density,
            viscosity: self.viscosity,
            relayed_force: [0.0; 3],
        })
    }
}

impl FluidBackend for Imposed {
    fn nodes(&self) -> u64 {
        0
    }

    fn notes(&self) -> Vec<String> {
        vec!["the flow is stated by expressions: no mesh, no limit of the window".to_string()]
    }

    fn surface(&self) -> Option<Surface> {
        None
    }

    fn largest_step(&self) -> f64 {
        f64::INFINITY
    }

    fn populate(&mut self, time: f64, grains: &[GrainRow]) -> Result<(), FluidError> {
        self.time = time;
        self.grains.clear();
        self.grains.extend_from_slice(grains);
        self.samples = grains.iter().map(|grain| self.sample_at(grain)).collect::<Result<_, _>>()?;
        Ok(())
    }

    fn save(&mut self) {
        self.saved_time = self.time;
        self.saved_grains.clone_from(&self.grains);
        self.saved_samples.clone_from(&self.samples);
    }

    fn restore(&mut self) {
        self.time = self.saved_time;
        self.grains.clone_from(&self.saved_grains);
        self.samples.clone_from(&self.saved_samples);
    }

    fn project(&mut self, step: Step, grains: &[GrainRow]) -> Result<(), FluidError> {
        self.populate(step.end(), grains)
    }

    fn solve(&mut self, step: Step, reactions: &[ReactionRow]) -> Result<Attempt, FluidError> {
        let mut ledger = FluidLedger::default();
        for ((grain, sample), reaction) in self.grains.iter().zip(&self.samples).zip(reactions) {
            let volume = self.volume(grain.radius);
            for i in 0..3 {
                let drag = reaction.exchange_coefficient * (sample.velocity[i] - reaction.target_velocity[i]);
                let stress = volume * (sample.viscous_stress_divergence[i] - sample.pressure_gradient[i]);
                let [drag, stress, explicit] =
                    [drag, stress, reaction.force[i]].map(|force| force * step.length);
                ledger.drag[i] += drag;
                ledger.stress[i] += stress;
                ledger.explicit[i] += explicit;
                // The field stays as stated: its holder takes what the grains give.
                ledger.boundary[i] += drag + stress - explicit;
                ledger.scale += drag.abs() + stress.abs() + explicit.abs();
            }
        }
        Ok(Attempt::Solved(Box::new(Solution { ledger, ..Solution::default() })))
    }

    fn prepare_samples(&mut self) {}

    fn sample(&self, row: usize) -> SampleRow {
        self.samples[row]
    }

    fn commit(&mut self, step: Step) -> Result<(), FluidError> {
        self.time = step.end();
        Ok(())
    }

    fn at(&self, time: f64, point: [f64; 3]) -> Option<PointValue> {
        let velocity = self.velocity(point, time);
        Some(PointValue { velocity, pressure: self.pressure(point, time), void_fraction: 1.0 })
    }

    fn statistics(&self, _time: f64) -> Vec<(&'static str, f64)> {
        Vec::new()
    }

    fn write_frame(&self, _stem: &Path, _compress: bool) -> Result<Option<PathBuf>, FluidError> {
        Ok(None)
    }

    fn save_checkpoint<'a>(&'a self, writer: CheckpointWriter<'a>) -> CheckpointWriter<'a> {
        writer
    }

    fn load_checkpoint(&mut self, _checkpoint: &Checkpoint) -> Result<(), FluidError> {
        Ok(())
    }
}
