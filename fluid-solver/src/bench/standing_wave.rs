//! The first mode of a tank with a free surface.

use std::f64::consts::{FRAC_PI_2, PI};

use case_io::document::Backend;

use super::scene::Scene;

/// η = a cos kx sin ωt, u = −(a g k/ω) (cosh ky sin kx, −sinh ky cos kx) cos ωt / cosh kH, ω² = g k tanh kH, in a tank of
/// width 1 m and depth H = 0.5 m; k = π/1 m, a = 10⁻⁴ m, so that what linear theory leaves out is 10⁻⁴ of the speed. Ends after 2¼
/// periods, at rest in theory: errors are relative to the speed at the start.
///
/// Source: Lamb, *Hydrodynamics* (1932), §228.
pub struct StandingWave;

const DEPTH: f64 = 0.5;
const GRAVITY: f64 = 9.81;
const AMPLITUDE: f64 = 1e-4;

/// ω (1/s).
fn frequency() -> f64 {
    (GRAVITY * PI * (PI * DEPTH).tanh()).sqrt()
}

/// a g k/(ω cosh kH) (m/s).
fn speed() -> f64 {
    AMPLITUDE * GRAVITY * PI / (frequency() * (PI * DEPTH).cosh())
}

impl Scene for StandingWave {
    fn suits(&self, backend: Backend) -> bool {
        !matches!(backend, Backend::Imposed | Backend::Eulerian)
    }

    fn end(&self) -> f64 {
        4.5 * FRAC_PI_2 * 2.0 / frequency()
    }

    fn windows(&self, cells: usize) -> usize {
        // A wave moves with the square root of the depth, whatever the speed of the fluid.
        4 * cells
    }

    fn case(&self, cells: usize) -> String {
        let (across, speed) = (2 * cells, speed());
        format!(
            "[case]\ndimension = 2\ntitle = \"standing wave\"\ngravity = [\"0 m/s^2\", \"-{GRAVITY} m/s^2\"]\n\
             [fluid]\ndensity = \"1000 kg/m^3\"\nviscosity = \"1e-6 Pa s\"\n\
             velocity = {{ expression = [\"{}*(exp(pi*y)+exp(-pi*y))*sin(pi*x)\", \"{}*(exp(pi*y)-exp(-pi*y))*cos(pi*x)\"] }}\n\
             [fluid.mesh.box]\nlower = [\"0 m\", \"0 m\"]\nupper = [\"1 m\", \"{DEPTH} m\"]\ncells = [{across}, {cells}]\njitter = 0.1\n\
             [[fluid.boundary]]\non = [\"x-min\", \"x-max\", \"y-min\"]\nkind = \"slip\"\n\
             [[fluid.boundary]]\non = [\"y-max\"]\nkind = \"free-surface\"\n",
            -0.5 * speed,
            0.5 * speed
        )
    }

    fn velocity(&self, [x, y]: [f64; 2], time: f64) -> [f64; 2] {
        let now = speed() * (frequency() * time).cos();
        [-now * (PI * y).cosh() * (PI * x).sin(), now * (PI * y).sinh() * (PI * x).cos()]
    }

    fn inside(&self) -> ([f64; 2], [f64; 2]) {
        ([0.0; 2], [1.0, DEPTH - 2.0 * AMPLITUDE])
    }
}
