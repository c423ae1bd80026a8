//! Closed boxes on a mesh that stays.

use super::outcome::Expected;
use super::scene::tank;
use super::trial::{Kind, Trial};

/// All of them: a vortex that water turns in, over windows from a tenth to five times what it takes to cross a cell, and on
/// cells that are far from even.
pub fn trials() -> Vec<Trial> {
    let vortex = |what: String, courant: f64, jitter: f64| {
        let keys = format!("jitter = {jitter:?}");
        let sides = ["x-min", "x-max", "y-min", "y-max"];
        let scene = format!(
            "velocity = {{ expression = [\"sin(pi*x)*cos(pi*y)\", \"-cos(pi*x)*sin(pi*y)\"] }}\n{}",
            tank([0.0; 2], [1.0; 2], 0.05, &keys, &sides, "")
        );
        // It turns for a second and has nothing to gain speed from.
        let expected = Expected::Run { volume_error: 0.0, speed: 1.1 };
        let (window, end) = (0.05 * courant, 1.0);
        Trial { kind: Kind::Fixed(2), topic: "fixed", what, window, end, expected, scene }
    };
    let mut all =
        [0.1, 0.5, 1.0, 2.0, 5.0].map(|courant| vortex(format!("courant {courant}"), courant, 0.1)).to_vec();
    all.push(vortex("nodes shifted by 0.3".to_string(), 1.0, 0.3));
    all
}
