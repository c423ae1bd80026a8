//! `dem-solver stress`: what the solver bears, what it gets right at the extremes, and what it refuses clearly.

mod angle_of_repose;
mod bad_start;
mod command;
mod contrast;
mod fast_impact;
mod finding;
mod impact;
mod laws;
mod resting_pile;
mod runner;
mod step_limit;

pub use command::{Arguments, run};

use finding::Finding;

/// How long trials last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Effort {
    /// A minute at most.
    Quick,
    /// As long as it takes.
    Full,
}

/// A family of scenes that are tried.
struct Trial {
    /// What is tried.
    topic: &'static str,
    /// Tries it.
    findings: fn(Effort) -> Vec<Finding>,
}

/// All trials, in the order of the table.
const TRIALS: [Trial; 7] = [
    Trial { topic: "time step", findings: step_limit::findings },
    Trial { topic: "stiffness ratio", findings: contrast::of_stiffness },
    Trial { topic: "size ratio", findings: contrast::of_size },
    Trial { topic: "start", findings: bad_start::findings },
    Trial { topic: "fast impact", findings: fast_impact::findings },
    Trial { topic: "resting pile", findings: resting_pile::findings },
    Trial { topic: "angle of repose", findings: angle_of_repose::findings },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_takes_no_time_is_borne() {
        for findings in [bad_start::findings, contrast::of_stiffness, contrast::of_size] {
            for finding in findings(Effort::Quick) {
                assert!(finding.holds, "{finding:?}");
            }
        }
    }

    #[test]
    #[ignore = "two heaps take a minute"]
    fn a_heap_that_rubs_more_is_steeper() {
        angle_of_repose::findings(Effort::Quick)
            .iter()
            .for_each(|finding| assert!(finding.holds, "{finding:?}"));
    }

    #[test]
    fn the_critical_step_is_stable_and_more_is_refused() {
        step_limit::findings(Effort::Quick).iter().for_each(|finding| assert!(finding.holds, "{finding:?}"));
    }
}
