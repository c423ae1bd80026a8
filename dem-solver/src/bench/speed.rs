//! The clocks of a run.

use std::fs;
use std::path::Path;
use std::time::Instant;

use case_io::output::OutputError;
use rayon::ThreadPool;

use super::error::BenchError;
use super::scenes::STEP;
use crate::lanes::Backend;
use crate::setup::Setup;
use crate::window::window;
use crate::workspace::Workspace;

/// What a run took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clocks {
    /// Time on the wall \[s\].
    pub wall: f64,
    /// Time that the first thread ran \[s\]: other programs on its core do not count.
    pub processor: f64,
}

/// Runs so many steps from the state on; the first lists are made before the clocks start.
///
/// # Errors
/// A fault of a step; a system that does not tell the time.
pub fn time(setup: &Setup<3>, backend: Backend, pool: &ThreadPool, steps: u32) -> Result<Clocks, BenchError> {
    let (mut world, mut workspace) = (setup.world.clone(), Workspace::on(backend));
    let mut go =
        |steps: u32| window(&setup.scene, &mut world, &mut workspace, None, f64::from(steps) * STEP, steps);
    pool.install(|| {
        go(2)?;
        let (start, processor) = (Instant::now(), processor_time()?);
        go(steps)?;
        Ok(Clocks { wall: start.elapsed().as_secs_f64(), processor: processor_time()? - processor })
    })
}

/// How long this thread has run \[s\].
fn processor_time() -> Result<f64, OutputError> {
    // Linux counts at its ticks, milliseconds apart, and where a thread may give way.
    std::thread::yield_now();
    let path = Path::new("/proc/thread-self/schedstat");
    let told = fs::read_to_string(path).map_err(OutputError::system("read", path))?;
    // Linux writes nanoseconds first, Documentation/scheduler/sched-stats.rst.
    let nanoseconds = told.split(' ').next().and_then(|word| word.parse::<f64>().ok());
    Ok(nanoseconds.unwrap_or(f64::NAN) * 1e-9)
}
