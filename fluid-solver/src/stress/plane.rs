//! Tanks of water in the plane, poured, shaken, struck.

use super::outcome::Expected;
use super::scene::{boundary, drop, plane, polyline, refined, tank, wall};
use super::trial::{AT_REST, Effort, GRAVITY, Kind, MOVING, Trial};

/// All of them.
pub fn trials(effort: Effort) -> Vec<Trial> {
    [
        courant(),
        clouds(),
        graded(effort),
        impacts(effort),
        flights(),
        long(effort),
        edges(effort),
        emptied(),
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
    Trial { kind: Kind::Moving(2), topic, what: what.into(), window, end, expected, scene }
}

/// A tank with the water against its sides.
const SIDES: [&str; 3] = ["x-min", "x-max", "y-min"];

/// A wave over windows from a tenth to five times what it takes to cross a cell.
fn courant() -> Vec<Trial> {
    let (width, size): (f64, f64) = (1.0, 0.05);
    let period =
        2.0 * (std::f64::consts::PI * width / (GRAVITY * (std::f64::consts::FRAC_PI_2).tanh())).sqrt();
    let crossing = size / (GRAVITY * 0.5_f64).sqrt();
    let wave = |courant: f64| {
        let keys = "surface = \"0.5 + 0.01*cos(pi*x)\"";
        let scene = tank([0.0, 0.0], [width, 0.5], size, keys, &SIDES, "");
        let expected = Expected::Run { volume_error: 1e-4, speed: 0.1 };
        trial("wave", format!("courant {courant}"), (courant * crossing, 2.0 * period), expected, scene)
    };
    [0.1, 0.5, 1.0, 2.0, 5.0].map(wave).to_vec()
}

/// Water at rest on few nodes, and on nodes that are far from even.
fn clouds() -> Vec<Trial> {
    let rest = |what: &str, upper: [f64; 2], size: f64, jitter: f64| {
        let scene = tank([0.0, 0.0], upper, size, &format!("jitter = {jitter:?}"), &SIDES, "");
        let expected = Expected::Run { volume_error: 1e-9, speed: AT_REST };
        trial("rest", what, (0.01, 1.0), expected, scene)
    };
    vec![
        rest("one cell across", [0.1, 0.1], 0.1, 0.0),
        rest("two cells across", [0.2, 0.2], 0.1, 0.0),
        rest("nodes shifted by 0.45", [1.0, 0.5], 0.1, 0.45),
        rest("a puddle of one cell", [1.0, 0.05], 0.05, 0.0),
        rest("a column of one cell", [0.05, 1.0], 0.05, 0.0),
    ]
}

/// Cells that are many times finer in some places than in others, all at once and where the water runs.
fn graded(effort: Effort) -> Vec<Trial> {
    let corner = "box = { lower = [\"0 m\", \"0 m\"], upper = [\"0.1 m\", \"0.1 m\"] }";
    let tank_of = |fine: f64| tank([0.0; 2], [1.0, 0.5], 0.1, "", &SIDES, &refined(corner, fine));
    let rest = |times: f64| {
        let expected = Expected::Run { volume_error: 1e-9, speed: AT_REST };
        let what = format!("at rest, {times} times finer in a corner");
        trial("graded", what, (0.01, 0.5), expected, tank_of(0.1 / times))
    };
    let far = plane("far-wall", [0.584, 0.0], [-1.0, 0.0]);
    let near = |what: &str| far.clone() + &refined(&format!("near = {what:?}"), 0.0073);
    let dam = |what: &str| {
        let expected = Expected::Run { volume_error: 1e-2, speed: MOVING };
        let scene = tank([0.0, 0.0], [0.146, 0.292], 0.0292, "", &["x-min", "y-min"], &near(what));
        let end = if effort == Effort::Quick { 0.5 } else { 1.5 };
        trial("graded", format!("dam break, 4 times finer near {what}"), (1e-3, end), expected, scene)
    };
    vec![rest(8.0), rest(30.0), dam("surface"), dam("walls")]
}

/// Water that meets water, or a wall.
fn impacts(effort: Effort) -> Vec<Trial> {
    let expected = Expected::Run { volume_error: 5e-3, speed: MOVING };
    let pool = tank([0.0, 0.0], [0.584, 0.146], 0.0146, "", &SIDES, "");
    let struck = |speed: f64| {
        let scene = pool.clone() + &drop([0.3, 0.25], 0.05, speed);
        let end = if effort == Effort::Quick { 0.2 } else { 0.6 };
        trial("impact", format!("drop at {speed} m/s"), (1e-3 / speed.max(1.0), end), expected, scene)
    };
    let far = plane("far-wall", [0.584, 0.0], [-1.0, 0.0]);
    let dam = tank([0.0, 0.0], [0.146, 0.292], 0.0146, "", &["x-min", "y-min"], &far);
    let end = if effort == Effort::Quick { 0.8 } else { 3.0 };
    let dam = trial("impact", "dam break against a wall", (1e-3, end), expected, dam);
    vec![struck(1.0), struck(10.0), dam]
}

/// Fluid without any wall.
fn flights() -> Vec<Trial> {
    let expected = Expected::Run { volume_error: 1e-3, speed: MOVING };
    let turning = "velocity = { expression = [\"-10*y\", \"10*x\"] }\n";
    let blob = tank([-0.1, -0.1], [0.1, 0.1], 0.02, "", &[], "");
    let jet = tank([0.0, 0.5], [0.5, 0.51], 0.01, "", &[], &plane("floor", [0.0, 0.0], [0.0, 1.0]));
    vec![
        trial("flight", "a square that turns and falls", (2e-3, 0.2), expected, format!("{turning}{blob}")),
        trial("flight", "a sheet of one cell onto a floor", (1e-3, 0.5), expected, jet),
    ]
}

/// Ten thousand steps.
fn long(effort: Effort) -> Vec<Trial> {
    let steps = if effort == Effort::Quick { 500.0 } else { 10_000.0 };
    let keys = "surface = \"0.5 + 0.05*cos(pi*x)\"";
    let scene = tank([0.0, 0.0], [1.0, 0.5], 0.05, keys, &SIDES, "");
    let expected = Expected::Run { volume_error: 1e-3, speed: 1.0 };
    vec![trial("long", format!("{steps} steps of sloshing"), (5e-3, 5e-3 * steps), expected, scene)]
}

/// Walls that end, and bubbles that cannot leave.
fn edges(effort: Effort) -> Vec<Trial> {
    let quick = effort == Effort::Quick;
    let expected = Expected::Run { volume_error: 1e-2, speed: MOVING };
    let far = plane("far-wall", [0.584, 0.0], [-1.0, 0.0]);
    let obstacle = [[0.292, -0.05], [0.292, 0.048], [0.316, 0.048], [0.316, -0.05]];
    let obstacle = wall("obstacle", &polyline(&obstacle));
    let lid = plane("lid", [0.0, 0.3], [0.0, -1.0]);
    let dam = |further: String| tank([0.0, 0.0], [0.146, 0.292], 0.0146, "", &["x-min", "y-min"], &further);

    let beach = wall("beach", &polyline(&[[-0.5, 0.0], [1.5, 0.0], [3.5, 0.8]]));
    let stroke =
        "motion = { oscillation = { direction = [1, 0], amplitude = \"50 mm\", frequency = \"0.7 1/s\" } }\n";
    let piston = plane("piston", [0.0, 0.0], [1.0, 0.0]) + stroke;
    let waves = tank([0.0, 0.0], [1.5, 0.3], 0.03, "", &[], &(beach + &piston));

    let block = polyline(&[[-0.05, 0.17], [-0.05, 0.27], [0.05, 0.27], [0.05, 0.17]]);
    let sinks = "polyline.closed = true\nmotion = { translation = [\"0 m/s\", \"-0.1 m/s\"] }";
    let block = wall("block", &format!("{block}\n{sinks}"));
    let pushed = tank([-0.2, 0.0], [0.2, 0.15], 0.01, "", &["x-min", "x-max", "y-min"], &block);

    let sill =
        [[0.0, 1.0], [0.0, 0.0], [0.5, 0.0], [0.5, 0.2], [0.52, 0.2], [0.52, -0.2], [1.2, -0.2], [1.2, 1.0]];
    let weir = tank([0.0, 0.0], [0.5, 0.25], 0.0125, "", &[], &wall("tank", &polyline(&sill)));
    let sill = [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 0.12], [2.0, 0.12], [2.0, 1.0]];
    let hump = "surface = \"0.2 + 0.15*exp(-(x/0.3)^2)\"";
    let hump = tank([0.0, 0.0], [1.0, 0.3], 0.02, hump, &[], &wall("tank", &polyline(&sill)));
    vec![
        trial("edge", "a wave over a step", (2e-3, if quick { 0.8 } else { 3.0 }), expected, hump),
        trial(
            "edge",
            "a block let down on level water",
            (1e-3, 0.4),
            Expected::Open { volume_error: 1e-3, speed: MOVING },
            pushed,
        ),
        trial("edge", "a weir into a lower tank", (2e-3, 0.8), expected, weir),
        trial(
            "edge",
            "a piston before a beach of 22 degrees",
            (4e-3, 2.0),
            Expected::Open { volume_error: 5e-3, speed: MOVING },
            waves,
        ),
        trial("edge", "an obstacle with dry edges", (1e-3, 0.6), expected, dam(far.clone() + &obstacle)),
        trial("edge", "air shut in under a lid", (1e-3, 0.8), expected, dam(far + &lid)),
    ]
}

/// A tank with an open side under gravity and a pull.
fn emptied() -> Vec<Trial> {
    let expected = Expected::Open { volume_error: 1e-3, speed: MOVING };
    let floor = plane("floor", [0.0, 0.0], [0.0, 1.0]);
    let scene = tank([0.0, 0.0], [0.5, 0.2], 0.025, "", &["x-min"], &floor).replace(
        &boundary(&["x-max", "y-min", "y-max"], "free-surface"),
        &(boundary(&["y-min", "y-max"], "free-surface") + &boundary(&["x-max"], "outlet")),
    );
    let scene = format!("body-force = [\"3 m/s^2\", \"0 m/s^2\"]\n{scene}");
    vec![trial("empty", "a tank to the last node", (5e-3, 3.0), expected, scene)]
}

/// What cannot be computed says why.
fn refusals() -> Vec<Trial> {
    let refused = |what: &str, upper: [f64; 2], why| {
        let scene = tank([0.0, 0.0], upper, 0.1, "", &SIDES, "");
        trial("refusal", what, (1e-3, 0.1), Expected::Refusal(why), scene)
    };
    vec![
        refused("all nodes on a line", [1.0, 0.0], "fluid.mesh.box"),
        refused("no extent", [0.0, 0.0], "fluid.mesh.box"),
    ]
}
