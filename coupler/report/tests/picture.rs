//! Pictures of scenes made by hand.

use report::{Bounds, FluidMesh, FluidView, Grain, PictureOptions, ReportError, Scene, picture_of};
use tiny_skia::Pixmap;

fn grain(centre: [f64; 3], radius: f64, value: f64) -> Grain {
    Grain { centre, radius, value }
}

fn decoded(scene: &Scene, options: &PictureOptions) -> Pixmap {
    Pixmap::decode_png(&picture_of(scene, options).unwrap()).unwrap()
}

/// Share of the picture that is not white.
fn covered(picture: &Pixmap) -> f64 {
    let painted = picture.pixels().iter().filter(|p| p.red().min(p.green()).min(p.blue()) < 250).count();
    painted as f64 / picture.pixels().len() as f64
}

fn unit_square(values: [f64; 4]) -> FluidMesh {
    FluidMesh {
        points: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        tetrahedra: Vec::new(),
        values: values.to_vec(),
    }
}

#[test]
fn a_disc_covers_a_quarter_of_pi_of_its_box() {
    let scene = Scene { grains: vec![grain([3.0, -2.0, 0.0], 0.1, 1.0)], mesh: None };
    let picture = decoded(&scene, &PictureOptions { size: [624, 624], ..PictureOptions::default() });
    let expected = std::f64::consts::FRAC_PI_4 * (600.0 / 624.0f64).powi(2);
    assert!((covered(&picture) - expected).abs() < 2e-3, "{} of {expected}", covered(&picture));
}

#[test]
fn the_nearer_sphere_hides_the_other() {
    let bounds = Some(Bounds { low: [-1.0; 3], high: [1.0; 3] });
    let options = PictureOptions { bounds, grain_range: Some((0.0, 1.0)), ..PictureOptions::default() };
    // The viewer is on the side of −y.
    let (near, far) = (grain([0.0, -0.5, 0.1], 0.5, 1.0), grain([0.0, 0.5, 0.1], 0.3, 0.0));
    let both = decoded(&Scene { grains: vec![near, far], mesh: None }, &options);
    let reversed = decoded(&Scene { grains: vec![far, near], mesh: None }, &options);
    assert_eq!(both.data(), reversed.data());
    let dark =
        |picture: &Pixmap| picture.pixels().iter().filter(|p| p.blue() > p.green() && p.green() < 60).count();
    let alone = decoded(&Scene { grains: vec![far], mesh: None }, &options);
    assert!(dark(&both) < dark(&alone), "{} of {}", dark(&both), dark(&alone));
}

#[test]
fn nothing_to_see_and_impossible_grains_make_a_white_picture() {
    let grains = vec![
        grain([f64::NAN, 0.0, 0.0], 1.0, 0.0),
        grain([0.0; 3], 0.0, 0.0),
        grain([0.0; 3], -1.0, 0.0),
        grain([0.0; 3], f64::INFINITY, 0.0),
    ];
    for scene in [
        Scene::default(),
        Scene { grains, mesh: None },
        Scene { grains: vec![], mesh: Some(FluidMesh::default()) },
    ] {
        assert_eq!(covered(&decoded(&scene, &PictureOptions::default())), 0.0);
    }
}

#[test]
fn huge_ratios_of_size_still_make_a_picture() {
    let grains = vec![grain([0.0; 3], 1e-12, 1.0), grain([1e9, 0.0, 1.0], 1.0, f64::NAN)];
    for view in [FluidView::Slice, FluidView::Surface] {
        let scene = Scene { grains: grains.clone(), mesh: Some(unit_square([0.0, f64::NAN, 1e300, -1e300])) };
        assert!(
            covered(&decoded(&scene, &PictureOptions { fluid_view: view, ..PictureOptions::default() }))
                > 0.0
        );
    }
}

#[test]
fn a_mesh_that_contradicts_itself_is_refused() {
    let mut mesh = unit_square([0.0; 4]);
    mesh.triangles.push([0, 1, 4]);
    let refused = |mesh: FluidMesh| {
        picture_of(&Scene { grains: vec![], mesh: Some(mesh) }, &PictureOptions::default()).unwrap_err()
    };
    assert!(matches!(refused(mesh), ReportError::Mesh { found: 4, points: 4, .. }));
    let mut mesh = unit_square([0.0; 4]);
    mesh.values.pop();
    assert!(matches!(refused(mesh), ReportError::Mesh { found: 3, points: 4, .. }));
}

#[test]
fn a_size_nobody_can_see_is_refused() {
    for size in [[0, 500], [500, 100_000]] {
        let options = PictureOptions { size, ..PictureOptions::default() };
        assert!(matches!(picture_of(&Scene::default(), &options), Err(ReportError::PictureSize { .. })));
    }
}
