//! Where a sparse matrix has entries: the part that many matrices on one mesh share.

use crate::Error;
use std::ops::Range;

/// Sparsity pattern in compressed rows; the columns of a row increase strictly.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pattern {
    columns: usize,
    /// Entries of row i are `row_start[i]..row_start[i + 1]`.
    row_start: Vec<u32>,
    column: Vec<u32>,
}

impl Pattern {
    /// Pattern with the given columns in each row.
    ///
    /// # Errors
    /// Columns outside `0..columns` or not strictly increasing, and more entries than 32-bit indices can count.
    pub fn from_rows<R>(columns: usize, rows: R) -> Result<Self, Error>
    where
        R: IntoIterator,
        R::Item: AsRef<[u32]>,
    {
        index(columns)?;
        let (mut row_start, mut column) = (vec![0], Vec::new());
        for (i, row) in rows.into_iter().enumerate() {
            let row = row.as_ref();
            if let Some(&outside) = row.iter().find(|&&j| j as usize >= columns) {
                return Err(Error::ColumnOutside { row: i, column: outside, columns });
            }
            if let Some(pair) = row.windows(2).find(|pair| pair[0] >= pair[1]) {
                return Err(Error::ColumnsUnsorted { row: i, before: pair[0], after: pair[1] });
            }
            column.extend_from_slice(row);
            row_start.push(index(column.len())?);
        }
        index(row_start.len())?;
        Ok(Self { columns, row_start, column })
    }

    /// Square pattern of a finite element matrix: row i couples to all nodes of all elements of node i, and to itself.
    ///
    /// An element is any list of node ids, in any order; a node without element keeps its diagonal.
    ///
    /// # Errors
    /// A node id outside `0..nodes`, and more entries than 32-bit indices can count.
    pub fn from_elements<L>(nodes: usize, elements: L) -> Result<Self, Error>
    where
        L: IntoIterator,
        L::Item: AsRef<[u32]>,
    {
        index(nodes)?;
        let (mut element_start, mut element_nodes) = (vec![0usize], Vec::new());
        for (e, element) in elements.into_iter().enumerate() {
            if let Some(&node) = element.as_ref().iter().find(|&&node| node as usize >= nodes) {
                return Err(Error::NodeOutside { element: e, node, nodes });
            }
            element_nodes.extend_from_slice(element.as_ref());
            element_start.push(element_nodes.len());
        }
        index(element_nodes.len())?;
        let incidence =
            Self::from_parts(element_start.iter().map(|&s| s as u32).collect(), element_nodes, nodes);
        let elements_of = incidence.transpose().0;

        let mut last_seen_in = vec![u32::MAX; nodes];
        let (mut row_start, mut column) = (vec![0], Vec::new());
        for i in 0..nodes {
            let first = column.len();
            last_seen_in[i] = i as u32;
            column.push(i as u32);
            for &e in elements_of.row(i) {
                for &j in incidence.row(e as usize) {
                    if last_seen_in[j as usize] != i as u32 {
                        last_seen_in[j as usize] = i as u32;
                        column.push(j);
                    }
                }
            }
            column[first..].sort_unstable();
            row_start.push(index(column.len())?);
        }
        Ok(Self { columns: nodes, row_start, column })
    }

    /// Trusts the caller: columns in range; sorted, unless the pattern is only transposed next.
    pub(crate) fn from_parts(row_start: Vec<u32>, column: Vec<u32>, columns: usize) -> Self {
        Self { columns, row_start, column }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.row_start.len() - 1
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of entries.
    pub fn entries(&self) -> usize {
        self.column.len()
    }

    /// Slots of the entries of a row.
    #[inline]
    pub fn slots(&self, row: usize) -> Range<usize> {
        self.row_start[row] as usize..self.row_start[row + 1] as usize
    }

    /// Columns of the entries of a row, increasing.
    #[inline]
    pub fn row(&self, row: usize) -> &[u32] {
        &self.column[self.slots(row)]
    }

    /// Columns of a range of slots.
    #[inline]
    pub fn columns_at(&self, slots: Range<usize>) -> &[u32] {
        &self.column[slots]
    }

    /// Slot of an entry, to be computed once and used in every assembly; `None` where there is no entry.
    #[inline]
    pub fn slot(&self, row: usize, column: usize) -> Option<usize> {
        let slots = self.slots(row);
        let position = self.column[slots.clone()].binary_search(&u32::try_from(column).ok()?).ok()?;
        Some(slots.start + position)
    }

    /// Slot of the diagonal of each row.
    ///
    /// # Errors
    /// Pattern not square, or a row without diagonal entry.
    pub fn diagonal_slots(&self) -> Result<Vec<u32>, Error> {
        self.require_square()?;
        let slot = |row| self.slot(row, row).map(|k| k as u32).ok_or(Error::SingularDiagonal { row });
        (0..self.rows()).map(slot).collect()
    }

    /// Pattern of the transpose, and for each of its slots the slot here.
    pub fn transpose(&self) -> (Self, Vec<u32>) {
        let mut next = vec![0u32; self.columns + 1];
        for &j in &self.column {
            next[j as usize + 1] += 1;
        }
        for j in 0..self.columns {
            next[j + 1] += next[j];
        }
        let row_start = next.clone();
        let (mut column, mut source) = (vec![0; self.entries()], vec![0; self.entries()]);
        for i in 0..self.rows() {
            for slot in self.slots(i) {
                let target = &mut next[self.column[slot] as usize];
                column[*target as usize] = i as u32;
                source[*target as usize] = slot as u32;
                *target += 1;
            }
        }
        (Self { columns: self.rows(), row_start, column }, source)
    }

    pub(crate) fn row_starts(&self) -> &[u32] {
        &self.row_start
    }

    pub(crate) fn column_indices(&self) -> &[u32] {
        &self.column
    }

    /// Confirms that values on this pattern fit a set-up made for another one.
    pub(crate) fn require_same(&self, other: &Self) -> Result<(), Error> {
        if std::ptr::eq(self, other) || self == other {
            Ok(())
        } else {
            Err(Error::PatternChanged { rows: self.rows(), entries: self.entries() })
        }
    }

    pub(crate) fn require_square(&self) -> Result<(), Error> {
        let (rows, columns) = (self.rows(), self.columns);
        if rows == columns { Ok(()) } else { Err(Error::NotSquare { rows, columns }) }
    }
}

/// A count as 32-bit index.
pub(crate) fn index(count: usize) -> Result<u32, Error> {
    u32::try_from(count).map_err(|_| Error::TooLarge { count })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_triangles_couple_all_but_the_opposite_corners() {
        let square = Pattern::from_elements(4, [[0, 1, 2], [3, 2, 1]]).unwrap();
        let rows: Vec<&[u32]> = (0..4).map(|i| square.row(i)).collect();
        assert_eq!(rows, [&[0, 1, 2][..], &[0, 1, 2, 3], &[0, 1, 2, 3], &[1, 2, 3]]);
        assert_eq!(square.slot(0, 3), None);
        assert_eq!(square.slot(1, 3), Some(6));
    }

    #[test]
    fn elements_may_mix_sizes_and_a_node_without_element_keeps_its_diagonal() {
        let elements: [&[u32]; 3] = [&[0, 1], &[], &[4, 0, 2]];
        let mixed = Pattern::from_elements(5, elements).unwrap();
        assert_eq!(mixed.row(3), [3]);
        assert_eq!(mixed.row(0), [0, 1, 2, 4]);
        assert_eq!(Pattern::from_elements(0, [[0u32; 0]; 0]).unwrap().rows(), 0);
    }

    #[test]
    fn transposing_twice_gives_the_pattern_back() {
        let wide = Pattern::from_rows(4, [&[0u32, 3][..], &[], &[1, 2, 3]]).unwrap();
        let (tall, source) = wide.transpose();
        assert_eq!((tall.rows(), tall.columns()), (4, 3));
        assert_eq!(tall.row(3), [0, 2]);
        assert_eq!(source, [0, 2, 3, 1, 4]);
        assert_eq!(tall.transpose().0, wide);
    }

    #[test]
    fn bad_indices_are_refused_with_their_place() {
        let outside = Pattern::from_elements(3, [[0, 1, 2], [1, 2, 3]]);
        assert_eq!(outside, Err(Error::NodeOutside { element: 1, node: 3, nodes: 3 }));
        let twice = Pattern::from_rows(3, [[0, 1], [2, 2]]);
        assert_eq!(twice, Err(Error::ColumnsUnsorted { row: 1, before: 2, after: 2 }));
        let beyond = Pattern::from_rows(2, [[0, 2]]);
        assert_eq!(beyond, Err(Error::ColumnOutside { row: 0, column: 2, columns: 2 }));
        let bare = Pattern::from_rows(2, [&[0u32][..], &[0]]).unwrap();
        assert_eq!(bare.diagonal_slots(), Err(Error::SingularDiagonal { row: 1 }));
    }
}
