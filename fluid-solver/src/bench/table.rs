//! The table, on the screen and as a file.

use super::measure::Measured;

/// Titles on the screen.
pub const TITLES: &str = "scene          backend    cells windows   nodes       error  CPU s   us/node-step  of it commit  iterations/window";

/// Titles of the file.
pub const CSV_TITLES: &str = "scene,backend,cells,windows,nodes,error,cpu[s],cpu_per_node_step[us],commit_share,iterations_per_window\n";

/// What a line says.
pub struct Line<'a> {
    /// The scene's word.
    pub scene: &'a str,
    /// The backend's word.
    pub backend: &'a str,
    /// The run.
    pub measured: &'a Measured,
}

impl Line<'_> {
    fn microseconds(&self) -> f64 {
        1e6 * self.measured.seconds_per_node_step()
    }

    /// Share of the time that commits take: with `pfem` remeshing, the rest is the flow.
    fn commit_share(&self) -> f64 {
        self.measured.commits / self.measured.seconds
    }

    fn iterations(&self) -> f64 {
        self.measured.iterations as f64 / self.measured.windows as f64
    }

    /// For the screen.
    pub fn text(&self) -> String {
        let Measured { cells, windows, nodes, error, seconds, .. } = self.measured;
        format!(
            "{:<14} {:<9} {cells:>6} {windows:>7} {nodes:>7}   {error:>9.3e} {seconds:>6.2} {:>14.1} {:>11.1} % {:>18.1}",
            self.scene,
            self.backend,
            self.microseconds(),
            100.0 * self.commit_share(),
            self.iterations()
        )
    }

    /// For the file.
    pub fn csv(&self) -> String {
        let Measured { cells, windows, nodes, error, seconds, .. } = self.measured;
        let (microseconds, iterations) = (self.microseconds(), self.iterations());
        let (scene, backend, commits) = (self.scene, self.backend, self.commit_share());
        format!(
            "{scene},{backend},{cells},{windows},{nodes},{error},{seconds},{microseconds},{commits},{iterations}\n"
        )
    }
}
