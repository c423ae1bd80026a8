//! The longest substep, and what sets it.

use std::fmt;

use crate::bond::Resistance;
use crate::bonded::links;
use crate::clumped::Members;
use crate::contact::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke, Normal, Onate};
use crate::contact::{Coefficients, ExtraConstants, NormalLaw};
use crate::engine::{Periods, Planes, extras_near, extras_of_pair, extras_on_wall};
use crate::error::DemError;
use crate::grains::{Motion, inertia};
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
    /// The stiffness and damping of the bonds of this grain, with its present contacts.
    Bonds(u64),
    /// The stiffness of the present contacts of the clump whose first member is this grain.
    Clump(u64),
    /// The speed of this grain.
    Speed(u64),
    /// The stiffness of the present contacts of this wall, which slides.
    Wall(String),
}

impl fmt::Display for Binding {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Nothing => write!(f, "nothing"),
            Self::Contact(grain) => write!(f, "the duration of a contact of grain {grain}"),
            Self::Stiffness(grain) => write!(f, "the stiffness of the contacts of grain {grain}"),
            Self::Bonds(grain) => write!(f, "the stiffness of the bonds of grain {grain}"),
            Self::Clump(grain) => write!(f, "the stiffness of the contacts of the clump of grain {grain}"),
            Self::Speed(grain) => write!(f, "the speed of grain {grain}"),
            Self::Wall(wall) => write!(f, "the stiffness of the contacts of the wall \"{wall}\""),
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

/// The critical step of the world as it is, the least of:
///
/// 1. the law's own resolution of a contact of each grain with its like, the sharpest it can have
///    ([`Normal::resolving_step`]);
/// 2. stability with the present contacts, Δt < 2/ω (√(1 + ζ²) - ζ), where by Gershgorin's circles
///    ω² ≤ max_i Σ_c 2 k_c/m_i over grains and walls that slide, and Σ_c k_c/m_i over other walls, k_c the larger of
///    normal slope and (1 + m r²/I) k_t + k_r m/I; i are grains and walls that slide;
/// 3. a flight of a tenth of the radius;
/// 4. for bonded grains, A Δt² + 2 B Δt = 4 m with A = Σ_c 2 k_c and B = 2 ζ √(A m) of the contacts, and what bonds add to
///    both ([`Resistance`]).
///
/// Where a member of a clump is pushed, 1/m is how far the clump gives way there ([`Mobility`](crate::body::Mobility)), and a
/// clump feels the contacts of all its members.
///
/// Source: Belytschko, Liu & Moran, Nonlinear Finite Elements (2000), section 6.2 for the damped limit;
/// Otsubo, O'Sullivan & Shire, Comput. Geotech. 86 (2017) 170–182 for many contacts.
pub fn critical_time_step<const D: usize>(scene: &Scene<D>, world: &World<D>) -> CriticalStep {
    match scene.normal_law {
        NormalLaw::None => of_bonds(scene, world, &vec![0.0; world.grains.len()]),
        NormalLaw::Hooke(law) => by_law::<D, Hooke>(scene, world, &law),
        NormalLaw::Hertz(law) | NormalLaw::HertzPartialSlip(law) => by_law::<D, Hertz>(scene, world, &law),
        NormalLaw::Onate(law) => by_law::<D, Onate>(scene, world, &law),
        NormalLaw::LiggghtsHooke(law) => by_law::<D, LiggghtsHooke>(scene, world, &law),
        NormalLaw::LiggghtsHertz(law) => by_law::<D, LiggghtsHertz>(scene, world, &law),
    }
}

fn by_law<const D: usize, N: Normal<D>>(scene: &Scene<D>, world: &World<D>, law: &N) -> CriticalStep {
    let grains = &world.grains;
    let (of_grains, of_walls) = stiffness::<D, N>(scene, world);
    let mut critical = of_bonds(scene, world, &of_grains);
    let mut bound = |step: f64, binding: Binding| {
        if step < critical.step {
            critical = CriticalStep { step, binding };
        }
    };
    let damping = scene.materials.largest_damping_ratio();
    let damped_by = |damping: f64| (1.0 + damping * damping).sqrt() - damping;
    let damped = damped_by(damping);
    for (wall, servo) in scene.walls.servos.iter().enumerate() {
        if let Some(servo) = servo {
            let step = 2.0 * damped / (of_walls[wall] / servo.mass).sqrt();
            bound(step, Binding::Wall(scene.walls.names[wall].clone()));
        }
    }
    let members = Members::tie(&world.bodies, grains);
    // 1/m where a normal force pushes, times the mass that the contact's constants count with.
    let mut eased = vec![1.0; grains.len()];
    for (clump, rows) in members.of_each(&world.bodies) {
        let (mass, mut square, mut most_eased) = (clump.shape.mass(), 0.0, 1.0_f64);
        for (&row, mobility) in rows.iter().zip(clump.shape.mobilities()) {
            eased[row as usize] = mobility.normal * mass;
            square += of_grains[row as usize] * mobility.any;
            most_eased = most_eased.max(mobility.any * mass);
        }
        bound(2.0 * damped_by(damping * most_eased.sqrt()) / square.sqrt(), Binding::Clump(clump.first));
    }
    for (row, stiffness) in of_grains.into_iter().enumerate() {
        let (motion, radius, material) =
            (&grains.motion[row], grains.place[row].radius, grains.material[row]);
        if motion.is_frozen() {
            continue;
        }
        let (id, poissons_ratio) = (grains.id[row], scene.materials.get(material).poissons_ratio);
        for other in 0..scene.materials.len() as u32 {
            let pair = scene.materials.pair(material, other);
            let step = law.resolving_step(pair, poissons_ratio, grains.mass[row], radius);
            bound(step / eased[row].sqrt(), Binding::Contact(id));
        }
        if motion.is_loose() {
            bound(2.0 * damped / (stiffness * motion.inverse_mass).sqrt(), Binding::Stiffness(id));
        }
        bound(LARGEST_FLIGHT * radius / motion.velocity.norm(), Binding::Speed(id));
    }
    critical
}

/// The bound of bonded grains whose contacts have these row sums \[N/m\].
fn of_bonds<const D: usize>(scene: &Scene<D>, world: &World<D>, of_contacts: &[f64]) -> CriticalStep {
    let mut critical = CriticalStep { step: f64::INFINITY, binding: Binding::Nothing };
    // A bond without its grain is refused when the window opens.
    let Ok(links) = links(scene, world) else { return critical };
    let damping = scene.materials.largest_damping_ratio();
    for row in links.bonded_rows() {
        let Motion { inverse_mass, inverse_inertia, .. } = world.grains.motion[row];
        if inverse_mass > 0.0 {
            let contacts = Resistance {
                stiffness: of_contacts[row],
                damping: 2.0 * damping * (of_contacts[row] / inverse_mass).sqrt(),
            };
            let all = contacts + links.resistance(row, inverse_inertia / inverse_mass);
            let step = all.critical_step(inverse_mass);
            if step < critical.step {
                critical = CriticalStep { step, binding: Binding::Bonds(world.grains.id[row]) };
            }
        }
    }
    critical
}

/// Gershgorin's row sums of the stiffness matrix \[N/m\], of grains and of walls.
fn stiffness<const D: usize, N: Normal<D>>(scene: &Scene<D>, world: &World<D>) -> (Vec<f64>, Vec<f64>) {
    let place = &world.grains.place;
    // m r²/I.
    let turning = 1.0 / inertia::<D>(1.0, 1.0);
    let rubs = scene.materials.rub();
    // k_r/r², at most, since R* ≤ r.
    let against_rolling = |coefficients: &Coefficients| {
        let law = scene.extras.rolling.iter();
        let all = law.flat_map(|law| scene.materials.pairs().iter().map(|pair| (*law, pair)));
        all.map(|(law, pair)| law.constants(coefficients, pair, 1.0, 0.0).stiffness).fold(0.0, f64::max)
    };
    // Attraction presses bodies flat: they are as stiff as without it in a contact as wide.
    let of_contact = |coefficients: &Coefficients, constants: &ExtraConstants, overlap: f64| {
        let overlap = scene.extras.indentation(constants, overlap);
        let slope = N::slope(coefficients, overlap);
        if !rubs {
            return slope;
        }
        let rubbing =
            (1.0 + turning) * coefficients.tangential_stiffness + turning * against_rolling(coefficients);
        slope.max(rubbing * N::growth(overlap).stiffness)
    };
    let (walls, planes) = (world.wall_poses(scene), Planes::of(scene));
    let periods = Periods::new(&scene.domain);
    let mut sums = vec![0.0; place.len()];
    let mut of_walls = vec![0.0; scene.walls.len()];
    let alike = world.contacts.alike.as_ref();
    for chunk in &world.contacts.chunks {
        for (i, j, coefficients) in chunk.inner.pairs(alike) {
            let overlap = periods.overlap(&place[i], &place[j]);
            if overlap > 0.0 {
                let constants = extras_of_pair(scene, &world.grains, (i, j), &coefficients);
                let stiffness = of_contact(&coefficients, &constants, overlap);
                sums[i] += 2.0 * stiffness;
                sums[j] += 2.0 * stiffness;
            }
        }
        for (grain, plane, coefficients) in chunk.planes.contacts() {
            let overlap = planes.overlap(plane, &place[grain]);
            if overlap > 0.0 {
                let material = scene.walls.materials[planes.wall[plane] as usize];
                let constants = extras_on_wall(scene, &world.grains, grain, material, &coefficients);
                sums[grain] += of_contact(&coefficients, &constants, overlap);
            }
        }
        for candidate in &chunk.candidates {
            let grain = &place[candidate.grain as usize];
            let centre = grain.at() - scene.shifts[candidate.image.0 as usize];
            let overlap = grain.radius - scene.walls.nearest(candidate.surface, &centre, &walls).distance;
            if overlap > 0.0 {
                let constants = extras_near(scene, &world.grains, candidate).unwrap_or_default();
                let stiffness = of_contact(&candidate.coefficients, &constants, overlap);
                let wall = scene.walls.surfaces[candidate.surface as usize].wall as usize;
                let gives_way = scene.walls.servos[wall].is_some();
                sums[candidate.grain as usize] += if gives_way { 2.0 * stiffness } else { stiffness };
                of_walls[wall] += 2.0 * stiffness;
            }
        }
    }
    (sums, of_walls)
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
