//! Keys and values of `case.toml`.

use crate::ending::coupler;
use crate::refusal::{assert_refused, refusal};
use crate::scene::Scene;
use crate::support::Folder;
use std::fs;

#[test]
fn a_misspelt_key_is_refused_with_the_nearest() {
    let scene = Scene::coupled().with("normal-law =", "normal-lw =");
    assert_refused(
        &scene,
        "normal-lw",
        "grains.normal-lw",
        &["unknown key", "allowed: normal-law,", "did you mean \"normal-law\"?"],
    );
}

#[test]
fn a_value_of_another_type_is_refused() {
    let scene = Scene::coupled().with("poissons-ratio = 0.3", "poissons-ratio = \"soft\"");
    assert_refused(
        &scene,
        "poissons-ratio",
        "materials.glass.poissons-ratio",
        &["found the string \"soft\"", "allowed: a number"],
    );
}

#[test]
fn a_bare_number_where_a_unit_is_due_is_refused() {
    let scene = Scene::coupled().with("\"1000 kg/m^3\"", "1000");
    assert_refused(
        &scene,
        "density = 1000",
        "fluid.density",
        &["value 1000 has no unit", "write \"1000 kg/m^3\""],
    );
}

#[test]
fn a_unit_of_another_kind_is_refused() {
    let scene = Scene::coupled().with("\"5 mPa s\"", "\"5 mPa\"");
    assert_refused(
        &scene,
        "\"5 mPa\"",
        "fluid.viscosity",
        &["\"5 mPa\" is a pressure", "not a dynamic viscosity", "write for example \"2.5 mPa s\""],
    );
}

#[test]
fn a_negative_density_is_refused() {
    let scene = Scene::coupled().with("\"2500 kg/m^3\"", "\"-2500 kg/m^3\"");
    assert_refused(
        &scene,
        "-2500",
        "materials.glass.density",
        &["found -2500 kg/m^3", "allowed: more than 0 kg/m^3"],
    );
}

#[test]
fn a_number_that_is_none_is_refused() {
    for value in ["nan", "inf", "-inf"] {
        let scene = Scene::coupled().with("restitution = 0.9", &format!("restitution = {value}"));
        assert_refused(&scene, "restitution", "pairs.glass-glass.restitution", &["found", "allowed: "]);
        let scene = Scene::coupled().with("\"20 ms\"", &format!("\"{value} ms\""));
        assert_refused(&scene, "end =", "time.end", &[value, "finite number"]);
    }
}

#[test]
fn a_diameter_of_zero_is_refused() {
    let scene = Scene::carried().with("\"1 mm\"", "\"0 mm\"");
    assert_refused(&scene, "diameter", "insertion[0].diameter", &["found 0 m", "allowed: more than 0 m"]);
}

#[test]
fn a_pair_that_can_touch_and_is_not_stated_is_refused() {
    let pair = "[pairs.glass-glass]\nrestitution = 0.9\nsliding-friction = 0.3\n";
    let scene = Scene::coupled().with(pair, "");
    assert_refused(
        &scene,
        "material = \"glass\"\nplane",
        "wall[0].material",
        &[
            "how glass and glass touch is not stated",
            "add [pairs.glass-glass] with restitution and sliding-friction",
        ],
    );
}

#[test]
fn an_unknown_drag_law_is_refused_with_all_known() {
    let scene = Scene::coupled().with("\"di-felice\"", "\"di-felic\"");
    assert_refused(
        &scene,
        "di-felic",
        "coupling.drag",
        &["unknown drag \"di-felic\"", "allowed: none, stokes,", "wen-yu", "did you mean \"di-felice\"?"],
    );
}

#[test]
fn an_option_without_effect_is_refused() {
    let scene = Scene::coupled().with("\"hertz\"", "\"hertz\"\ncharacteristic-velocity = \"1 m/s\"");
    assert_refused(
        &scene,
        "characteristic-velocity",
        "grains.characteristic-velocity",
        &["has no effect with normal-law = \"hertz\"", "delete it"],
    );
    let scene = Scene::coupled().with("serial-implicit\"", "serial-explicit\"\nmax-iterations = 3");
    assert_refused(&scene, "max-iterations", "coupling.max-iterations", &["has no effect", "delete it"]);
}

#[test]
fn a_text_that_is_no_toml_is_refused_at_line_and_column() {
    let scene = Scene::coupled().with("[grains]", "[grains");
    let line = refusal(&scene);
    let place = scene.place("[grains").trim_end_matches(": ").to_string();
    assert!(line.starts_with(&format!("{place}:8: not TOML: ")), "{line}");
}

#[test]
fn bytes_that_are_no_text_are_refused() {
    let scene = Scene::coupled();
    let noise: Vec<u8> = (0..4096_u32).map(|k| (k.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
    fs::write(scene.path().join("case.toml"), noise).unwrap();
    let line = refusal(&scene);
    for part in ["case.toml: ", "UTF-8", "a case is a folder with case.toml"] {
        assert!(line.contains(part), "{part:?} is not in: {line}");
    }
}

#[test]
fn a_case_that_is_not_there_is_refused() {
    let folder = Folder::new();
    fs::create_dir(folder.join("empty")).unwrap();
    for (case, path) in [("nowhere", "nowhere: "), ("empty", "empty/case.toml: ")] {
        for arguments in [vec!["check", case], vec!["plan", case], vec!["run", case, "--out", "out"]] {
            let ending = coupler(&folder, &arguments);
            let line = ending.assert_line(3, &["No such file", "a case is a folder with case.toml"]);
            assert!(line.starts_with(path), "{line}");
        }
    }
    assert!(!folder.join("out").exists(), "a case that is not there leaves no output");
}

#[test]
fn a_check_that_cannot_be_understood_is_refused_before_the_run() {
    let scene =
        Scene::coupled().with_file("check.toml", "[[check]]\nname = \"fall\"\nquantiti = \"grains.z[m]\"\n");
    let line = refusal(&scene);
    for part in ["check.toml:3: check[0].quantiti: unknown key", "allowed: ", "did you mean \"quantity\"?"] {
        assert!(line.contains(part), "{part:?} is not in: {line}");
    }
    let empty = Scene::coupled().with_file("check.toml", "");
    assert!(refusal(&empty).contains("check.toml:1: check: "), "an empty check.toml holds nothing");
}
