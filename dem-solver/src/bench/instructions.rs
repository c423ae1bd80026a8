//! Instructions per particle-step, as valgrind counts them. It knows no AVX-512: the lanes are those of AVX2 at most.

use std::path::Path;
use std::process::{Command, Stdio};

use case_io::output::OutputError;

use super::error::BenchError;
use super::scenes::{BenchScene, STEP};
use super::settled::Settled;
use crate::lanes::Backend;
use crate::setup::Setup;
use crate::window::window;
use crate::workspace::Workspace;

/// Steps of the two runs whose difference counts: what comes before the first step drops out, and inner lists are made
/// as often as they are.
const STEPS: [u32; 2] = [10, 50];

/// Instructions per grain and step of a scene of so many grains on these lanes.
///
/// # Errors
/// A state that cannot be made; valgrind that is missing or fails.
pub fn per_step(scene: BenchScene, count: usize, lanes: &str) -> Result<f64, BenchError> {
    // The processes that are counted find it made.
    drop(Settled::new(scene, count)?);
    let [few, many] = STEPS;
    let more = of_process(scene, count, lanes, many)? - of_process(scene, count, lanes, few)?;
    Ok(more / (f64::from(many - few) * count as f64))
}

fn of_process(scene: BenchScene, count: usize, lanes: &str, steps: u32) -> Result<f64, BenchError> {
    let program =
        std::env::current_exe().map_err(OutputError::system("find", Path::new("/proc/self/exe")))?;
    let mut command = Command::new("valgrind");
    command.args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]).arg(program);
    command.args(["bench", scene.word(), "--grains", &count.to_string(), "--lanes", lanes]);
    let answer = command.args(["--steps", &steps.to_string()]).stdin(Stdio::null()).output();
    let answer = answer.map_err(|source| BenchError::NoCounter { told: source.to_string() })?;
    let told = String::from_utf8_lossy(&answer.stderr);
    // "==123== I   refs:      1,234,567"
    let number = told.rsplit_once("refs:").and_then(|(_, rest)| rest.lines().next());
    let number = number.filter(|_| answer.status.success()).map(|text| text.trim().replace(',', ""));
    let failed = || BenchError::NoCounter { told: told.lines().last().unwrap_or_default().to_string() };
    number.and_then(|digits| digits.parse().ok()).ok_or_else(failed)
}

/// Runs so many steps of a scene, and does nothing else.
///
/// # Errors
/// A scene that cannot be computed.
pub fn run(scene: BenchScene, count: usize, lanes: Backend, steps: u32) -> Result<(), BenchError> {
    let Setup { scene, mut world, .. } = Settled::new(scene, count)?.set_up()?;
    let mut workspace = Workspace::on(lanes);
    window(&scene, &mut world, &mut workspace, None, f64::from(steps) * STEP, steps)?;
    Ok(())
}
