//! Faces of the surface around each node.

/// A list of faces per node.
#[derive(Clone, Debug, Default)]
pub struct Fans {
    first: Vec<u32>,
    faces: Vec<u32>,
}

impl Fans {
    /// Reads the faces.
    pub fn read(&mut self, faces: &[[u32; 3]], nodes: usize) {
        self.first.clear();
        self.first.resize(nodes + 1, 0);
        for &node in faces.iter().flatten() {
            self.first[node as usize] += 1;
        }
        let mut end = 0;
        for first in &mut self.first {
            end += *first;
            *first = end;
        }
        self.faces.clear();
        self.faces.resize(end as usize, 0);
        for (index, face) in faces.iter().enumerate().rev() {
            for &node in face {
                let first = &mut self.first[node as usize];
                *first -= 1;
                self.faces[*first as usize] = index as u32;
            }
        }
    }

    /// Indices of the faces around a node, ascending.
    pub fn around(&self, node: u32) -> &[u32] {
        &self.faces[self.first[node as usize] as usize..self.first[node as usize + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_face_is_around_its_corners() {
        let mut fans = Fans::default();
        fans.read(&[[0, 1, 3], [3, 1, 4]], 5);
        assert_eq!(
            [0, 1, 2, 3, 4].map(|node| fans.around(node).to_vec()),
            [vec![0], vec![0, 1], vec![], vec![0, 1], vec![1]]
        );
    }
}
