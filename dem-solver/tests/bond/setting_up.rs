//! Bonds of a case: which pairs they join, and what is refused.

use std::fs;

use case_io::document::{Case, Overrides};
use dem_solver::{Setup, set_up};

/// Three grains in a row, 0.1 mm apart, a frozen pair beside them, and bonds.
const CASE: &str = r#"
[case]
title = "glued grains"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[time]
end = "1 ms"
[materials.glass]
density = "2500 kg/m^3"
youngs-modulus = "10 MPa"
poissons-ratio = 0.3
[pairs.glass-glass]
restitution = 0.9
sliding-friction = 0.3
[grains]
normal-law = "hertz"
domain = { lower = ["0 m", "-1 m", "-1 m"], upper = ["10 mm", "1 m", "1 m"] }
periodic = ["x"]
[[insertion]]
name = "row"
material = "glass"
diameter = "2 mm"
at = [["1 mm", "0 m", "0 m"], ["3.1 mm", "0 m", "0 m"], ["5.2 mm", "0 m", "0 m"]]
[[insertion]]
name = "base"
material = "glass"
diameter = "2 mm"
frozen = true
at = [["1 mm", "0 m", "-5 mm"], ["3 mm", "0 m", "-5 mm"]]
[[bond]]
law = "parallel-bond"
gap = "0.15 mm"
youngs-modulus = "1 GPa"
stiffness-ratio = 2.5
"#;

const OTHER: &str =
    "\n[[bond]]\nlaw = \"cohesive\"\ngap = \"0.15 mm\"\nyoungs-modulus = \"1 GPa\"\npoissons-ratio = 0.2\n";

fn set(name: &str, text: &str) -> Result<Setup<3>, String> {
    let folder = std::env::temp_dir().join(format!("dem-solver-bonds-{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("case.toml"), text).unwrap();
    let told = |error: &dyn std::fmt::Display| error.to_string();
    let case = Case::load(&folder, &Overrides::default()).map_err(|error| told(&error));
    let setup = case.and_then(|mut cases| set_up(&cases.remove(0), None).map_err(|error| told(&error)));
    fs::remove_dir_all(folder).unwrap();
    setup
}

fn pairs(text: &str) -> Vec<[u64; 2]> {
    set("pairs", text).unwrap().world.bonds.iter().map(|bond| bond.grains).collect()
}

#[test]
fn grains_up_to_the_gap_apart_are_bonded_but_no_frozen_pair() {
    assert_eq!(pairs(CASE), [[0, 1], [1, 2]]);
    // Across the period of 10 mm from 9.1 to 1 mm there are 1.9 mm: 0.1 mm of overlap.
    let far = CASE.replace("\"5.2 mm\"", "\"9.1 mm\"").replace("[grains]", "[grains]\nstart-overlap = 0.1");
    assert_eq!(pairs(&far), [[0, 1], [0, 2]]);
    let of_row = CASE.replace("gap = ", "insertions = [\"row\"]\ngap = ");
    assert_eq!(pairs(&of_row), [[0, 1], [1, 2]]);
}

#[test]
fn bonds_that_join_nothing_or_join_twice_are_refused_with_their_table() {
    let near = CASE.replace("gap = \"0.15 mm\"", "gap = \"0.05 mm\"");
    assert!(
        set("near", &near).unwrap_err().ends_with(
            "bond[0].gap: no pair of grains is so near; allowed: two grains, not both frozen, up to 5e-5 m apart; state a larger gap, or insert the grains nearer to each other"
        ),
        "{}",
        set("near", &near).unwrap_err()
    );
    let frozen = CASE.replace("gap = ", "insertions = [\"base\"]\ngap = ");
    assert!(set("frozen", &frozen).unwrap_err().contains("bond[0].gap: no pair of grains is so near"));
    let twice = set("twice", &format!("{CASE}{OTHER}")).unwrap_err();
    assert!(
        twice.ends_with("bond[1]: bonds grains 0 and 1, which bond[0] bonds too; allowed: one table a pair; name the insertions of each, or leave one of them out"),
        "{twice}"
    );
    let missing = CASE.replace("gap = ", "insertions = [\"rows\"]\ngap = ");
    let missing = set("missing", &missing).unwrap_err();
    assert!(
        missing.contains("bond[0].insertions[0]: there is no insertion at t = 0 of the name \"rows\""),
        "{missing}"
    );
}
