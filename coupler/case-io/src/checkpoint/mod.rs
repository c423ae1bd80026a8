//! Checkpoints: everything a participant needs to go on with the same bits, and the restart point that joins the
//! checkpoints of all participants in one transaction.
//!
//! ```text
//! magic "SILTCKPT" | version u32 | header bytes u32 | checksum of the rest of the header u64
//! header: kind, sections (name, element type, count, checksum)          bincode
//! section 0: metadata                                                   bincode
//! section 1, 2, …: bulk arrays, raw, little-endian
//! ```
//! Every part begins at a multiple of 8 bytes. Every section has its own XXH64 checksum.

mod checksum;
mod container;
mod element;
mod manifest;
mod restart_point;
mod write;

pub use checksum::checksum;
pub use container::Checkpoint;
pub use element::Element;
pub use manifest::{Manifest, Part};
pub use restart_point::{Found, RestartPoint, Search, Skipped, latest, part_path};
pub use write::CheckpointWriter;

use element::ElementType;
use serde::{Deserialize, Serialize};

const MAGIC: [u8; 8] = *b"SILTCKPT";
const VERSION: u32 = 1;
/// Magic, version, header length and header checksum.
const PREFIX: usize = 24;
/// The name of section 0.
const METADATA: &str = "metadata";

#[derive(Debug, Serialize, Deserialize)]
struct Header {
    kind: String,
    sections: Vec<Section>,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
struct Section {
    name: String,
    element: ElementType,
    /// Number of elements.
    count: u64,
    checksum: u64,
}

impl Section {
    /// Bytes of the data, without padding.
    fn bytes(&self) -> Option<u64> {
        self.count.checked_mul(self.element.size())
    }
}

/// Zero bytes from `length` to the next multiple of 8.
fn padding(length: u64) -> u64 {
    length.wrapping_neg() % 8
}
