//! Pictures of a scene: an own z-buffer for grains and fluid, tiny-skia for lettering and PNG.

mod boundary;
mod bounds;
mod camera;
mod colour_bar;
mod colour_map;
mod layer;
mod lettering;
mod line;
mod render;
mod scene;
mod shading;
mod slice;
mod sphere;
mod triangle;
mod vector;

pub use bounds::Bounds;
pub use render::{PictureOptions, picture_of};
pub use scene::{FluidMesh, FluidView, Grain, Scene};
