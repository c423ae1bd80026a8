//! Weights of grains on nodes: a sparse matrix, one row per grain.

use rayon::prelude::*;

/// Rows `(nodes, values)` of all grains, in chunks of fixed size that are rebuilt in place.
///
/// Each chunk is a compressed row store of its own, so that threads fill them without knowing the lengths of others
/// and no copy joins them. A grain outside the mesh has an empty row.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Weights {
    chunks: Vec<Chunk>,
    grains: usize,
}

/// Consecutive rows.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Chunk {
    offsets: Vec<u32>,
    widths: Vec<f64>,
    pub(super) nodes: Vec<u32>,
    pub(super) values: Vec<f64>,
}

impl Weights {
    /// Grains per chunk, the unit of parallel work. Fixed, so that sums do not depend on the number of threads.
    pub(crate) const GRAINS_PER_CHUNK: usize = 256;

    /// Number of rows.
    pub fn grains(&self) -> usize {
        self.grains
    }

    /// Number of weights of all rows.
    pub fn entries(&self) -> usize {
        self.chunks.iter().map(|chunk| chunk.nodes.len()).sum()
    }

    /// Nodes and weights of a grain; each node once.
    pub fn row(&self, grain: usize) -> (&[u32], &[f64]) {
        self.chunks[grain / Self::GRAINS_PER_CHUNK].row(grain % Self::GRAINS_PER_CHUNK)
    }

    /// Kernel width σ of a grain (m), the standard deviation per direction; 0 outside the mesh.
    pub fn width(&self, grain: usize) -> f64 {
        self.chunks[grain / Self::GRAINS_PER_CHUNK].widths[grain % Self::GRAINS_PER_CHUNK]
    }

    /// Bytes held.
    pub fn memory(&self) -> usize {
        let chunk = |c: &Chunk| {
            4 * (c.offsets.capacity() + c.nodes.capacity()) + 8 * (c.widths.capacity() + c.values.capacity())
        };
        self.chunks.iter().map(chunk).sum()
    }

    pub(crate) fn chunks(&self) -> &[Chunk] {
        &self.chunks
    }

    /// Rebuilds the rows of all grains: `fill_row` fills that of one, given its number, and closes it.
    pub(super) fn rebuild<G: Sync>(&mut self, grains: &[G], fill_row: impl Fn(&mut Chunk, usize, &G) + Sync) {
        let chunks = self.clear(grains.len()).par_iter_mut().zip(grains.par_chunks(Self::GRAINS_PER_CHUNK));
        chunks.enumerate().for_each(|(index, (chunk, grains))| {
            for (number, grain) in (index * Self::GRAINS_PER_CHUNK..).zip(grains) {
                fill_row(chunk, number, grain);
            }
        });
    }

    /// Empties all rows and makes room for `grains`; chunks keep their memory.
    pub(super) fn clear(&mut self, grains: usize) -> &mut [Chunk] {
        self.grains = grains;
        self.chunks.resize_with(grains.div_ceil(Self::GRAINS_PER_CHUNK), Chunk::default);
        for chunk in &mut self.chunks {
            chunk.offsets.clear();
            chunk.offsets.push(0);
            chunk.widths.clear();
            chunk.nodes.clear();
            chunk.values.clear();
        }
        &mut self.chunks
    }
}

impl Chunk {
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&[u32], &[f64])> {
        (0..self.widths.len()).map(|row| self.row(row))
    }

    fn row(&self, row: usize) -> (&[u32], &[f64]) {
        let range = self.offsets[row] as usize..self.offsets[row + 1] as usize;
        (&self.nodes[range.clone()], &self.values[range])
    }

    /// Where the row under construction begins.
    fn open_row(&self) -> usize {
        self.offsets.last().map_or(0, |&offset| offset as usize)
    }

    /// Appends those of the nodes that have a positive weight to the row under construction.
    pub(super) fn extend_row(&mut self, nodes: &[u32], weight: impl Fn(usize) -> f64) {
        let start = self.nodes.len();
        self.nodes.resize(start + nodes.len(), 0);
        self.values.resize(start + nodes.len(), 0.0);
        let (node_slots, value_slots) = (&mut self.nodes[start..], &mut self.values[start..]);
        // Every candidate is written and the next overwrites it unless it counts: no branch to mispredict.
        let mut kept = 0;
        for (candidate, &node) in nodes.iter().enumerate() {
            let value = weight(candidate);
            node_slots[kept] = node;
            value_slots[kept] = value;
            kept += usize::from(value > 0.0);
        }
        self.nodes.truncate(start + kept);
        self.values.truncate(start + kept);
    }

    /// Sums the weights of a node that the row under construction holds several times.
    pub(super) fn merge_row(&mut self) {
        let start = self.open_row();
        let mut row: Vec<(u32, f64)> = self.nodes.drain(start..).zip(self.values.drain(start..)).collect();
        row.sort_by_key(|entry| entry.0);
        for same in row.chunk_by(|a, b| a.0 == b.0) {
            self.nodes.push(same[0].0);
            self.values.push(same.iter().map(|entry| entry.1).sum());
        }
    }

    /// Scales the row under construction to sum one and closes it.
    pub(super) fn close_row(&mut self, width: f64) {
        let start = self.open_row();
        let row = &mut self.values[start..];
        let sum: f64 = row.iter().sum();
        row.iter_mut().for_each(|value| *value /= sum);
        self.offsets.push(self.nodes.len() as u32);
        self.widths.push(width);
    }
}
