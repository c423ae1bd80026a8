//! Progress on the terminal: a bar with the time left; nothing where nobody watches.

use crate::clock::Clock;
use crate::simulation::Watcher;
use case_io::summary::Counts;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;

/// Parts of the bar.
const LENGTH: u64 = 10_000;

pub(super) struct Progress(Option<ProgressBar>);

impl Progress {
    /// A bar if standard error is a terminal and the user has not asked for silence.
    pub(super) fn new(title: &str, quiet: bool) -> Progress {
        if quiet || !std::io::stderr().is_terminal() {
            return Progress(None);
        }
        let template = "{prefix} [{bar:32}] {percent:>3} %  {msg}  {elapsed} gone, {eta} left";
        let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        Progress(Some(
            ProgressBar::new(LENGTH).with_style(style.progress_chars("=> ")).with_prefix(title.to_string()),
        ))
    }

    pub(super) fn finish(self) {
        if let Some(bar) = self.0 {
            bar.finish_and_clear();
        }
    }
}

impl Watcher for Progress {
    fn window(&mut self, clock: &Clock, counts: &Counts) {
        let Some(bar) = &self.0 else { return };
        bar.set_position((clock.progress() * LENGTH as f64) as u64);
        let per_window = counts.iterations as f64 / counts.windows.max(1) as f64;
        bar.set_message(format!(
            "t = {:.4} s, {} grains, {per_window:.1} iterations a window",
            clock.time, counts.grains
        ));
    }
}
