//! Other programs for grains, to be compared with: each gets its own input, is run, and its results are held
//! against those of this program.

mod command;
mod comparison;
mod data_file;
mod error;
mod lammps;
mod launch;
mod liggghts;
mod own_case;
mod own_run;
mod report;
mod results;
mod stl;
mod task;
mod told;
mod wall;
mod yade;

use case_io::document::Case;
use case_io::error::CaseError;
use clap::ValueEnum;

use crate::contact::NormalLaw;
use lammps::Lammps;
use liggghts::Liggghts;
use yade::Yade;

pub use command::Command;
pub use error::PeerError;
pub use launch::{Installed, write_deck};
pub use stl::stl;
pub use task::{Recording, Task};

/// What stands before the seconds of all steps in a peer's log.
pub const LOOP_TIME: &str = "Loop time of ";

/// A file of a deck.
#[derive(Clone, Debug, PartialEq)]
pub struct File {
    /// Its name in the folder of the deck.
    pub name: String,
    /// What it holds.
    pub text: String,
}

impl File {
    /// A file of this name that holds this text.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self { name: name.into(), text: text.into() }
    }
}

/// A program that computes grains.
///
/// Its deck makes it write, beside itself, `grains.dump` or `means.txt` and `walls.txt`, in the forms that
/// [`results`] reads.
pub trait Peer {
    /// Its name as its authors write it.
    fn name(&self) -> &'static str;

    /// Its executable.
    fn executable(&self) -> &'static str;

    /// How to install it.
    fn install(&self) -> &'static str;

    /// The version whose input and formulas are known.
    fn version(&self) -> &'static str;

    /// What makes it tell its version, and what stands before and behind the version in the answer.
    fn version_question(&self) -> (&'static str, [&'static str; 2]);

    /// Whether it computes this law by the very same formulas.
    fn computes_alike(&self, law: &NormalLaw) -> bool;

    /// Its input for a task. With nothing to write it is timed: its log then has [`LOOP_TIME`] and the seconds that its
    /// steps took, without what goes before them.
    ///
    /// # Errors
    /// What it cannot be told: the message names the key.
    fn deck(&self, case: &Case, task: &Task, recording: Option<Recording>) -> Result<Vec<File>, CaseError>;

    /// The arguments with which it runs its deck, in the folder of the deck.
    fn arguments(&self) -> &'static [&'static str];
}

/// The known peers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Program {
    /// LIGGGHTS-PUBLIC 3.8.0.
    Liggghts,
    /// YADE 2023.02a.
    Yade,
    /// LAMMPS of 22 July 2025, package GRANULAR.
    Lammps,
}

impl Program {
    /// The peer itself.
    pub fn peer(self) -> &'static dyn Peer {
        match self {
            Self::Liggghts => &Liggghts,
            Self::Yade => &Yade,
            Self::Lammps => &Lammps,
        }
    }

    /// Its name on the command line and in paths.
    pub fn word(self) -> &'static str {
        match self {
            Self::Liggghts => "liggghts",
            Self::Yade => "yade",
            Self::Lammps => "lammps",
        }
    }
}
