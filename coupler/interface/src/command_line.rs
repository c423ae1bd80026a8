//! What is wrong with a command line, in one line.

use clap::error::ErrorKind;

/// Whether the error is a wish for help or version, or nothing was asked for: then all of it is to be printed.
pub fn is_help(error: &clap::Error) -> bool {
    !error.use_stderr() || error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
}

/// The error in one line: what is wrong, what is allowed, what to do.
pub fn in_one_line(error: &clap::Error, command: &clap::Command) -> String {
    let text = error.to_string();
    let says_something = |line: &&str| !line.is_empty() && !line.starts_with("For more information");
    let lines: Vec<&str> = text.lines().map(str::trim).filter(says_something).collect();
    let mut message = lines.join("; ").replace(":; ", ": ").trim_start_matches("error: ").to_string();
    if error.kind() == ErrorKind::InvalidSubcommand {
        let shown = command.get_subcommands().filter(|known| !known.is_hide_set());
        let names: Vec<&str> = shown.map(clap::Command::get_name).collect();
        message += &format!("; allowed: {}", names.join(", "));
    }
    message + "; see --help"
}
