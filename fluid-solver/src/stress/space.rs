//! Tanks of water in space.

use super::outcome::Expected;
use super::scene::{boundary, drop, plane, refined, tank};
use super::trial::{AT_REST, Effort, GRAVITY, Kind, MOVING, Trial};

/// All of them.
pub fn trials(effort: Effort) -> Vec<Trial> {
    [
        courant(effort),
        clouds(),
        graded(effort),
        impacts(effort),
        flights(effort),
        bubbles(effort),
        emptied(effort),
        refusals(),
    ]
    .concat()
}

fn trial(
    topic: &'static str,
    what: impl Into<String>,
    (window, end): (f64, f64),
    expected: Expected,
    scene: String,
) -> Trial {
    Trial { kind: Kind::Moving(3), topic, what: what.into() + " in space", window, end, expected, scene }
}

/// A tank with the water against its sides.
const SIDES: [&str; 5] = ["x-min", "x-max", "y-min", "y-max", "z-min"];

/// A wave over windows from a tenth to five times what it takes to cross a cell.
fn courant(effort: Effort) -> Vec<Trial> {
    let (width, size): (f64, f64) = (1.0, 0.1);
    let period = 2.0 * (std::f64::consts::PI * width / (GRAVITY * std::f64::consts::FRAC_PI_2.tanh())).sqrt();
    let crossing = size / (GRAVITY * 0.5_f64).sqrt();
    let wave = |courant: f64| {
        let keys = "surface = \"0.5 + 0.02*cos(pi*x)\"";
        let scene = tank([0.0; 3], [width, 0.3, 0.5], size, keys, &SIDES, "");
        let expected = Expected::Run { volume_error: 1e-3, speed: 0.2 };
        trial("wave", format!("courant {courant}"), (courant * crossing, period), expected, scene)
    };
    let courants: &[f64] = if effort == Effort::Quick { &[0.5, 5.0] } else { &[0.1, 0.5, 1.0, 2.0, 5.0] };
    courants.iter().map(|courant| wave(*courant)).collect()
}

/// Water at rest on few nodes, and on nodes that are far from even.
fn clouds() -> Vec<Trial> {
    let rest = |what: &str, upper: [f64; 3], size: f64, jitter: f64| {
        let scene = tank([0.0; 3], upper, size, &format!("jitter = {jitter:?}"), &SIDES, "");
        let expected = Expected::Run { volume_error: 1e-9, speed: AT_REST };
        trial("rest", what, (0.01, 0.5), expected, scene)
    };
    vec![
        rest("one cell across", [0.1; 3], 0.1, 0.0),
        rest("nodes shifted by 0.3", [0.5, 0.4, 0.3], 0.1, 0.3),
        rest("a puddle of one cell", [0.4, 0.4, 0.05], 0.05, 0.0),
        rest("a column of one cell", [0.05, 0.05, 0.5], 0.05, 0.0),
    ]
}

/// Cells that are many times finer in some places than in others, all at once and where the water runs.
fn graded(effort: Effort) -> Vec<Trial> {
    let ball = "sphere = { centre = [\"0.2 m\", \"0.2 m\", \"0.1 m\"], radius = \"0.04 m\" }";
    let still = tank([0.0; 3], [0.4, 0.4, 0.3], 0.1, "", &SIDES, &refined(ball, 0.0125));
    let at_rest = Expected::Run { volume_error: 1e-9, speed: AT_REST };
    let pool = tank([0.0; 3], [0.3, 0.3, 0.1], 0.05, "", &SIDES, &refined("near = \"surface\"", 0.0167));
    let pool = pool + &drop([0.15, 0.15, 0.19], 0.06, 1.0);
    let struck = Expected::Run { volume_error: 1e-2, speed: MOVING };
    let end = if effort == Effort::Quick { 0.1 } else { 0.4 };
    vec![
        trial("graded", "at rest, 8 times finer in a ball", (0.01, 0.2), at_rest, still),
        trial("graded", "a drop, 3 times finer near surface", (2e-3, end), struck, pool),
    ]
}

/// Water that meets water, or a wall.
fn impacts(effort: Effort) -> Vec<Trial> {
    let quick = effort == Effort::Quick;
    let expected = Expected::Run { volume_error: 1e-2, speed: MOVING };
    let pool = tank([0.0; 3], [0.3, 0.3, 0.1], 0.025, "", &SIDES, "");
    let struck = |speed: f64, end: f64| {
        let scene = pool.clone() + &drop([0.15, 0.15, 0.19], 0.06, speed);
        trial("impact", format!("drop at {speed} m/s"), (2e-3 / speed, end), expected, scene)
    };
    let slow = struck(1.0, if quick { 0.15 } else { 0.5 });
    let fast = struck(10.0, if quick { 0.03 } else { 0.1 });
    let far = plane("far-wall", [0.4, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    let held = ["x-min", "y-min", "y-max", "z-min"];
    let dam = tank([0.0; 3], [0.1, 0.05, 0.2], 0.0125, "", &held, &far);
    let end = if quick { 0.4 } else { 1.5 };
    let dam = trial("impact", "dam break against a wall", (1e-3, end), expected, dam);
    vec![slow, fast, dam]
}

/// Fluid without sides.
fn flights(effort: Effort) -> Vec<Trial> {
    let end = if effort == Effort::Quick { 0.15 } else { 0.4 };
    let turning = "velocity = { expression = [\"-10*y\", \"10*x\", \"0\"] }\n";
    let blob = tank([-0.1; 3], [0.1; 3], 0.04, "", &[], "");
    let floor = plane("floor", [0.0; 3], [0.0, 0.0, 1.0]);
    let jet = tank([0.0, 0.0, 0.15], [0.06, 0.06, 0.45], 0.02, "", &[], &floor);
    vec![
        trial(
            "flight",
            "a cube that turns and falls",
            (2e-3, end),
            Expected::Run { volume_error: 1e-2, speed: MOVING },
            format!("{turning}{blob}"),
        ),
        trial(
            "flight",
            "a thin jet onto a floor",
            (1e-3, 2.0 * end),
            Expected::Run { volume_error: 2e-2, speed: MOVING },
            jet,
        ),
    ]
}

/// Air that cannot leave: a fluid without air closes on it.
fn bubbles(effort: Effort) -> Vec<Trial> {
    let end = if effort == Effort::Quick { 0.3 } else { 0.8 };
    let expected = Expected::Run { volume_error: 2e-2, speed: MOVING };
    let far = plane("far-wall", [0.3, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    let lid = plane("lid", [0.0, 0.0, 0.16], [0.0, 0.0, -1.0]);
    let held = ["x-min", "y-min", "y-max", "z-min"];
    let dam = tank([0.0; 3], [0.1, 0.05, 0.15], 0.0125, "", &held, &(far + &lid));
    vec![trial("edge", "air shut in under a lid", (1e-3, end), expected, dam)]
}

/// A tank with an open side under gravity and a pull.
fn emptied(effort: Effort) -> Vec<Trial> {
    let end = if effort == Effort::Quick { 0.5 } else { 2.0 };
    let expected = Expected::Open { volume_error: 1e-2, speed: MOVING };
    let floor = plane("floor", [0.0; 3], [0.0, 0.0, 1.0]);
    let scene = tank([0.0; 3], [0.3, 0.1, 0.1], 0.025, "", &["x-min", "y-min", "y-max"], &floor).replace(
        &boundary(&["x-max", "z-min", "z-max"], "free-surface"),
        &(boundary(&["z-min", "z-max"], "free-surface") + &boundary(&["x-max"], "outlet")),
    );
    let scene = format!("body-force = [\"3 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n{scene}");
    vec![trial("empty", "a tank to the last node", (5e-3, end), expected, scene)]
}

/// What cannot be computed says why.
fn refusals() -> Vec<Trial> {
    let refused = |what: &str, upper: [f64; 3]| {
        let scene = tank([0.0; 3], upper, 0.1, "", &SIDES, "");
        trial("refusal", what, (1e-3, 0.1), Expected::Refusal("fluid.mesh.box"), scene)
    };
    vec![refused("all nodes in a plane", [1.0, 1.0, 0.0]), refused("all nodes on a line", [1.0, 0.0, 0.0])]
}
