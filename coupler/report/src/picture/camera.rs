//! An orthographic camera that frames a box by itself.

use super::Bounds;
use super::vector::{Vector, cross, dot, subtract, unit};

/// Looks straight at the plane, or at a scene in space slightly from the side and above; z is up in space, y in the
/// plane.
#[derive(Debug, Clone)]
pub(super) struct Camera {
    right: Vector,
    up: Vector,
    /// From the scene to the viewer.
    towards: Vector,
    centre: Vector,
    /// Pixels per metre.
    pub(super) scale: f64,
    /// Size of the image in pixels.
    pub(super) size: [usize; 2],
}

/// A place in the image: x to the right and y down in pixels, depth in pixels towards the viewer.
pub(super) type Pixel = [f64; 3];

const AZIMUTH: f64 = 0.42;
const ELEVATION: f64 = 0.30;

impl Camera {
    /// Frames `bounds` within `room` pixels, as large as fits, with a margin of `margin` pixels.
    pub(super) fn framing(bounds: &Bounds, plane: bool, room: [usize; 2], margin: f64) -> Self {
        let towards = if plane {
            [0.0, 0.0, 1.0]
        } else {
            let (sin, cos) = AZIMUTH.sin_cos();
            let tilt = ELEVATION.cos();
            // The longer horizontal side lies across the view.
            match Self::slice_axis(bounds) {
                1 => [sin * tilt, -cos * tilt, ELEVATION.sin()],
                _ => [cos * tilt, sin * tilt, ELEVATION.sin()],
            }
        };
        let vertical = if plane { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
        let right = unit(cross(vertical, towards));
        let up = cross(towards, right);

        let centre = bounds.centre();
        let reach = |axis: Vector| {
            let far = bounds.corners().map(|corner| dot(subtract(corner, centre), axis).abs());
            2.0 * far.into_iter().fold(0.0, f64::max)
        };
        let wanted = [reach(right), reach(up)];
        // A single point still gets a picture.
        let scale = (0..2)
            .map(|k| (room[k] as f64 - 2.0 * margin).max(1.0) / wanted[k])
            .filter(|scale| scale.is_finite())
            .fold(f64::INFINITY, f64::min);
        let scale = if scale.is_finite() { scale } else { 1.0 };
        let size =
            [0, 1].map(|k| ((wanted[k] * scale + 2.0 * margin).ceil() as usize).clamp(1, room[k].max(1)));
        Self { right, up, towards, centre, scale, size }
    }

    /// The horizontal axis of a cut that shows the longer side: 0 for x, 1 for y.
    pub(super) fn slice_axis(bounds: &Bounds) -> usize {
        let extent = bounds.extent();
        usize::from(extent[0] >= extent[1])
    }

    /// The direction of a normal in the frame of the image, turned to the viewer.
    pub(super) fn facing(&self, normal: Vector) -> Vector {
        let turned = unit([dot(normal, self.right), dot(normal, self.up), dot(normal, self.towards)]);
        if turned[2] < 0.0 { turned.map(|x| -x) } else { turned }
    }

    pub(super) fn project(&self, point: Vector) -> Pixel {
        let arm = subtract(point, self.centre);
        [
            0.5 * self.size[0] as f64 + self.scale * dot(arm, self.right),
            0.5 * self.size[1] as f64 - self.scale * dot(arm, self.up),
            self.scale * dot(arm, self.towards),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_box_fills_the_room_and_stays_inside_the_margin() {
        let bounds = Bounds { low: [-1.0, 2.0, 0.0], high: [4.0, 3.0, 9.0] };
        for plane in [true, false] {
            let camera = Camera::framing(&bounds, plane, [800, 600], 10.0);
            let pixels = bounds.corners().map(|corner| camera.project(corner));
            for k in 0..2 {
                let low = pixels.iter().map(|pixel| pixel[k]).fold(f64::INFINITY, f64::min);
                let high = pixels.iter().map(|pixel| pixel[k]).fold(0.0, f64::max);
                assert!(low > 9.0 && high < camera.size[k] as f64 - 9.0, "{plane} {low} {high}");
            }
            assert!(camera.size[0] == 800 || camera.size[1] == 600);
        }
    }

    #[test]
    fn a_point_and_a_sliver_still_make_a_picture() {
        for high in [[0.0; 3], [1e9, 1e-9, 0.0], [0.0, 0.0, 1e-300]] {
            let camera = Camera::framing(&Bounds { low: [0.0; 3], high }, false, [800, 600], 10.0);
            assert!(camera.size[0] > 0 && camera.size[1] > 0 && camera.project([0.0; 3])[0].is_finite());
        }
    }
}
