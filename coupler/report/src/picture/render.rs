//! From a scene to a PNG.

use tiny_skia::{Pixmap, PremultipliedColorU8};

use super::boundary::{boundary_faces, normal, sharp_edges};
use super::camera::Camera;
use super::colour_bar::{COLUMN, ColourBar};
use super::colour_map::{Colour, ColourMap};
use super::layer::Layer;
use super::lettering::{text_width, write_text};
use super::line::draw_line;
use super::shading::{darken_crevices, lit_surface};
use super::slice::slice;
use super::sphere::{draw_disc, draw_sphere};
use super::triangle::draw_triangle;
use super::{Bounds, FluidMesh, FluidView, Scene};
use crate::ReportError;

/// How a scene becomes a picture.
#[derive(Debug, Clone)]
pub struct PictureOptions {
    /// Largest width and height \[pixels\]; the picture takes the shape of the scene within it.
    pub size: [u32; 2],
    /// What is framed; the scene itself unless given. Pictures of one run share it.
    pub bounds: Option<Bounds>,
    /// How a fluid in space is shown.
    pub fluid_view: FluidView,
    /// Values at the ends of the grains' colour bar; those of the scene unless given.
    pub grain_range: Option<(f64, f64)>,
    /// Values at the ends of the fluid's colour bar; those of the scene unless given.
    pub fluid_range: Option<(f64, f64)>,
    /// Name and unit of the grains' value.
    pub grain_label: [String; 2],
    /// Name and unit of the fluid's value.
    pub fluid_label: [String; 2],
    /// A line above the scene, e.g. its time.
    pub caption: String,
}

impl Default for PictureOptions {
    fn default() -> Self {
        Self {
            size: [900, 640],
            bounds: None,
            fluid_view: FluidView::default(),
            grain_range: None,
            fluid_range: None,
            grain_label: ["grain speed".to_owned(), "m/s".to_owned()],
            fluid_label: ["fluid speed".to_owned(), "m/s".to_owned()],
            caption: String::new(),
        }
    }
}

const BACKGROUND: Colour = [1.0, 1.0, 1.0];
const OUTLINE: Colour = [0.52, 0.57, 0.62];
const SMALLEST: u32 = 200;
const LARGEST: u32 = 8000;
/// Height of the line above the scene \[pixels\].
const CAPTION: usize = 30;
const MARGIN: usize = 12;
/// Height of the caption's capitals \[pixels\].
const LETTERS: f32 = 10.0;
/// Height a colour bar needs to be legible \[pixels\].
const BAR_HEIGHT: usize = 120;
/// How much of a fluid in space hides the grains behind it.
const VEIL: f32 = 0.55;

/// Draws the scene as PNG: grains shaded and coloured by their value, the fluid by its nodal value (as pale blue where
/// there are grains), with colour bars. Deterministic, in one thread, with four samples per pixel.
///
/// # Errors
/// A size outside 200 to 8000 pixels, or a mesh whose cells or values do not match its points.
pub fn picture_of(scene: &Scene, options: &PictureOptions) -> Result<Vec<u8>, ReportError> {
    if options.size.iter().any(|size| !(SMALLEST..=LARGEST).contains(size)) {
        let (found, allowed) = (options.size, (SMALLEST, LARGEST));
        return Err(ReportError::PictureSize { found, smallest: allowed.0, largest: allowed.1 });
    }
    if let Some(mesh) = &scene.mesh {
        check(mesh)?;
    }
    let fluid_map = if scene.grains.is_empty() { ColourMap::Viridis } else { ColourMap::Water };
    let [own_grain_range, own_fluid_range] = scene.value_ranges();
    let grain_range = options.grain_range.or(own_grain_range).unwrap_or((0.0, 0.0));
    let fluid_range = options.fluid_range.or(own_fluid_range).unwrap_or((0.0, 0.0));
    let bars: Vec<ColourBar> = [
        (!scene.grains.is_empty(), ColourMap::Viridis, grain_range, &options.grain_label),
        (scene.mesh.is_some(), fluid_map, fluid_range, &options.fluid_label),
    ]
    .into_iter()
    .filter(|(shown, _, range, _)| *shown && range.1 > range.0)
    .map(|(_, map, range, [label, unit])| ColourBar { map, range, label, unit })
    .collect();

    let above = if options.caption.is_empty() { 0 } else { CAPTION };
    let beside = if bars.is_empty() { 0 } else { COLUMN + MARGIN };
    let room = [options.size[0] as usize - beside, options.size[1] as usize - above].map(|size| 2 * size);
    let bounds = options.bounds.or(scene.bounds()).unwrap_or(Bounds { low: [0.0; 3], high: [0.0; 3] });
    let camera = Camera::framing(&bounds, scene.is_plane(), room, 2.0 * MARGIN as f64);
    let (size, pixels) =
        draw(scene, options.fluid_view, &camera, fluid_map, grain_range, fluid_range).halved();

    let height = size[1].max(bars.len() * BAR_HEIGHT + 2 * MARGIN) + above;
    let captioned = text_width(&options.caption, LETTERS).ceil() as usize + 2 * MARGIN;
    let width = size[0].max(captioned) + beside;
    let mut pixmap = Pixmap::new(width as u32, height as u32).ok_or(ReportError::Png)?;
    pixmap.fill(tiny_skia::Color::WHITE);
    let canvas = pixmap.pixels_mut();
    for (row, colours) in pixels.chunks_exact(size[0].max(1)).enumerate() {
        for (column, &[r, g, b]) in colours.iter().enumerate() {
            if let Some(opaque) = PremultipliedColorU8::from_rgba(r, g, b, 255) {
                canvas[(row + above) * width + column] = opaque;
            }
        }
    }
    write_text(&mut pixmap, &options.caption, MARGIN as f32, 22.0, LETTERS);
    let left = (width - beside) as f32;
    let share = (height - above - MARGIN) as f32 / bars.len().max(1) as f32;
    for (number, bar) in bars.iter().enumerate() {
        let top = above as f32 + MARGIN as f32 + number as f32 * share;
        bar.draw(&mut pixmap, left, top, top + (share - MARGIN as f32).min(320.0));
    }
    pixmap.encode_png().map_err(|_| ReportError::Png)
}

/// Cells and values must match the points.
fn check(mesh: &FluidMesh) -> Result<(), ReportError> {
    let (points, values) = (mesh.points.len(), mesh.values.len());
    let nodes = mesh.triangles.as_flattened().iter().chain(mesh.tetrahedra.as_flattened());
    match nodes.max() {
        Some(&node) if node as usize >= points => {
            Err(ReportError::Mesh { what: "node number", found: node as usize, points })
        }
        _ if values != points => Err(ReportError::Mesh { what: "number of values", found: values, points }),
        _ => Ok(()),
    }
}

/// The image at twice its size.
fn draw(
    scene: &Scene,
    view: FluidView,
    camera: &Camera,
    fluid_map: ColourMap,
    grain_range: (f64, f64),
    fluid_range: (f64, f64),
) -> Layer {
    let plane = scene.is_plane();
    let mut layer = Layer::new(camera.size, BACKGROUND);
    let grains: Vec<_> = scene.grains.iter().filter(|grain| grain.is_finite()).collect();
    let draw_grain = if plane { draw_disc } else { draw_sphere };
    for grain in &grains {
        draw_grain(&mut layer, camera, grain, ColourMap::Viridis.of(grain.value, grain_range));
    }
    if !plane && !grains.is_empty() {
        let mean = grains.iter().map(|grain| grain.radius).sum::<f64>() / grains.len() as f64;
        darken_crevices(&mut layer, (mean * camera.scale).max(2.0) as f32);
    }
    let Some(mesh) = &scene.mesh else { return layer };

    let faces = if mesh.tetrahedra.is_empty() { mesh.triangles.clone() } else { boundary_faces(mesh) };
    let mut veil = Layer::new(camera.size, BACKGROUND);
    let colour = |value: f64| fluid_map.of(value, fluid_range);
    if view == FluidView::Slice && !mesh.tetrahedra.is_empty() {
        let cuts = mesh.bounds().map_or(Vec::new(), |bounds| {
            let axis = Camera::slice_axis(&bounds);
            slice(mesh, axis, bounds.centre()[axis])
        });
        for cut in cuts {
            draw_triangle(&mut veil, cut.corners.map(|corner| camera.project(corner)), cut.values, colour);
        }
    } else {
        for &face in &faces {
            let nodes = face.map(|node| node as usize);
            let corners = nodes.map(|node| camera.project(mesh.points[node]));
            let values = nodes.map(|node| mesh.values[node]);
            if plane {
                draw_triangle(&mut veil, corners, values, colour);
            } else {
                let facing = camera.facing(normal(mesh, face));
                draw_triangle(&mut veil, corners, values, |value| lit_surface(colour(value), facing));
            }
        }
    }
    for [from, to] in sharp_edges(mesh, &faces) {
        let ends = [from, to].map(|node| camera.project(mesh.points[node as usize]));
        draw_line(&mut layer, ends[0], ends[1], 2.4, OUTLINE);
    }
    layer.cover(&veil, if plane || grains.is_empty() { 1.0 } else { VEIL });
    layer
}
