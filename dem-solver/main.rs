//! The executable `dem-solver`.

fn main() -> std::process::ExitCode {
    dem_solver::program::main()
}
