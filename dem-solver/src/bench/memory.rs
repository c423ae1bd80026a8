//! Memory per grain: how much more a process keeps for N grains than for N/4, lists and contact memory included.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use case_io::output::OutputError;

use super::error::BenchError;
use super::scenes::{BenchScene, STEP};
use super::settled::Settled;
use crate::setup::Setup;
use crate::window::window;
use crate::workspace::Workspace;

/// Steps before memory is told.
const STEPS: u32 = 20;

/// Bytes per grain of a scene of so many grains: of two processes of this program, so that nothing else counts.
///
/// # Errors
/// A state that cannot be made; a process that fails.
pub fn bytes_per_grain(scene: BenchScene, count: usize) -> Result<f64, BenchError> {
    let fewer = count / 4;
    let growth = of_process(scene, count)? - of_process(scene, fewer)?;
    Ok(growth / (count - fewer) as f64)
}

fn of_process(scene: BenchScene, count: usize) -> Result<f64, BenchError> {
    let folder = Settled::new(scene, count)?.folder;
    let program =
        std::env::current_exe().map_err(OutputError::system("find", Path::new("/proc/self/exe")))?;
    let mut command = Command::new(&program);
    command.args(["bench", scene.word(), "--grains", &count.to_string(), "--resident"]);
    // With a fixed threshold the allocator gives back what setting up does not need any more.
    command.env("MALLOC_MMAP_THRESHOLD_", "131072").stdin(Stdio::null());
    let answer = command.output().map_err(OutputError::system("run", &program))?;
    let told = String::from_utf8_lossy(&answer.stdout);
    let said = || String::from_utf8_lossy(&answer.stderr).trim().to_string();
    told.trim().parse().map_err(|_| BenchError::NoMemory { folder, told: said() })
}

/// Memory of this process while it computes a scene \[B\].
///
/// # Errors
/// A scene that cannot be computed; a system that does not tell.
pub fn resident(scene: BenchScene, count: usize) -> Result<f64, BenchError> {
    let Setup { scene, mut world, .. } = Settled::new(scene, count)?.set_up()?;
    let mut workspace = Workspace::new();
    window(&scene, &mut world, &mut workspace, None, f64::from(STEPS) * STEP, STEPS)?;
    let path = Path::new("/proc/self/status");
    let told = fs::read_to_string(path).map_err(OutputError::system("read", path))?;
    let kilobytes = told.lines().find_map(|line| line.strip_prefix("VmRSS:")?.trim().strip_suffix(" kB"));
    Ok(1024.0 * kilobytes.and_then(|number| number.parse().ok()).unwrap_or(f64::NAN))
}
