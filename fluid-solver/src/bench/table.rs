//! The table, on the screen and as a file.

use super::measure::Measured;
use crate::backend::Stages;

/// Titles on the screen.
pub const TITLES: &str = "scene          backend    cells windows   nodes       error  CPU s   us/node-step   mesh boundary transfer assembly  solve   iterations/window";

/// Titles of the file.
pub const CSV_TITLES: &str = "scene,backend,cells,windows,nodes,error,cpu[s],cpu_per_node_step[us],mesh_share,boundary_share,transfer_share,assembly_share,solve_share,iterations_per_window\n";

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

    /// Shares of the time: mesh, boundary, transfer, assembly, solve; norms, books and copies are the rest.
    fn shares(&self) -> [f64; 5] {
        let Stages { mesh, boundary, transfer, assembly, solve } = self.measured.stages;
        [mesh, boundary, transfer, assembly, solve].map(|stage| stage / self.measured.seconds)
    }

    fn iterations(&self) -> f64 {
        self.measured.iterations as f64 / self.measured.windows as f64
    }

    /// For the screen.
    pub fn text(&self) -> String {
        let Measured { cells, windows, nodes, error, seconds, .. } = self.measured;
        let [mesh, boundary, transfer, assembly, solve] = self.shares().map(|share| 100.0 * share);
        format!(
            "{:<14} {:<9} {cells:>6} {windows:>7} {nodes:>7}   {error:>9.3e} {seconds:>6.2} {:>14.1} {mesh:>4.1} % {boundary:>6.1} % {transfer:>6.1} % {assembly:>6.1} % {solve:>4.1} % {:>19.1}",
            self.scene,
            self.backend,
            self.microseconds(),
            self.iterations()
        )
    }

    /// For the file.
    pub fn csv(&self) -> String {
        let Measured { cells, windows, nodes, error, seconds, .. } = self.measured;
        let (microseconds, iterations) = (self.microseconds(), self.iterations());
        let (scene, backend) = (self.scene, self.backend);
        let shares = self.shares().map(|share| share.to_string()).join(",");
        format!(
            "{scene},{backend},{cells},{windows},{nodes},{error},{seconds},{microseconds},{shares},{iterations}\n"
        )
    }
}
