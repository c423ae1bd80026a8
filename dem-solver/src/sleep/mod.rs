//! Idle grains asleep: a chunk of grains at rest is held where it is, and where all around it sleep its forces are not found
//! again.
//!
//! 1. [`quiet`]: for how long a chunk has been quiet, or that it sleeps: part of the state.
//! 2. [`bound`]: what counts as idle, and what wakes.
//! 3. [`work`]: what is worked on in a step. In the first step of a window and after new lists all is; between, what
//!    lies beside chunks that are awake.
//! 4. [`bed`]: a chunk at the moment of the kick falls asleep, is held, or wakes and is kicked in the same step.
//!
//! A sleeping chunk that is worked on has all loads on its rows; what one that is not would receive stays what it last was.

mod bed;
mod bound;
mod quiet;
mod slumber;
mod work;

pub use bed::{Bed, Held};
pub use bound::SleepBound;
pub use quiet::Quiet;
pub use slumber::Slumber;
pub use work::{Work, assign_work, regroup};
