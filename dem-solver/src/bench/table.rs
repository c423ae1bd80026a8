//! The table: rows on standard output and in a csv file.

use super::speed::Clocks;

/// What was measured of a scene of so many grains on some lanes.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Name of the scene.
    pub scene: &'static str,
    /// Number of grains.
    pub grains: usize,
    /// Steps of a run.
    pub steps: u32,
    /// Name of the lanes.
    pub lanes: &'static str,
    /// Runs on one thread.
    pub runs: Vec<Clocks>,
    /// Wall times of runs on several threads \[s\], where there are several.
    pub threaded: Option<Vec<f64>>,
    /// Memory per grain \[B\], where there are enough of them to tell.
    pub bytes_per_grain: Option<f64>,
    /// Bytes per grain that a step reads and writes \[B\].
    pub traffic: f64,
    /// Instructions per grain and step, where they are counted.
    pub instructions: Option<f64>,
    /// Times of the steps of each peer \[s\]; nothing where it cannot compute the scene.
    pub peers: Vec<Option<Vec<f64>>>,
}

/// The columns of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// Number of threads of the runs on several.
    pub threads: usize,
    /// Names of the peers.
    pub peers: Vec<&'static str>,
}

impl Columns {
    /// Titles, as wide as the values below them.
    pub fn titles(&self) -> String {
        let mut titles: Vec<String> =
            ["best", "median", "own core", "B/grain", "B/step", "instr/step"].map(String::from).into();
        titles.extend((self.threads > 1).then(|| format!("{} threads", self.threads)));
        titles.extend(self.peers.iter().flat_map(|peer| [peer.to_string(), "ratio".into()]));
        let titles: Vec<String> = titles.iter().map(|title| format!("{title:>11}")).collect();
        format!("{:12} {:>8}  {:8}{}", "scene", "grains", "lanes", titles.concat())
    }

    /// The titles of the csv file.
    pub fn csv_titles(&self) -> String {
        let mut titles = String::from(
            "scene,grains,steps,lanes,best[1e6/s],median[1e6/s],wall-best[1e6/s],own-core[1],memory[B/grain],traffic[B/step],instructions[1/step]",
        );
        if self.threads > 1 {
            titles += &format!(",speed-up-{}-threads[1]", self.threads);
        }
        for peer in &self.peers {
            titles += &format!(",{peer}[1e6/s],ratio-to-{peer}[1]");
        }
        titles + "\n"
    }
}

impl Row {
    /// Million particle-steps per second of a run of so many seconds.
    fn rate(&self, seconds: f64) -> f64 {
        self.grains as f64 * f64::from(self.steps) / seconds * 1e-6
    }

    fn best_wall(&self) -> f64 {
        least(self.runs.iter().map(|run| run.wall))
    }

    /// Share of the wall time in which the thread ran: below 1 where it shared its core.
    fn own_core(&self) -> f64 {
        let sum = |of: fn(&Clocks) -> f64| self.runs.iter().map(of).sum::<f64>();
        sum(|run| run.processor) / sum(|run| run.wall)
    }

    /// Best and median rate of processor time.
    fn of_processor(&self) -> [f64; 2] {
        let mut seconds: Vec<f64> = self.runs.iter().map(|run| run.processor).collect();
        seconds.sort_by(f64::total_cmp);
        [seconds[0], seconds[seconds.len() / 2]].map(|seconds| self.rate(seconds))
    }

    /// How much faster several threads are, by the wall.
    fn speed_up(&self) -> Option<f64> {
        self.threaded.as_ref().map(|runs| self.best_wall() / least(runs.iter().copied()))
    }

    /// Rate of each peer and how much faster this program is, best to best by the wall.
    fn of_peers(&self) -> impl Iterator<Item = Option<[f64; 2]>> {
        self.peers.iter().map(|runs| {
            let best = least(runs.as_ref()?.iter().copied());
            Some([self.rate(best), best / self.best_wall()])
        })
    }

    /// The row, as wide as the titles.
    pub fn line(&self) -> String {
        let [best, median] = self.of_processor();
        let cell = |value: f64, digits: usize| format!("{value:>11.digits$}");
        let nothing = || format!("{:>11}", "-");
        let mut cells = vec![cell(best, 1), cell(median, 1), cell(self.own_core(), 2)];
        cells.push(self.bytes_per_grain.map_or_else(nothing, |bytes| cell(bytes, 0)));
        cells.push(cell(self.traffic, 0));
        cells.push(self.instructions.map_or_else(nothing, |count| cell(count, 0)));
        cells.extend(self.speed_up().map(|ratio| cell(ratio, 2)));
        for peer in self.of_peers() {
            match peer {
                Some([rate, ratio]) => cells.extend([cell(rate, 1), cell(ratio, 2)]),
                None => cells.extend([nothing(), nothing()]),
            }
        }
        format!("{:12} {:>8}  {:8}{}", self.scene, self.grains, self.lanes, cells.concat())
    }

    /// The row of the csv file; empty where there is nothing.
    pub fn csv_line(&self) -> String {
        let Self { scene, grains, steps, lanes, .. } = self;
        let [best, median] = self.of_processor();
        let numbers = [best, median, self.rate(self.best_wall()), self.own_core()];
        let mut cells: Vec<String> = numbers.iter().map(f64::to_string).collect();
        cells.push(self.bytes_per_grain.map(|bytes| bytes.to_string()).unwrap_or_default());
        cells.push(self.traffic.to_string());
        cells.push(self.instructions.map(|count| count.to_string()).unwrap_or_default());
        cells.extend(self.speed_up().map(|ratio| ratio.to_string()));
        for peer in self.of_peers() {
            cells.extend(peer.map_or_else(Default::default, |pair| pair.map(|number| number.to_string())));
        }
        format!("{scene},{grains},{steps},{lanes},{}\n", cells.join(","))
    }
}

fn least(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_of_processor_time_and_ratios_of_wall_time() {
        let run = |processor: f64| Clocks { wall: 2.0 * processor, processor };
        let row = Row {
            scene: "dense",
            grains: 1_000_000,
            steps: 8,
            lanes: "plain",
            runs: vec![run(2.0), run(1.0), run(4.0)],
            threaded: Some(vec![1.0, 3.0]),
            bytes_per_grain: Some(400.0),
            traffic: 900.0,
            instructions: None,
            peers: vec![Some(vec![9.0, 8.0]), None],
        };
        let columns = Columns { threads: 2, peers: vec!["LIGGGHTS", "YADE"] };
        assert_eq!(row.csv_line(), "dense,1000000,8,plain,8,4,4,0.5,400,900,,2,1,4,,\n");
        assert_eq!(row.csv_line().matches(',').count(), columns.csv_titles().matches(',').count());
        assert_eq!(row.line().len(), columns.titles().len());
    }
}
