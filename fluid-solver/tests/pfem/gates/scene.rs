//! Fluids of cases, and their windows.

use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use case_io::document::{Case, Overrides};
use fluid_solver::FluidError;
use fluid_solver::backend::{self, Attempt, FluidBackend, Step};

/// What the case of a fluid has besides if there are grains.
pub fn grains_beside(dimension: usize) -> String {
    let at = vec!["0.1 m"; dimension];
    format!(
        r#"
[materials.glass]
density = "2500 kg/m^3"
[grains]
normal-law = "none"
[[insertion]]
name = "grains"
material = "glass"
diameter = "1 mm"
at = [{at:?}]
[coupling]
scheme = "serial-implicit"
drag = "none""#
    )
}

/// Water in a case: what is stated between `[time]` and the end.
pub fn fluid(name: &str, dimension: usize, tables: &str) -> Box<dyn FluidBackend> {
    liquid(name, dimension, ["1000 kg/m^3", "1 mPa s"], tables)
}

/// A fluid of some density and viscosity in a case.
pub fn liquid(name: &str, dimension: usize, properties: [&str; 2], tables: &str) -> Box<dyn FluidBackend> {
    stated(name, dimension, properties, tables, &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// What a case with some files beside it is taken for.
pub fn stated(
    name: &str,
    dimension: usize,
    [density, viscosity]: [&str; 2],
    tables: &str,
    files: &[(&str, &str)],
) -> Result<Box<dyn FluidBackend>, FluidError> {
    let gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"];
    let text = format!(
        "[case]\ntitle = \"gates\"\ndimension = {dimension}\ngravity = {:?}\n[time]\nend = \"1 s\"\nwindow = \"1 ms\"\n[fluid]\nbackend = \"pfem\"\ndensity = {density:?}\nviscosity = {viscosity:?}\n{tables}",
        &gravity[3 - dimension..]
    );
    let folder = std::env::temp_dir().join(format!("silt-gates-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for (file, text) in [("case.toml", text.as_str())].iter().chain(files) {
        std::fs::write(folder.join(file), text).unwrap();
    }
    let case = Case::load_run(&folder, &Overrides::default(), None).unwrap();
    let backend = backend::of(&case, true);
    std::fs::remove_dir_all(&folder).unwrap();
    backend
}

/// All that the next step depends on, as it is written to disk, and its bytes.
pub fn checkpoint(fluid: &dyn FluidBackend, name: &str) -> (Checkpoint, Vec<u8>) {
    let path = std::env::temp_dir().join(format!("silt-state-{name}-{}", std::process::id()));
    fluid.save_checkpoint(CheckpointWriter::new("test", &())).write(&path).unwrap();
    let found = (Checkpoint::read(&path, "test").unwrap(), std::fs::read(&path).unwrap());
    std::fs::remove_file(path).unwrap();
    found
}

/// Windows of at most `window` (s) from `start` to `end`; momentum closes in each.
pub fn advance(fluid: &mut dyn FluidBackend, window: f64, [start, end]: [f64; 2]) {
    let (mut time, mut length) = (start, window);
    while time < end - 1e-9 * window {
        let step = Step { time, length: length.min(end - time) };
        fluid.save();
        match fluid.solve(step, &[]).unwrap() {
            Attempt::Solved(solution) => {
                let books = &solution.ledger;
                for k in 0..3 {
                    let defect = books.rate[k] - books.body[k] - books.boundary[k];
                    assert!(defect.abs() <= 1e-12 * books.scale, "{time} s: {defect:e} of {:e}", books.scale);
                }
                fluid.commit(step).unwrap();
                time += step.length;
                length = window;
            }
            Attempt::TooLarge(too_large) => {
                fluid.restore();
                length = 0.5 * step.length;
                assert!(length > 1e-4 * window, "{time} s: {}", too_large.reason);
            }
        }
    }
}

/// A value of the statistics.
pub fn value(fluid: &dyn FluidBackend, name: &str) -> f64 {
    let statistics = fluid.statistics(0.0);
    let found = statistics.iter().find(|(found, _)| *found == name).unwrap_or_else(|| panic!("no {name}")).1;
    assert!(found.is_finite(), "{name} is {found}");
    found
}
