//! Walls that slide under a stated force.

use super::Walls;
use super::impulse::WallImpulse;
use crate::vector::Vector;

/// A wall that slides along a direction n under a stated force: M dv/dt = F + f·n, |v| ≤ v_max, f the force of the
/// grains on it. At rest they hold F. It comes on top of the wall's prescribed motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Servo<const D: usize> {
    /// Unit vector n along which it pushes.
    pub direction: Vector<D>,
    /// Force F \[N\].
    pub force: f64,
    /// Mass M \[kg\].
    pub mass: f64,
    /// Largest speed v_max \[m/s\].
    pub largest_speed: f64,
}

/// How far a wall has slid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Slide {
    /// Displacement along its direction since t = 0 \[m\].
    pub displacement: f64,
    /// Velocity along its direction \[m/s\].
    pub velocity: f64,
    /// Displacement when the neighbour list was built \[m\].
    pub listed: f64,
}

impl<const D: usize> Servo<D> {
    /// What the impulse of the grains \[N s\] and the stated force make of the velocity in a substep \[s\].
    fn kick(&self, slide: &mut Slide, impulse: &Vector<D>, step: f64) {
        let velocity = slide.velocity + (self.force * step + impulse.dot(&self.direction)) / self.mass;
        slide.velocity = velocity.clamp(-self.largest_speed, self.largest_speed);
    }
}

impl<const D: usize> Walls<D> {
    /// Whether a wall slides.
    pub fn slide(&self) -> bool {
        self.servos.iter().any(Option::is_some)
    }

    /// Gives sliding walls the momentum of one substep \[s\] of position Verlet, as grains get it; `received` is what each
    /// wall received of grains in it \[N s\].
    pub fn kick(&self, slides: &mut [Slide], received: &[WallImpulse<D>], step: f64) {
        for ((servo, slide), impulse) in self.servos.iter().zip(slides).zip(received) {
            if let Some(servo) = servo {
                servo.kick(slide, &impulse.linear, step);
            }
        }
    }
}

/// Slides all walls on for `time` \[s\].
pub fn drift(slides: &mut [Slide], time: f64) {
    slides.iter_mut().for_each(|slide| slide.displacement += slide.velocity * time);
}
