//! The executable `fluid-solver`.

fn main() -> std::process::ExitCode {
    fluid_solver::program::main()
}
