//! What many contacts are together: coordination number, fabric, stress.

mod clumps;
mod contacts;
mod coordination;
mod fabric;
mod series;
mod stress;
mod tensor;
mod volume;

pub use contacts::{Contact, contacts_at_rest};
pub use coordination::{Coordination, coordination};
pub use fabric::fabric;
pub use series::{bulk_row, bulk_titles};
pub use stress::contact_stress;
pub use volume::bulk_volume;
