//! From frames on disk to a scene.

use case_io::output::vtk::Frame;

use crate::picture::{FluidMesh, Grain, Scene};

/// The scene of a frame of grains (fields `radius`, `velocity`) and a frame of the fluid (nodal field `velocity`):
/// colours show speeds. What a frame does not hold is drawn grey; grains without radius are drawn as dots.
pub fn scene_of(grains: Option<&Frame>, fluid: Option<&Frame>) -> Scene {
    Scene { grains: grains.map_or(Vec::new(), grains_of), mesh: fluid.map(mesh_of) }
}

fn grains_of(frame: &Frame) -> Vec<Grain> {
    let radii = frame.point_field("radius").map(|field| &field.values);
    let radius = |row: usize| radii.and_then(|radii| radii.get(row)).copied().unwrap_or(f64::MIN_POSITIVE);
    frame
        .points
        .iter()
        .zip(speeds(frame))
        .enumerate()
        .map(|(row, (&centre, value))| Grain { centre, radius: radius(row), value })
        .collect()
}

fn mesh_of(frame: &Frame) -> FluidMesh {
    FluidMesh {
        points: frame.points.clone(),
        triangles: frame.triangles.clone(),
        tetrahedra: frame.tetrahedra.clone(),
        values: speeds(frame),
    }
}

/// Length of the velocity at every point; NaN without one.
fn speeds(frame: &Frame) -> Vec<f64> {
    frame.point_field("velocity").map_or(vec![f64::NAN; frame.points.len()], |field| field.magnitudes())
}
