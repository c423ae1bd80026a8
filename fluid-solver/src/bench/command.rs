//! The command: every scene, backend, mesh and step in turn.

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use case_io::document::Backend;
use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use clap::{Args, ValueEnum};
use rayon::ThreadPoolBuilder;
use report::{Amount, WorkPrecision};

use super::error::BenchError;
use super::measure::{Measured, measure};
use super::scene::BenchScene;
use super::table::{CSV_TITLES, Line, TITLES};

/// Windows in parts of those of a scene.
const REFINEMENTS: [usize; 3] = [1, 2, 4];

/// Flags of `bench`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Scenes (default: all).
    #[arg(value_enum, value_name = "SCENE")]
    scenes: Vec<BenchScene>,
    /// Backends (default: all that compute the scene).
    #[arg(long, value_enum, value_name = "BACKEND", value_delimiter = ',')]
    backend: Vec<Computed>,
    /// Cells along the shorter side of the meshes.
    #[arg(long, value_name = "N", value_delimiter = ',', default_values_t = [16, 32, 64])]
    cells: Vec<usize>,
    /// Threads.
    #[arg(long, default_value_t = 1)]
    threads: usize,
    /// Folder of the report, the table and the cases.
    #[arg(long, value_name = "DIR", default_value = "runs/fluid-bench")]
    out: PathBuf,
}

/// Backends that solve equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Computed {
    /// Fixed mesh.
    Eulerian,
    /// Mesh that moves with the fluid.
    Pfem,
}

impl Computed {
    fn backend(self) -> (Backend, &'static str) {
        match self {
            Self::Eulerian => (Backend::Eulerian, "eulerian"),
            Self::Pfem => (Backend::Pfem, "pfem"),
        }
    }
}

/// Measures; the exit code says whether it could.
pub fn run(arguments: &Arguments) -> ExitCode {
    measure_all(arguments).map_or_else(
        |error| {
            // Nothing can be done where not even this can be printed.
            let _ = writeln!(std::io::stderr(), "error: {error}");
            error.exit_code()
        },
        |()| ExitCode::Done,
    )
}

fn measure_all(arguments: &Arguments) -> Result<(), BenchError> {
    let Arguments { scenes, backend, cells, threads, out } = arguments;
    let refuse = |flag, found, allowed| Err(BenchError::OutOfRange { flag, found, allowed });
    if let Some(&found) = cells.iter().find(|&&cells| !(4..=2000).contains(&cells)) {
        return refuse("--cells", found, "4 to 2000");
    }
    let pool = match ThreadPoolBuilder::new().num_threads(*threads).build() {
        Ok(pool) if *threads > 0 => pool,
        _ => return refuse("--threads", *threads, "1 or more, as many as the system grants"),
    };
    let scenes = if scenes.is_empty() { BenchScene::value_variants() } else { scenes };
    let backends = if backend.is_empty() { Computed::value_variants() } else { backend };
    let (mut table, mut plots) = (CSV_TITLES.to_string(), Vec::new());
    say(TITLES);
    for &scene in scenes {
        let mut curves = Vec::new();
        for (backend, word) in backends.iter().map(|&computed| computed.backend()) {
            if !scene.scene().suits(backend) {
                continue;
            }
            for &cells in cells {
                let mut runs: Vec<Measured> = Vec::new();
                for windows in REFINEMENTS.map(|factor| factor * scene.scene().windows(cells)) {
                    let folder = out.join(format!("{}-{word}-{cells}-{windows}", scene.word()));
                    let run =
                        pool.install(|| measure(scene.scene(), (backend, word), (cells, windows), &folder))?;
                    let line = Line { scene: scene.word(), backend: word, measured: &run };
                    say(&line.text());
                    table += &line.csv();
                    runs.push(run);
                }
                let points = runs.iter().map(|run| (run.seconds, run.error)).collect();
                curves.push((format!("{word}, {cells} cells"), points));
            }
        }
        if !curves.is_empty() {
            plots.push(WorkPrecision {
                title: scene.word().to_string(),
                work: Amount { name: "processor time".to_string(), unit: "s".to_string() },
                error: "error of u, relative to the exact u at the start".to_string(),
                curves,
            });
        }
    }
    let path = out.join("bench.csv");
    fs::write(&path, table).map_err(OutputError::system("write", &path))?;
    report::report_of_bench(out, "Error against processor time", &plots)?;
    say(&format!("table in {}, plots in {}", path.display(), out.join("report.html").display()));
    Ok(())
}

fn say(line: &str) {
    // Nothing can be done where not even this can be printed.
    let _ = writeln!(std::io::stdout(), "{line}");
}
