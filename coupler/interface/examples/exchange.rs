//! How long two frames of 20,000 grains take between two processes over shared memory: the coupler writes `hydro`, the
//! other side reads it and writes `grains`, the coupler reads that.
//!
//! `cargo run --release -p interface --example exchange`

use interface::frames::{GrainRow, HydroRow};
use interface::message::{Command, Report, Usage};
use interface::run::RunId;
use interface::transport::{Deadlines, Stamp, shared_memory};
use std::error::Error;
use std::io::Write;
use std::time::Instant;

const GRAINS: usize = 20_000;
const ITERATIONS: u32 = 400;

fn main() -> Result<(), Box<dyn Error>> {
    match std::env::args().nth(1) {
        Some(run) => answer(&run),
        None => measure(),
    }
}

fn measure() -> Result<(), Box<dyn Error>> {
    let run = RunId::new();
    let mut ends = shared_memory::create(run, Deadlines::default())?;
    let mut child = std::process::Command::new(std::env::current_exe()?).arg(run.to_string()).spawn()?;
    while !ends.dem.has_joined() {
        std::thread::yield_now();
    }
    let mut seconds = Vec::new();
    for iteration in 1..=ITERATIONS {
        let start = Instant::now();
        let stamp = Stamp { window: 0, iteration, ..Stamp::default() };
        let row = |i: usize| HydroRow { exchange_coefficient: i as f64, ..HydroRow::default() };
        ends.hydro.write(stamp, GRAINS, row)?;
        ends.dem.ask(&Command::Advance { iteration })?;
        let grains = ends.grains.of(0, iteration)?;
        let sum: f64 = grains.iter().map(|grain| grain.mass).sum();
        assert_eq!(sum, (0..GRAINS).map(|i| i as f64).sum::<f64>());
        seconds.push(start.elapsed().as_secs_f64());
    }
    ends.dem.ask(&Command::Stop { reason: "measured".into() })?;
    child.wait()?;
    seconds.sort_by(f64::total_cmp);
    let at = |part: f64| 1e3 * seconds[(part * (seconds.len() - 1) as f64) as usize];
    writeln!(
        std::io::stdout(),
        "two frames of {GRAINS} grains, written, sent, read: median {:.3} ms, 90 % {:.3} ms",
        at(0.5),
        at(0.9)
    )?;
    Ok(())
}

fn answer(run: &str) -> Result<(), Box<dyn Error>> {
    let run = RunId::parse(run).ok_or("no run id")?;
    let mut ends = shared_memory::join_as_dem(run, Deadlines::default(), Box::new(|| std::process::exit(9)))?;
    loop {
        match ends.control.wait()? {
            Command::Advance { iteration } => {
                let hydro = ends.hydro.of(0, iteration)?;
                let stamp = Stamp { window: 0, iteration, ..Stamp::default() };
                let row = |i: usize| GrainRow { mass: hydro[i].exchange_coefficient, ..GrainRow::default() };
                ends.grains.write(stamp, hydro.len(), row)?;
                ends.control.answer(&Report::Restored)?;
            }
            _ => {
                ends.control.answer(&Report::Ended(Usage::default()))?;
                return Ok(());
            }
        }
    }
}
