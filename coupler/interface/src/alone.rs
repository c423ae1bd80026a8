//! One solver alone: the coupler beside it runs the case, which has no other side.

use std::process::{Command, ExitCode};

/// Runs `coupler run` with these arguments; its exit code is this program's.
pub fn run_by_coupler(arguments: &[String]) -> ExitCode {
    let coupler = std::env::current_exe().map(|own| own.with_file_name("coupler")).unwrap_or_default();
    match Command::new(&coupler).arg("run").args(arguments).status() {
        Ok(status) => {
            status.code().and_then(|code| u8::try_from(code).ok()).map_or(ExitCode::FAILURE, ExitCode::from)
        }
        Err(error) => {
            use std::io::Write;
            // Nothing can be done where not even this can be printed.
            let _ = writeln!(
                std::io::stderr(),
                "error: {}: {error}; build all three programs with `cargo build --release`",
                coupler.display()
            );
            ExitCode::from(5)
        }
    }
}
