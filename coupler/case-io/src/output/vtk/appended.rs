//! The appended section: raw arrays one after the other, each found by its offset.

/// Whether arrays are stored as they are or in LZ4 blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Compression {
    /// As they are.
    None,
    /// LZ4 blocks (`vtkLZ4DataCompressor`, read by VTK 8.2 and ParaView 5.7 or newer).
    #[default]
    Lz4,
}

impl Compression {
    /// The attribute of `<VTKFile>`.
    pub(super) fn attribute(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Lz4 => " compressor=\"vtkLZ4DataCompressor\"",
        }
    }
}

/// Uncompressed bytes of one LZ4 block.
const BLOCK: usize = 1 << 18;

/// Everything after the underscore of `<AppendedData>`.
#[derive(Default)]
pub(super) struct Appended {
    pub(super) bytes: Vec<u8>,
}

impl Appended {
    /// Adds an array and returns its offset.
    ///
    /// Uncompressed: `[bytes] data`. Compressed: `[blocks][block size][size of a last, partial block or 0]
    /// [compressed size of each block] data`; all headers u64.
    pub(super) fn push(&mut self, array: &[u8], compression: Compression) -> usize {
        let offset = self.bytes.len();
        match compression {
            Compression::None => {
                self.push_header(&[array.len()]);
                self.bytes.extend_from_slice(array);
            }
            Compression::Lz4 => {
                let blocks: Vec<Vec<u8>> = array.chunks(BLOCK).map(lz4_flex::block::compress).collect();
                self.push_header(&[blocks.len(), BLOCK, array.len() % BLOCK]);
                for block in &blocks {
                    self.push_header(&[block.len()]);
                }
                self.bytes.extend(blocks.into_iter().flatten());
            }
        }
        offset
    }

    fn push_header(&mut self, sizes: &[usize]) {
        for &size in sizes {
            self.bytes.extend_from_slice(&(size as u64).to_le_bytes());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn word(bytes: &[u8], index: usize) -> u64 {
        u64::from_le_bytes(bytes[8 * index..8 * index + 8].try_into().unwrap())
    }

    #[test]
    fn a_raw_array_is_its_size_and_its_bytes() {
        let mut appended = Appended::default();
        assert_eq!(appended.push(&[7; 5], Compression::None), 0);
        assert_eq!(appended.push(&[8; 3], Compression::None), 13);
        assert_eq!(
            appended.bytes,
            [&[5, 0, 0, 0, 0, 0, 0, 0][..], &[7; 5], &[3, 0, 0, 0, 0, 0, 0, 0], &[8; 3]].concat()
        );
    }

    #[test]
    fn a_compressed_array_tells_blocks_and_the_size_of_a_partial_last_block() {
        for (length, blocks, partial) in [(0, 0, 0), (10, 1, 10), (BLOCK, 1, 0), (BLOCK + 1, 2, 1)] {
            let mut appended = Appended::default();
            appended.push(&vec![1; length], Compression::Lz4);
            let header: Vec<u64> = (0..3).map(|index| word(&appended.bytes, index)).collect();
            assert_eq!(header, [blocks, BLOCK as u64, partial], "{length} bytes");
        }
    }
}
