//! Aggregates: disjoint groups of strongly coupled unknowns, each one unknown of the next level.

use crate::Pattern;

/// Aggregate of an unknown without strong couplings: the smoother alone solves for it.
pub(super) const ALONE: u32 = u32::MAX;

/// Aggregate of each unknown, and their number; depends on the graph of strong couplings only.
///
/// Pass 1 makes an aggregate of every neighbourhood that touches none yet, pass 2 adds what is left to the neighbouring
/// aggregate with most couplings, pass 3 gathers the rest.
/// Source: Vaněk, Mandel and Brezina, *Computing* 56 (1996) 179, algorithm 5.1.
pub(super) fn aggregate(pattern: &Pattern, strong: &[bool]) -> (Vec<u32>, usize) {
    let n = pattern.rows();
    let neighbours = |i: usize| {
        let slots = pattern.slots(i);
        pattern.row(i).iter().zip(&strong[slots]).filter(|(_, strong)| **strong).map(|(&j, _)| j as usize)
    };
    let mut of = vec![ALONE; n];
    let mut count = 0;

    for i in 0..n {
        let untouched = of[i] == ALONE && neighbours(i).all(|j| of[j] == ALONE);
        if untouched && neighbours(i).next().is_some() {
            of[i] = count;
            neighbours(i).for_each(|j| of[j] = count);
            count += 1;
        }
    }

    let roots = of.clone();
    let mut couplings = Vec::new();
    for i in 0..n {
        if roots[i] == ALONE {
            couplings.clear();
            couplings.extend(neighbours(i).map(|j| roots[j]).filter(|&g| g != ALONE));
            couplings.sort_unstable();
            let largest = couplings.chunk_by(|a, b| a == b).rev().max_by_key(|group| group.len());
            of[i] = largest.map_or(ALONE, |group| group[0]);
        }
    }

    for i in 0..n {
        if of[i] == ALONE && neighbours(i).next().is_some() {
            of[i] = count;
            neighbours(i).filter(|&j| roots[j] == ALONE).for_each(|j| {
                if of[j] == ALONE {
                    of[j] = count;
                }
            });
            count += 1;
        }
    }
    (of, count as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_falls_into_triples_and_a_lone_unknown_stays_alone() {
        let chain = Pattern::from_elements(8, (0..6).map(|i| [i, i + 1])).unwrap();
        let strong: Vec<bool> =
            (0..8).flat_map(|i| chain.row(i).iter().map(move |&j| j as usize != i)).collect();
        let (of, count) = aggregate(&chain, &strong);
        assert_eq!((of, count), (vec![0, 0, 1, 1, 1, 2, 2, ALONE], 3));
    }

    #[test]
    fn every_coupled_unknown_is_in_exactly_one_aggregate() {
        let grid = |i: u32, j: u32| 7 * i + j;
        let edges = (0..6).flat_map(|i| (0..6).map(move |j| [grid(i, j), grid(i + 1, j), grid(i, j + 1)]));
        let pattern = Pattern::from_elements(49, edges).unwrap();
        let strong: Vec<bool> =
            (0..49).flat_map(|i| pattern.row(i).iter().map(move |&j| j as usize != i)).collect();
        let (of, count) = aggregate(&pattern, &strong);
        let coupled = |i: usize| pattern.row(i).len() > 1;
        assert!((0..49).all(|i| (of[i] == ALONE) != coupled(i)));
        assert!((0..count as u32).all(|g| of.contains(&g)));
    }
}
