//! States, made once and kept: each is a case of its own in a folder of the temporary directory.

use std::fmt::Write;
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

use case_io::document::{Case, Overrides};
use case_io::output::OutputError;

use super::error::BenchError;
use super::scenes::{BenchScene, DILATION, GRAINS, SEED, STEP, Settling};
use crate::grains::Grain;
use crate::insertion::read_grains;
use crate::peer::{File, write_deck};
use crate::setup::{Setup, set_up};
use crate::vector::Vector;
use crate::window::window;
use crate::workspace::Workspace;
use crate::world::World;

/// Root mean square of the speeds of grains at rest \[m/s\].
const REST: f64 = 5e-3;
/// Grains that are not at rest by then are not told as settled \[s\].
const PATIENCE: f64 = 2.0;
/// Steps between two looks.
const LOOK: u32 = 1000;

/// A scene in its state, as a case.
pub struct Settled {
    /// The case.
    pub case: Case,
    /// Its folder.
    pub folder: PathBuf,
}

/// The folder of all states; it is this user's.
pub fn cache() -> PathBuf {
    let user = fs::metadata("/proc/self").map_or(0, |process| process.uid());
    std::env::temp_dir().join(format!("silt-bench-{user}"))
}

impl Settled {
    /// The state of a scene of so many grains: the kept one, or else it is made.
    ///
    /// # Errors
    /// A state that cannot be computed or kept.
    pub fn new(scene: BenchScene, count: usize) -> Result<Self, BenchError> {
        let name = format!("{}-{count}-seed-{SEED}", scene.word());
        let folder = cache().join(&name);
        if !folder.join(GRAINS).exists() {
            let grains = settle(scene, count, &cache().join(format!("{name}.{}", std::process::id())))?;
            // Complete or not there.
            let unfinished = folder.join(format!("{}.{GRAINS}", std::process::id()));
            write_deck(&folder, &[File::new(format!("{}.{GRAINS}", std::process::id()), table(&grains))])?;
            fs::rename(&unfinished, folder.join(GRAINS))
                .map_err(OutputError::system("rename", &unfinished))?;
        }
        write_deck(&folder, &scene.case(count, scene.width(count)))?;
        Ok(Self { case: Case::load_run(&folder, &Overrides::default(), None)?, folder })
    }

    /// Scene and world.
    ///
    /// # Errors
    /// Those of any case.
    pub fn set_up(&self) -> Result<Setup<3>, BenchError> {
        Ok(set_up::<3>(&self.case, None)?)
    }
}

/// The grains of a scene in the state to measure; `folder` is for the meantime.
fn settle(scene: BenchScene, count: usize, folder: &Path) -> Result<Vec<Grain<3>>, BenchError> {
    if scene == BenchScene::Loose {
        return Ok(thrown(&Settled::new(BenchScene::Dense, count)?.folder)?);
    }
    let (width, towers) = (scene.width(count), scene.towers(count));
    if towers == 1 {
        return come_to_rest(scene, scene.start(count, width), width, folder);
    }
    let (side, each) = (width / towers as f64, count.div_ceil(towers * towers));
    let tower = come_to_rest(scene, scene.start(each, side), side, folder)?;
    come_to_rest(scene, side_by_side(&tower, towers, side, count), width, folder)
}

/// So many copies of a tower of this side \[m\] along x and y, without the topmost grains beyond `count`. Grains that touched
/// its walls touch each other at most.
fn side_by_side(tower: &[Grain<3>], towers: usize, side: f64, count: usize) -> Vec<Grain<3>> {
    let places = (0..towers * towers).map(|k| [k % towers, k / towers].map(|place| place as f64 * side));
    let copies = places.flat_map(|[x, y]| {
        let shift = Vector::from([x, y, 0.0]);
        tower.iter().map(move |grain| Grain { centre: grain.centre + shift, ..*grain })
    });
    let mut grains: Vec<_> = copies.collect();
    grains.sort_by(|a, b| a.centre.z.total_cmp(&b.centre.z));
    grains.truncate(count);
    grains
}

/// The grains of a scene in a box of this side \[m\] in the state to measure.
fn come_to_rest(
    scene: BenchScene,
    start: Vec<Grain<3>>,
    width: f64,
    folder: &Path,
) -> Result<Vec<Grain<3>>, BenchError> {
    if scene.settling() == Settling::Never {
        return Ok(start);
    }
    write_deck(folder, &scene.case(start.len(), width))?;
    write_deck(folder, &[File::new(GRAINS, table(&start))])?;
    let case = Case::load_run(folder, &Overrides::default(), None)?;
    let Setup { scene: surroundings, mut world, .. } = set_up::<3>(&case, None)?;
    fs::remove_dir_all(folder).map_err(OutputError::system("remove", folder))?;
    let mut workspace = Workspace::new();
    loop {
        let duration = f64::from(LOOK) * STEP;
        window(&surroundings, &mut world, &mut workspace, None, duration, LOOK)?;
        let speed = root_mean_square_speed(&world);
        let is_settled = match scene.settling() {
            Settling::For(seconds) => world.time > seconds - 0.5 * STEP,
            _ => speed < REST,
        };
        if is_settled {
            return Ok(grains(&world));
        }
        if world.time > PATIENCE {
            let folder = folder.to_path_buf();
            return Err(BenchError::Restless { folder, seconds: PATIENCE, speed, allowed: REST });
        }
    }
}

/// The settled bed dilated and thrown down at 0.5 m/s.
fn thrown(dense: &Path) -> Result<Vec<Grain<3>>, crate::error::DemError> {
    let grains = read_grains(&dense.join(GRAINS))?.into_iter();
    let dilated = grains.map(|grain| {
        let radius = grain.radius.unwrap_or_default();
        Grain::at(grain.centre.map(|x| DILATION * x), radius).moving([0.0, 0.0, -0.5])
    });
    Ok(dilated.collect())
}

fn root_mean_square_speed(world: &World<3>) -> f64 {
    let squares: f64 = world.grains.motion.iter().map(|motion| motion.velocity.norm_squared()).sum();
    (squares / world.grains.len() as f64).sqrt()
}

fn grains(world: &World<3>) -> Vec<Grain<3>> {
    let rows = world.grains.place.iter().zip(&world.grains.motion);
    let grain = |(place, motion): (&crate::Place, &crate::Motion)| {
        Grain::at(place.centre.into(), place.radius)
            .moving(motion.velocity.into())
            .spinning(motion.angular_velocity.into())
    };
    rows.map(grain).collect()
}

/// The text of the file of grains, to the last bit.
fn table(grains: &[Grain<3>]) -> String {
    let mut text =
        String::from("x[m],y[m],z[m],vx[m/s],vy[m/s],vz[m/s],wx[rad/s],wy[rad/s],wz[rad/s],diameter[m]\n");
    for Grain { centre, velocity, angular_velocity, radius, .. } in grains {
        let numbers = [centre, velocity, angular_velocity].into_iter().flat_map(Vector::iter);
        for number in numbers {
            // Writing to a string cannot fail.
            let _ = write!(text, "{number},");
        }
        let _ = writeln!(text, "{}", 2.0 * radius);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn towers_that_fill_their_walls_stand_side_by_side_without_overlap() {
        let corner = |x: f64, y: f64, z: f64| Grain::at([x, y, z], 1e-3);
        let tower: Vec<_> =
            [1e-3, 3e-3].into_iter().flat_map(|z| [corner(1e-3, 1e-3, z), corner(3e-3, 3e-3, z)]).collect();
        let all = side_by_side(&tower, 3, 4e-3, 30);
        assert_eq!(all.len(), 30);
        assert!(all.iter().filter(|grain| grain.centre.z < 2e-3).count() == 18, "the topmost are left out");
        for (k, one) in all.iter().enumerate() {
            assert!(one.centre.x < 12e-3 && one.centre.y < 12e-3);
            assert!(all[k + 1..].iter().all(|other| (other.centre - one.centre).norm() > 1.999e-3));
        }
    }
}
