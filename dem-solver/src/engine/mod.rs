//! The contact engine: pairs in lanes, grains in rows.
//!
//! 1. [`levels`] sorts grains by size, [`grid`] into cells; [`outer`] lists pairs nearer than an outer skin, rarely.
//! 2. [`inner`] picks from them the pairs nearer than an inner gap, in blocks of eight with their springs.
//! 3. [`pairs`] and [`planes`] find the forces of a block at once and add them to rows of loads, chunk by chunk.
//! 4. [`motion`] joins the loads of chunks in their order and moves the grains; [`approach`] says for how long the
//!    lists hold.
//!
//! Chunks of grains are fixed by their number alone, and sums are joined in the order of chunks: the same bits
//! from any number of threads, and from any lanes.

mod approach;
mod archive;
mod block;
mod chunk;
mod constants;
mod extras;
mod forces;
mod grid;
mod inner;
mod kernels;
mod levels;
mod list;
mod loads;
mod motion;
mod near_planes;
mod near_walls;
mod order;
mod outer;
mod pairs;
mod periods;
mod planes;
mod springs;
mod upkeep;
mod wall_contact;

pub use approach::{Approach, Fastest};
pub use archive::ContactArrays;
pub use chunk::{Chunk, ranges};
pub use constants::{Alike, extras_of_pair, extras_on_wall};
pub use forces::forces;
pub use grid::Grid;
pub use list::{ContactList, Counters, Skins};
pub use loads::{Arriving, ChunkLoads, Join, by_target};
pub use motion::{Advance, Fly, Moved, Rows, Speeds};
pub use near_planes::{NearPlanes, Planes};
pub use near_walls::{candidate, extras_near, inherited};
pub use order::{order_expired, put_in_order};
pub use periods::Periods;
pub use upkeep::bring_up_lists;
pub use wall_contact::{Candidate, WallContact};
