//! The longest substep, and what sets it.

use std::fmt;

use crate::contact::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke, Normal};
use crate::contact::{Chunk, Coefficients, NormalLaw};
use crate::error::DemError;
use crate::grains::inertia;
use crate::scene::Scene;
use crate::world::World;

/// No grain flies further than this fraction of its radius in a critical step.
const LARGEST_FLIGHT: f64 = 0.1;

/// A window of more substeps than this is refused.
pub const MOST_SUBSTEPS: u32 = 1_000_000;

/// What sets the critical step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Binding {
    /// Nothing: no grain can touch.
    Nothing,
    /// The duration of a contact of this grain.
    Contact(u64),
    /// The stiffness of the present contacts of this grain.
    Stiffness(u64),
    /// The speed of this grain.
    Speed(u64),
}

impl fmt::Display for Binding {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Nothing => write!(f, "nothing"),
            Self::Contact(grain) => write!(f, "the duration of a contact of grain {grain}"),
            Self::Stiffness(grain) => write!(f, "the stiffness of the contacts of grain {grain}"),
            Self::Speed(grain) => write!(f, "the speed of grain {grain}"),
        }
    }
}

/// A bound on the substep.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalStep {
    /// The bound \[s\]; infinite where nothing sets one.
    pub step: f64,
    /// What sets it.
    pub binding: Binding,
}

/// How a case asks for its substep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Substep {
    /// This long at most \[s\].
    Given(f64),
    /// This fraction of the critical step.
    Fraction(f64),
}

/// The critical step of the world as it is, the least of three:
///
/// 1. the law's own resolution of a contact of each grain with its like, the sharpest it can have
///    ([`Normal::resolving_step`]);
/// 2. stability with the present contacts, Δt < 2/ω (√(1 + ζ²) - ζ), where by Gershgorin's circles
///    ω² ≤ max_i Σ_c 2 k_c/m_i over grains and Σ_c k_c/m_i over walls, k_c the larger of normal slope and
///    (1 + m r²/I) k_t;
/// 3. a flight of a tenth of the radius.
///
/// Source: Belytschko, Liu & Moran, Nonlinear Finite Elements (2000), section 6.2 for the damped limit;
/// Otsubo, O'Sullivan & Shire, Comput. Geotech. 86 (2017) 170–182 for many contacts.
pub fn critical_time_step<const D: usize>(scene: &Scene<D>, world: &World<D>) -> CriticalStep {
    match scene.normal_law {
        NormalLaw::None => CriticalStep { step: f64::INFINITY, binding: Binding::Nothing },
        NormalLaw::Hooke(law) => by_law::<D, Hooke>(scene, world, &law),
        NormalLaw::Hertz(law) => by_law::<D, Hertz>(scene, world, &law),
        NormalLaw::LiggghtsHooke(law) => by_law::<D, LiggghtsHooke>(scene, world, &law),
        NormalLaw::LiggghtsHertz(law) => by_law::<D, LiggghtsHertz>(scene, world, &law),
    }
}

fn by_law<const D: usize, N: Normal<D>>(scene: &Scene<D>, world: &World<D>, law: &N) -> CriticalStep {
    let grains = &world.grains;
    let mut critical = CriticalStep { step: f64::INFINITY, binding: Binding::Nothing };
    let mut bound = |step: f64, binding: Binding| {
        if step < critical.step {
            critical = CriticalStep { step, binding };
        }
    };
    let damping = scene.materials.largest_damping_ratio();
    let damped = (1.0 + damping * damping).sqrt() - damping;
    for (row, stiffness) in stiffness::<D, N>(scene, world).into_iter().enumerate() {
        let (motion, radius, material) =
            (&grains.motion[row], grains.place[row].radius, grains.material[row]);
        if motion.is_frozen() {
            continue;
        }
        let (id, poissons_ratio) = (grains.id[row], scene.materials.get(material).poissons_ratio);
        for other in 0..scene.materials.len() as u32 {
            let pair = scene.materials.pair(material, other);
            bound(law.resolving_step(pair, poissons_ratio, grains.mass[row], radius), Binding::Contact(id));
        }
        bound(2.0 * damped / (stiffness * motion.inverse_mass).sqrt(), Binding::Stiffness(id));
        bound(LARGEST_FLIGHT * radius / motion.velocity.norm(), Binding::Speed(id));
    }
    critical
}

/// Gershgorin's row sums of the stiffness matrix \[N/m\].
fn stiffness<const D: usize, N: Normal<D>>(scene: &Scene<D>, world: &World<D>) -> Vec<f64> {
    let place = &world.grains.place;
    let rolling = 1.0 + 1.0 / inertia::<D>(1.0, 1.0);
    let rubs = scene.materials.rub();
    let of_contact = |coefficients: &Coefficients, overlap: f64| {
        let tangential = coefficients.tangential_stiffness * N::growth(overlap).stiffness;
        N::slope(coefficients, overlap).max(if rubs { rolling * tangential } else { 0.0 })
    };
    let walls = scene.walls.poses(world.time);
    let mut sums = vec![0.0; place.len()];
    for Chunk { pairs, coefficients, candidates, .. } in &world.contacts.chunks {
        for (pair, coefficients) in pairs.iter().zip(coefficients) {
            let (a, b) = (&place[pair.i as usize], &place[pair.j as usize]);
            let distance = (b.centre + scene.shifts[pair.image.0 as usize] - a.centre).norm();
            let overlap = a.radius + b.radius - distance;
            if overlap > 0.0 {
                let stiffness = of_contact(coefficients, overlap);
                sums[pair.i as usize] += 2.0 * stiffness;
                sums[pair.j as usize] += 2.0 * stiffness;
            }
        }
        for candidate in candidates {
            let grain = &place[candidate.grain as usize];
            let centre = grain.centre - scene.shifts[candidate.image.0 as usize];
            let overlap = grain.radius - scene.walls.nearest(candidate.surface, &centre, &walls).distance;
            if overlap > 0.0 {
                sums[candidate.grain as usize] += of_contact(&candidate.coefficients, overlap);
            }
        }
    }
    sums
}

/// Number of equal substeps of a window \[s\].
///
/// # Errors
/// A stated substep above the critical one; more than [`MOST_SUBSTEPS`] substeps; a window that is no time.
pub fn substeps(window: f64, wish: Substep, critical: &CriticalStep) -> Result<u32, DemError> {
    let step = match wish {
        Substep::Given(step) => step,
        Substep::Fraction(fraction) => fraction * critical.step,
    };
    if !(window > 0.0 && window.is_finite() && step > 0.0) {
        return Err(DemError::BadWindow { window, substeps: 0 });
    }
    let binding = critical.binding.to_string();
    if step > critical.step {
        return Err(DemError::StepTooLarge { step, limit: critical.step, binding });
    }
    // A window that is a whole number of steps up to rounding is not given one more.
    let count = (window / step * (1.0 - 1e-12)).ceil().max(1.0);
    if count > f64::from(MOST_SUBSTEPS) {
        return Err(DemError::TooManySubsteps { window, step, count, most: MOST_SUBSTEPS, binding });
    }
    Ok(count as u32)
}
