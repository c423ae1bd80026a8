//! Every shipped case runs in its fast variant and passes its checks.

#[path = "../support/mod.rs"]
mod support;

use support::{Folder, case, run, stderr};

fn passes(name: &str) {
    let folder = Folder::new();
    let output = run(&case(name), &folder.join("out"), &[], &[]);
    let said = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{name}: {}\n{said}", stderr(&output));
    assert!(said.contains("pass  "), "{name} has checks: {said}");
    assert!(folder.join("out/report.html").exists(), "{name} has one report, over all its runs");
}

/// One test per case; a case without a test fails the last one.
macro_rules! cases {
    ($($test:ident $name:literal)+) => {
        $(#[test] fn $test() { passes($name); })+

        #[test]
        fn every_shipped_case_is_run() {
            let mut found: Vec<String> = std::fs::read_dir(case("")).unwrap().flatten()
                .map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
            found.sort();
            assert_eq!(found, [$($name),+]);
        }
    };
}

cases! {
    bingham_slump "bingham-slump"
    bonded_beam "bonded-beam"
    collapse_50 "collapse-50"
    dam_break "dam-break"
    dam_break_3d "dam-break-3d"
    dam_break_front "dam-break-front"
    dam_break_marin "dam-break-marin"
    dam_break_obstacle "dam-break-obstacle"
    dam_break_wall "dam-break-wall"
    falling_cylinder "falling-cylinder"
    filling_container "filling-container"
    filling_container_3d "filling-container-3d"
    fluidised_bed "fluidised-bed"
    grains_in_sloshing_tank "grains-in-sloshing-tank"
    grains_into_water "grains-into-water"
    heap "heap"
    hindered_settling "hindered-settling"
    hydrostatic_half_bed "hydrostatic-half-bed"
    oblique_impact "oblique-impact"
    packed_bed "packed-bed"
    pipe_sediment "pipe-sediment"
    relaxation_box "relaxation-box"
    rising_and_sinking "rising-and-sinking"
    rolling_start "rolling-start"
    rotating_drum "rotating-drum"
    settling_ode "settling-ode"
    settling_sphere "settling-sphere"
    settling_sphere_periodic "settling-sphere-periodic"
    silo_discharge "silo-discharge"
    slide_into_water "slide-into-water"
    sloshing_tank "sloshing-tank"
    stones_in_mud "stones-in-mud"
    tumbling_dumbbell "tumbling-dumbbell"
    two_sphere_impact "two-sphere-impact"
}
