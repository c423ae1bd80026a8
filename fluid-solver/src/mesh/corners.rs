//! The cells around every node.

use super::Mesh;

/// For each node the cells around it, in ascending order, each with which of its corners the node is.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Corners {
    first: Vec<u32>,
    corners: Vec<(u32, u32)>,
}

impl Corners {
    /// Takes the cells of a mesh.
    pub fn relink<const D: usize, const N: usize>(&mut self, mesh: &Mesh<D, N>) {
        let Self { first, corners } = self;
        first.clear();
        first.resize(mesh.node_count() + 2, 0);
        let cells = 0..mesh.cells().len();
        for cell in cells.clone() {
            mesh.cell_nodes(cell).iter().for_each(|&node| first[node as usize + 2] += 1);
        }
        for node in 2..first.len() {
            first[node] += first[node - 1];
        }
        corners.resize(cells.len() * N, (0, 0));
        for cell in cells {
            for (local, node) in mesh.cell_nodes(cell).into_iter().enumerate() {
                let place = &mut first[node as usize + 1];
                corners[*place as usize] = (cell as u32, local as u32);
                *place += 1;
            }
        }
    }

    /// Cell and corner at a node.
    pub fn of(&self, node: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let range = self.first[node] as usize..self.first[node + 1] as usize;
        self.corners[range].iter().map(|&(cell, local)| (cell as usize, local as usize))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::generate::BoxMesh;

    #[test]
    fn every_corner_is_listed_once_and_leads_back_to_its_node() {
        let mesh = BoxMesh {
            lower: [0.0; 2],
            upper: [1.0; 2],
            cells: [3, 5],
            periodic: [true, false],
            jitter: None,
        };
        let mesh: Mesh<2, 3> = mesh.generate().unwrap();
        let mut corners = Corners::default();
        corners.relink(&mesh);
        corners.relink(&mesh);
        let mut listed = 0;
        for node in 0..mesh.node_count() {
            for (cell, local) in corners.of(node) {
                assert_eq!(mesh.cell_nodes(cell)[local], node as u32);
                listed += 1;
            }
        }
        assert_eq!(listed, 3 * mesh.cells().len());
    }
}
