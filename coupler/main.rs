//! The executable `coupler`.

fn main() -> std::process::ExitCode {
    coupler::command::main()
}
