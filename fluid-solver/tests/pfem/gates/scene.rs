//! Fluids of cases, and their windows.

use case_io::document::{Case, Overrides};
use fluid_solver::backend::{self, Attempt, FluidBackend, Step};

/// Water in a case: what is stated between `[time]` and the end.
pub fn fluid(name: &str, dimension: usize, tables: &str) -> Box<dyn FluidBackend> {
    liquid(name, dimension, ["1000 kg/m^3", "1 mPa s"], tables)
}

/// A fluid of some density and viscosity in a case.
pub fn liquid(
    name: &str,
    dimension: usize,
    [density, viscosity]: [&str; 2],
    tables: &str,
) -> Box<dyn FluidBackend> {
    let gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"];
    let text = format!(
        "[case]\ntitle = \"gates\"\ndimension = {dimension}\ngravity = {:?}\n[time]\nend = \"1 s\"\nwindow = \"1 ms\"\n[fluid]\nbackend = \"pfem\"\ndensity = {density:?}\nviscosity = {viscosity:?}\n{tables}",
        &gravity[3 - dimension..]
    );
    let folder = std::env::temp_dir().join(format!("silt-gates-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("case.toml"), text).unwrap();
    let case = Case::load_run(&folder, &Overrides::default(), None).unwrap();
    let backend = backend::of(&case, true);
    std::fs::remove_dir_all(&folder).unwrap();
    backend.unwrap_or_else(|error| panic!("{error}"))
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
