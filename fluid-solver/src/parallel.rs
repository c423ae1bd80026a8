//! Loops over nodes on all threads.

use rayon::prelude::*;

/// Nodes per unit of parallel work; fixed, so that nothing depends on the number of threads.
pub const NODES: usize = 256;

/// Calls `work(node, value of the node)` for every node.
pub fn for_each_node<R: Send>(values: &mut [R], work: impl Fn(usize, &mut R) + Sync) {
    values.par_chunks_mut(NODES).enumerate().for_each(|(index, values)| {
        for (node, value) in (index * NODES..).zip(values) {
            work(node, value);
        }
    });
}
