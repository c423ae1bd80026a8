//! A unit cube of 6 tetrahedra around its diagonal, as Gmsh would write it.

/// Corners of the tetrahedra; point 1 + x + 2y + 4z is at (x, y, z).
pub const CELLS: [[u32; 4]; 6] =
    [[1, 2, 4, 8], [1, 2, 8, 6], [1, 3, 8, 4], [1, 3, 7, 8], [1, 5, 6, 8], [1, 5, 8, 7]];

/// The faces of the cube, two triangles each.
const FACES: [[u32; 3]; 12] = [
    [1, 2, 4],
    [1, 3, 4],
    [1, 2, 6],
    [1, 5, 6],
    [1, 3, 7],
    [1, 5, 7],
    [2, 4, 8],
    [2, 6, 8],
    [3, 4, 8],
    [3, 7, 8],
    [5, 6, 8],
    [5, 7, 8],
];

/// The file, in format 2.2, with named surfaces: all faces are in the first.
pub fn mesh_text(cells: &[[u32; 4]], surfaces: &[&str]) -> String {
    let mut text = format!("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n", surfaces.len());
    for (index, name) in surfaces.iter().enumerate() {
        text += &format!("2 {} \"{name}\"\n", index + 1);
    }
    text += "$EndPhysicalNames\n$Nodes\n8\n";
    for point in 0..8 {
        text += &format!("{} {} {} {}\n", point + 1, point & 1, point >> 1 & 1, point >> 2);
    }
    text += &format!("$EndNodes\n$Elements\n{}\n", FACES.len() + cells.len());
    for (index, [a, b, c]) in FACES.iter().enumerate() {
        text += &format!("{} 2 2 1 1 {a} {b} {c}\n", index + 1);
    }
    for (index, [a, b, c, d]) in cells.iter().enumerate() {
        text += &format!("{} 4 2 9 1 {a} {b} {c} {d}\n", FACES.len() + index + 1);
    }
    text + "$EndElements\n"
}
