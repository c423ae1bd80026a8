//! The command: what is measured in turn, row by row.

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use clap::{Args, ValueEnum};
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::error::BenchError;
use super::instructions;
use super::memory::{bytes_per_grain, resident};
use super::scenes::BenchScene;
use super::settled::{Settled, cache};
use super::speed::time;
use super::table::{Columns, Row};
use super::traffic::bytes_per_step;
use crate::lanes::Backend;
use crate::peer::{Installed, Program, Task, write_deck};

/// From so many grains on, what grows with them is most of a process' memory.
const MANY: usize = 10_000;

/// Up to so many grains, instructions are counted in minutes.
const MOST_COUNTED: usize = 100_000;

/// Flags of `bench`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Scenes (default: all).
    #[arg(value_enum, value_name = "SCENE")]
    scenes: Vec<BenchScene>,
    /// Numbers of grains (default: what suits the scene).
    #[arg(long, value_name = "N", value_delimiter = ',')]
    grains: Vec<usize>,
    /// Lanes (default: the widest of this processor).
    #[arg(long, value_enum)]
    lanes: Option<Lanes>,
    /// Time runs on so many threads too.
    #[arg(long, default_value_t = 1, hide_default_value = true)]
    threads: usize,
    /// Programs to be timed in turn with this one, on one thread.
    #[arg(long, value_name = "PEER", value_enum, value_delimiter = ',')]
    against: Vec<Program>,
    /// Runs of each; the best and the median are told.
    #[arg(long, default_value_t = 3, value_name = "K")]
    runs: usize,
    /// The table as a file.
    #[arg(long, value_name = "FILE", default_value = "runs/bench.csv")]
    out: PathBuf,
    /// Count instructions per grain and step too, by valgrind (slow; up to 100000 grains; AVX2 at most).
    #[arg(long)]
    instructions: bool,
    /// Run so many steps of one scene, and nothing else.
    #[arg(long, hide = true, value_name = "K")]
    steps: Option<u32>,
    /// Tell the memory of this process on one scene, and nothing else.
    #[arg(long, hide = true)]
    resident: bool,
}

/// Lanes to be asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Lanes {
    /// Two numbers side by side, on any processor.
    Plain,
    /// Four.
    Avx2,
    /// Eight.
    Avx512,
    /// All that this processor has.
    All,
}

/// Measures; the exit code says whether it could.
pub fn run(arguments: &Arguments) -> ExitCode {
    let measured = match arguments.steps {
        Some(steps) => run_steps(arguments, steps),
        None if arguments.resident => tell_memory(arguments),
        None => measure(arguments),
    };
    measured.map_or_else(
        |error| {
            // Nothing can be done where not even this can be printed.
            let _ = writeln!(std::io::stderr(), "error: {error}");
            error.exit_code()
        },
        |()| ExitCode::Done,
    )
}

fn tell_memory(arguments: &Arguments) -> Result<(), BenchError> {
    for (&scene, &count) in arguments.scenes.iter().zip(&arguments.grains) {
        say(&resident(scene, count)?.to_string());
    }
    Ok(())
}

fn run_steps(arguments: &Arguments, steps: u32) -> Result<(), BenchError> {
    let backend = lanes(arguments.lanes)?[0];
    let one = threads(1)?;
    for (&scene, &count) in arguments.scenes.iter().zip(&arguments.grains) {
        one.install(|| instructions::run(scene, count, backend, steps))?;
    }
    Ok(())
}

fn measure(arguments: &Arguments) -> Result<(), BenchError> {
    let bench = Bench::new(arguments)?;
    let columns = Columns {
        threads: arguments.threads,
        peers: bench.peers.iter().map(|(program, _)| program.peer().name()).collect(),
    };
    let mut file = columns.csv_titles();
    // An unwritable file is told before the work is done.
    save(&arguments.out, &file)?;
    say(&format!(
        "million particle-steps per second of processor time, one thread; ratios by the wall; states in {}",
        cache().display()
    ));
    say(&columns.titles());
    let scenes = if arguments.scenes.is_empty() { BenchScene::value_variants() } else { &arguments.scenes };
    for &scene in scenes {
        let sizes = if arguments.grains.is_empty() { scene.sizes() } else { &arguments.grains };
        for &count in sizes {
            let (rows, refusals) = bench.rows(scene, count)?;
            for row in rows {
                say(&row.line());
                file += &row.csv_line();
            }
            refusals.iter().for_each(|refusal| say(refusal));
            save(&arguments.out, &file)?;
        }
    }
    say(&format!("table in {}", arguments.out.display()));
    Ok(())
}

/// Everything that is asked for and there.
struct Bench {
    lanes: Vec<Backend>,
    one: ThreadPool,
    several: Option<ThreadPool>,
    peers: Vec<(Program, Installed)>,
    runs: usize,
    counts: bool,
}

impl Bench {
    fn new(arguments: &Arguments) -> Result<Self, BenchError> {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let within = |flag, found: usize, least: usize, most: usize| {
            let allowed = format!("{least} to {most}");
            let fits = (least..=most).contains(&found);
            if fits { Ok(()) } else { Err(BenchError::OutOfRange { flag, found, allowed }) }
        };
        within("--threads", arguments.threads, 1, cores)?;
        within("--runs", arguments.runs, 1, 100)?;
        arguments.grains.iter().try_for_each(|&count| within("--grains", count, 100, 10_000_000))?;
        let find =
            |&program: &Program| Ok::<_, BenchError>((program, Installed::find(program.peer(), None)?));
        Ok(Self {
            lanes: lanes(arguments.lanes)?,
            one: threads(1)?,
            several: (arguments.threads > 1).then(|| threads(arguments.threads)).transpose()?,
            peers: arguments.against.iter().map(find).collect::<Result<_, _>>()?,
            runs: arguments.runs,
            counts: arguments.instructions,
        })
    }

    /// The rows of a scene, one for each of the lanes, and what peers cannot compute: all take turns.
    fn rows(&self, scene: BenchScene, count: usize) -> Result<(Vec<Row>, Vec<String>), BenchError> {
        let settled = Settled::new(scene, count)?;
        let (setup, steps) = (settled.set_up()?, scene.steps(count));
        let traffic = bytes_per_step(&setup)?;
        let row = |backend: &Backend| Row {
            scene: scene.word(),
            grains: count,
            steps,
            lanes: backend.name(),
            runs: vec![],
            threaded: self.several.as_ref().map(|_| vec![]),
            bytes_per_grain: None,
            traffic,
            instructions: None,
            peers: vec![],
        };
        let mut rows: Vec<Row> = self.lanes.iter().map(row).collect();
        let (mut decks, mut refusals) = (vec![], vec![]);
        for (program, _) in &self.peers {
            let deck = Task::new(&settled.case, |law| program.peer().computes_alike(law))
                .and_then(|task| Ok(program.peer().deck(&settled.case, &task, None)?));
            match deck {
                Ok(deck) => {
                    let folder = settled.folder.join(program.word());
                    write_deck(&folder, &deck)?;
                    decks.push(Some(folder));
                }
                Err(refusal) => {
                    refusals.push(refusal.to_string());
                    decks.push(None);
                }
            }
        }
        let mut of_peers: Vec<Option<Vec<f64>>> =
            decks.iter().map(|deck| deck.as_ref().map(|_| vec![])).collect();
        for _ in 0..self.runs {
            for (row, &backend) in rows.iter_mut().zip(&self.lanes) {
                row.runs.push(time(&setup, backend, &self.one, steps)?);
                if let (Some(pool), Some(runs)) = (&self.several, &mut row.threaded) {
                    runs.push(time(&setup, backend, pool, steps)?.wall);
                }
            }
            for (((_, installed), deck), runs) in self.peers.iter().zip(&decks).zip(&mut of_peers) {
                if let (Some(folder), Some(runs)) = (deck, runs) {
                    runs.push(installed.time(folder)?);
                }
            }
        }
        let bytes_per_grain = (count >= MANY).then(|| bytes_per_grain(scene, count)).transpose()?;
        for row in &mut rows {
            row.bytes_per_grain = bytes_per_grain;
            row.peers.clone_from(&of_peers);
            // Valgrind computes the lanes that it knows.
            let known = if row.lanes == "AVX-512" { "avx2".to_string() } else { row.lanes.to_lowercase() };
            let counts = self.counts && count <= MOST_COUNTED;
            row.instructions = counts.then(|| instructions::per_step(scene, count, &known)).transpose()?;
        }
        Ok((rows, refusals))
    }
}

fn threads(count: usize) -> Result<ThreadPool, BenchError> {
    ThreadPoolBuilder::new().num_threads(count).build().map_err(|error| {
        let allowed = format!("what the system grants ({error})");
        BenchError::OutOfRange { flag: "--threads", found: count, allowed }
    })
}

fn lanes(asked: Option<Lanes>) -> Result<Vec<Backend>, BenchError> {
    let available = Backend::available();
    let name = match asked {
        None => return Ok(vec![Backend::best()]),
        Some(Lanes::All) => return Ok(available),
        Some(Lanes::Plain) => "plain",
        Some(Lanes::Avx2) => "AVX2",
        Some(Lanes::Avx512) => "AVX-512",
    };
    match available.iter().find(|backend| backend.name() == name) {
        Some(&backend) => Ok(vec![backend]),
        None => {
            let names: Vec<&str> = available.iter().map(|backend| backend.name()).collect();
            Err(BenchError::NoLanes { wanted: name, available: names.join(", ") })
        }
    }
}

fn save(path: &std::path::Path, text: &str) -> Result<(), OutputError> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(OutputError::system("make", folder))?;
    }
    fs::write(path, text).map_err(OutputError::system("write", path))
}

/// A line on standard output; a closed pipe is the reader's business.
fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}
