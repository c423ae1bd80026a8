//! What is tried: tanks of water in the plane, poured, shaken, struck.

use super::outcome::Expected;

/// How long trials last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Minutes.
    Quick,
    /// As long as it takes.
    Full,
}

/// A trial.
#[derive(Clone, Debug)]
pub struct Trial {
    /// The family.
    pub topic: &'static str,
    /// What is tried of it.
    pub what: String,
    /// Length of a window \[s\].
    pub window: f64,
    /// End \[s\].
    pub end: f64,
    /// What a right answer keeps to.
    pub expected: Expected,
    scene: String,
}

/// g (m/s²).
const GRAVITY: f64 = 9.81;

/// A rest that is exact but for the tolerance of the solver (m/s).
const AT_REST: f64 = 1e-8;

/// A speed that says no more than that the answer is bounded (m/s).
const MOVING: f64 = 20.0;

impl Trial {
    fn new(
        topic: &'static str,
        what: impl Into<String>,
        (window, end): (f64, f64),
        expected: Expected,
        scene: String,
    ) -> Self {
        Self { topic, what: what.into(), window, end, expected, scene }
    }

    /// The case.
    pub fn case(&self) -> String {
        let Self { topic, what, window, end, scene, .. } = self;
        format!(
            "[case]\ntitle = \"{topic}: {what}\"\ndimension = 2\ngravity = [\"0 m/s^2\", \"-{GRAVITY} m/s^2\"]\n\
             [time]\nend = \"{end} s\"\nwindow = \"{window} s\"\n\
             [fluid]\nbackend = \"pfem\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"1 mPa s\"\n{scene}"
        )
    }
}

/// All trials, in the order of the map.
pub fn trials(effort: Effort) -> Vec<Trial> {
    [courant(), clouds(), impacts(effort), flights(), long(effort), edges(), refusals()].concat()
}

/// The walls of a tank of 1 m, `wet` of which are sides of the mesh.
fn tank(lower: [f64; 2], upper: [f64; 2], size: f64, keys: &str, wet: &[&str], further: &str) -> String {
    let free: Vec<String> = ["x-min", "x-max", "y-min", "y-max"]
        .iter()
        .filter(|side| !wet.contains(side))
        .map(|side| format!("\"{side}\""))
        .collect();
    let wet: Vec<String> = wet.iter().map(|side| format!("\"{side}\"")).collect();
    let [[a, b], [c, d]] = [lower, upper];
    let mut text = format!(
        "[fluid.mesh.box]\nlower = [\"{a} m\", \"{b} m\"]\nupper = [\"{c} m\", \"{d} m\"]\nsize = \"{size} m\"\n{keys}\n\
         [[fluid.boundary]]\non = [{}]\nkind = \"free-surface\"\n",
        free.join(", ")
    );
    if !wet.is_empty() {
        text += &format!("[[fluid.boundary]]\non = [{}]\nkind = \"slip\"\n", wet.join(", "));
    }
    text + further
}

/// A plane wall that no side of the mesh is on.
fn plane(name: &str, point: [f64; 2], normal: [f64; 2]) -> String {
    let ([x, y], [nx, ny]) = (point, normal);
    format!(
        "[[fluid.boundary]]\non = [\"{name}\"]\nkind = \"slip\"\n\
         [[wall]]\nname = \"{name}\"\nplane = {{ point = [\"{x} m\", \"{y} m\"], normal = [{nx:?}, {ny:?}] }}\n"
    )
}

/// A tank with the water against its sides.
const SIDES: [&str; 3] = ["x-min", "x-max", "y-min"];

/// A wave over windows from a tenth to five times what it takes to cross a cell.
fn courant() -> Vec<Trial> {
    let (width, size): (f64, f64) = (1.0, 0.05);
    let period =
        2.0 * (std::f64::consts::PI * width / (GRAVITY * (std::f64::consts::FRAC_PI_2).tanh())).sqrt();
    let crossing = size / (GRAVITY * 0.5_f64).sqrt();
    let trial = |courant: f64| {
        let keys = "surface = \"0.5 + 0.01*cos(pi*x)\"";
        let scene = tank([0.0, 0.0], [width, 0.5], size, keys, &SIDES, "");
        let expected = Expected::Run { volume_error: 1e-4, speed: 0.1 };
        Trial::new("wave", format!("courant {courant}"), (courant * crossing, 2.0 * period), expected, scene)
    };
    [0.1, 0.5, 1.0, 2.0, 5.0].map(trial).to_vec()
}

/// Water at rest on few nodes, and on nodes that are far from even.
fn clouds() -> Vec<Trial> {
    let rest = |what: &str, upper: [f64; 2], size: f64, jitter: f64| {
        let scene = tank([0.0, 0.0], upper, size, &format!("jitter = {jitter:?}"), &SIDES, "");
        let expected = Expected::Run { volume_error: 1e-9, speed: AT_REST };
        Trial::new("rest", what, (0.01, 1.0), expected, scene)
    };
    vec![
        rest("one cell across", [0.1, 0.1], 0.1, 0.0),
        rest("two cells across", [0.2, 0.2], 0.1, 0.0),
        rest("nodes shifted by 0.45", [1.0, 0.5], 0.1, 0.45),
        rest("a puddle of one cell", [1.0, 0.05], 0.05, 0.0),
        rest("a column of one cell", [0.05, 1.0], 0.05, 0.0),
    ]
}

/// Water that meets water, or a wall.
fn impacts(effort: Effort) -> Vec<Trial> {
    let expected = Expected::Run { volume_error: 5e-3, speed: MOVING };
    let pool = tank([0.0, 0.0], [0.584, 0.146], 0.0146, "", &SIDES, "");
    let drop = |speed: f64| {
        let scene = format!(
            "{pool}[[fluid.body]]\nsphere = {{ centre = [\"0.3 m\", \"0.25 m\"], radius = \"0.05 m\" }}\n\
             velocity = [\"0 m/s\", \"-{speed} m/s\"]\n"
        );
        let end = if effort == Effort::Quick { 0.2 } else { 0.6 };
        Trial::new("impact", format!("drop at {speed} m/s"), (1e-3 / speed.max(1.0), end), expected, scene)
    };
    let far = plane("far-wall", [0.584, 0.0], [-1.0, 0.0]);
    let dam = tank([0.0, 0.0], [0.146, 0.292], 0.0146, "", &["x-min", "y-min"], &far);
    let end = if effort == Effort::Quick { 0.8 } else { 3.0 };
    let dam = Trial::new("impact", "dam break against a wall", (1e-3, end), expected, dam);
    vec![drop(1.0), drop(10.0), dam]
}

/// Fluid without any wall.
fn flights() -> Vec<Trial> {
    let expected = Expected::Run { volume_error: 1e-3, speed: MOVING };
    let turning = "velocity = { expression = [\"-10*y\", \"10*x\"] }\n";
    let blob = tank([-0.1, -0.1], [0.1, 0.1], 0.02, "", &[], "");
    let jet = tank([0.0, 0.5], [0.5, 0.51], 0.01, "", &[], &plane("floor", [0.0, 0.0], [0.0, 1.0]));
    vec![
        Trial::new(
            "flight",
            "a square that turns and falls",
            (2e-3, 0.2),
            expected,
            format!("{turning}{blob}"),
        ),
        Trial::new("flight", "a sheet of one cell onto a floor", (1e-3, 0.5), expected, jet),
    ]
}

/// Ten thousand steps.
fn long(effort: Effort) -> Vec<Trial> {
    let steps = if effort == Effort::Quick { 500.0 } else { 10_000.0 };
    let keys = "surface = \"0.5 + 0.05*cos(pi*x)\"";
    let scene = tank([0.0, 0.0], [1.0, 0.5], 0.05, keys, &SIDES, "");
    let expected = Expected::Run { volume_error: 1e-3, speed: 1.0 };
    vec![Trial::new("long", format!("{steps} steps of sloshing"), (5e-3, 5e-3 * steps), expected, scene)]
}

/// Walls that end, and bubbles that cannot leave.
fn edges() -> Vec<Trial> {
    let expected = Expected::Run { volume_error: 1e-2, speed: MOVING };
    let far = plane("far-wall", [0.584, 0.0], [-1.0, 0.0]);
    let obstacle = "[[fluid.boundary]]\non = [\"obstacle\"]\nkind = \"slip\"\n[[wall]]\nname = \"obstacle\"\n\
         polyline = { points = [[\"0.292 m\", \"-0.05 m\"], [\"0.292 m\", \"0.048 m\"], [\"0.316 m\", \"0.048 m\"], [\"0.316 m\", \"-0.05 m\"]] }\n";
    let lid = plane("lid", [0.0, 0.3], [0.0, -1.0]);
    let dam = |further: String| tank([0.0, 0.0], [0.146, 0.292], 0.0146, "", &["x-min", "y-min"], &further);
    vec![
        Trial::new("edge", "an obstacle with dry edges", (1e-3, 0.6), expected, dam(far.clone() + obstacle)),
        Trial::new("edge", "air shut in under a lid", (1e-3, 0.8), expected, dam(far + &lid)),
    ]
}

/// What cannot be computed says why.
fn refusals() -> Vec<Trial> {
    let refused = |what: &str, upper: [f64; 2], why| {
        let scene = tank([0.0, 0.0], upper, 0.1, "", &SIDES, "");
        Trial::new("refusal", what, (1e-3, 0.1), Expected::Refusal(why), scene)
    };
    vec![
        refused("all nodes on a line", [1.0, 0.0], "fluid.mesh.box"),
        refused("no extent", [0.0, 0.0], "fluid.mesh.box"),
    ]
}
