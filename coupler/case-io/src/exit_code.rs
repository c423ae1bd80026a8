//! The exit code of every executable: one type, so that a script can tell why a run stopped.

use serde::{Deserialize, Serialize};

/// Why a program ended, as the operating system sees it.
///
/// The coupler ends with the code of the first cause: if a solver found a non-finite value and the other one was
/// stopped for it, the run ends with [`ExitCode::NonFinite`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(into = "u8", try_from = "u8")]
#[repr(u8)]
pub enum ExitCode {
    /// The work is done and every check passed.
    Done = 0,
    /// A defect of the program.
    Defect = 1,
    /// The command line was not understood, or names a folder that it may not.
    CommandLine = 2,
    /// The case, the mesh or the data were refused.
    CaseRefused = 3,
    /// The work is done, but a check failed.
    CheckFailed = 4,
    /// Disk, shared memory, or an executable that is missing or of another version.
    Environment = 5,
    /// The coupling or a linear solve did not converge.
    NotConverged = 6,
    /// A value became infinite or not a number.
    NonFinite = 7,
    /// A ledger row left its tolerance, or a grain was lost.
    Ledger = 8,
    /// A participant died.
    PeerDied = 9,
    /// A participant no longer answers.
    PeerFrozen = 10,
    /// The time step fell below the stated minimum.
    TimeStepTooSmall = 11,
    /// Interrupted by the user; ended at a commit.
    Interrupted = 130,
}

impl ExitCode {
    /// All codes, in ascending order.
    pub const ALL: [Self; 13] = [
        Self::Done,
        Self::Defect,
        Self::CommandLine,
        Self::CaseRefused,
        Self::CheckFailed,
        Self::Environment,
        Self::NotConverged,
        Self::NonFinite,
        Self::Ledger,
        Self::PeerDied,
        Self::PeerFrozen,
        Self::TimeStepTooSmall,
        Self::Interrupted,
    ];

    /// The number handed to the operating system.
    pub const fn code(self) -> u8 {
        self as u8
    }

    /// What the code says about the run.
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Done => "done, all checks pass",
            Self::Defect => "defect of the program",
            Self::CommandLine => "command line not understood, or it names a folder that it may not",
            Self::CaseRefused => "case, mesh or data refused",
            Self::CheckFailed => "done, but a check failed",
            Self::Environment => {
                "environment: disk, shared memory, or an executable missing or of another version"
            }
            Self::NotConverged => "not converged",
            Self::NonFinite => "a value became infinite or not a number",
            Self::Ledger => "a ledger row left its tolerance, or a grain was lost",
            Self::PeerDied => "a participant died",
            Self::PeerFrozen => "a participant no longer answers",
            Self::TimeStepTooSmall => "time step below the minimum",
            Self::Interrupted => "interrupted, ended at a commit",
        }
    }

    /// What the user can do about it.
    pub const fn advice(self) -> &'static str {
        match self {
            Self::Done => "read report.html",
            Self::Defect => "report it with the case and log.txt; the last restart point can be resumed",
            Self::CommandLine => "the message says what is allowed; see --help",
            Self::CaseRefused => {
                "the message names file, line and key; `coupler check CASE` tries again without running"
            }
            Self::CheckFailed => "the table of checks in report.html shows value, reference and tolerance",
            Self::Environment => {
                "free disk or shared memory (`coupler clean`), or build all three executables together"
            }
            Self::NotConverged => {
                "shorten the time window, allow more iterations, or choose a stronger acceleration; \
                 the convergence plot in report.html shows where it began"
            }
            Self::NonFinite => {
                "the message names the first grain or node; shorten the time window or the substep"
            }
            Self::Ledger => {
                "the ledger plot in report.html shows the window; look for a grain that left the domain or too long a step"
            }
            Self::PeerDied => "log.txt holds its last words; then `coupler resume DIR`",
            Self::PeerFrozen => {
                "look for a suspended process or an overloaded machine, then `coupler resume DIR`"
            }
            Self::TimeStepTooSmall => {
                "lower the minimum, soften the contacts or refine less; the message names the grain or cell that binds"
            }
            Self::Interrupted => "`coupler resume DIR` goes on from the last restart point",
        }
    }
}

impl From<ExitCode> for std::process::ExitCode {
    fn from(code: ExitCode) -> Self {
        Self::from(code.code())
    }
}

impl From<ExitCode> for u8 {
    fn from(code: ExitCode) -> Self {
        code.code()
    }
}

impl TryFrom<u8> for ExitCode {
    type Error = String;

    /// # Errors
    /// A number that is no exit code of this program.
    fn try_from(number: u8) -> Result<Self, String> {
        Self::ALL
            .into_iter()
            .find(|code| code.code() == number)
            .ok_or_else(|| format!("{number} is no exit code; allowed are 0 to 11 and 130"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_are_the_documented_ones() {
        let numbers: Vec<u8> = ExitCode::ALL.iter().map(|code| code.code()).collect();
        assert_eq!(numbers, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 130]);
    }

    #[test]
    fn every_number_leads_back_to_its_code_and_no_other_does() {
        let known: Vec<u8> = (0..=u8::MAX).filter(|&number| ExitCode::try_from(number).is_ok()).collect();
        assert_eq!(known.len(), ExitCode::ALL.len());
        for code in ExitCode::ALL {
            assert_eq!(ExitCode::try_from(code.code()), Ok(code));
        }
    }

    #[test]
    fn no_two_codes_share_a_meaning() {
        for (i, a) in ExitCode::ALL.iter().enumerate() {
            for b in &ExitCode::ALL[i + 1..] {
                assert_ne!(a.meaning(), b.meaning());
                assert_ne!(a.advice(), b.advice());
            }
        }
    }

    #[test]
    fn json_holds_the_number() {
        assert_eq!(serde_json::to_string(&ExitCode::Interrupted).unwrap(), "130");
        assert!(serde_json::from_str::<ExitCode>("12").is_err());
    }
}
