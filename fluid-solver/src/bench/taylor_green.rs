//! A vortex between four slippery walls.

use std::f64::consts::PI;

use case_io::document::Backend;

use super::scene::Scene;

/// u = (sin x cos y, −cos x sin y) exp(−2νt) in \[0, π\]², ν = 0.05 m²/s: convection is a gradient, which the pressure takes.
///
/// Source: Taylor and Green, *Proc. R. Soc. Lond. A* 158 (1937) 499.
pub struct TaylorGreen;

const VISCOSITY: f64 = 0.05;

impl Scene for TaylorGreen {
    fn suits(&self, backend: Backend) -> bool {
        backend != Backend::Imposed
    }

    fn end(&self) -> f64 {
        1.0
    }

    fn windows(&self, cells: usize) -> usize {
        (cells as f64 / PI).ceil() as usize
    }

    fn case(&self, cells: usize) -> String {
        format!(
            "[case]\ndimension = 2\ntitle = \"vortex between slippery walls\"\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n\
             [fluid]\ndensity = \"1 kg/m^3\"\nviscosity = \"{VISCOSITY} Pa s\"\n\
             velocity = {{ expression = [\"sin(x)*cos(y)\", \"-cos(x)*sin(y)\"] }}\n\
             [fluid.mesh.box]\nlower = [\"0 m\", \"0 m\"]\nupper = [\"{PI} m\", \"{PI} m\"]\ncells = [{cells}, {cells}]\njitter = 0.1\n\
             [[fluid.boundary]]\non = [\"x-min\", \"x-max\", \"y-min\", \"y-max\"]\nkind = \"slip\"\n"
        )
    }

    fn velocity(&self, [x, y]: [f64; 2], time: f64) -> [f64; 2] {
        let left = (-2.0 * VISCOSITY * time).exp();
        [left * x.sin() * y.cos(), -left * x.cos() * y.sin()]
    }

    fn inside(&self) -> ([f64; 2], [f64; 2]) {
        ([0.0; 2], [PI; 2])
    }
}
