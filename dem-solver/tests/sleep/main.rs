//! Idle grains asleep: what they keep, what wakes them, what is counted.

mod bits;
mod books;
mod scenes;
mod sinking;
mod waking;
