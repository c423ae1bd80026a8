//! Triangles as an ASCII STL file.

use std::fmt::Write;

use crate::wall::Facet;

/// The text of the file.
pub fn stl(facets: &[Facet<3>]) -> String {
    let mut text = String::from("solid wall\n");
    for facet in facets {
        let [a, b, c] = facet.vertices;
        let normal = (b - a).cross(&(c - a)).normalize();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "facet normal {} {} {}\nouter loop", normal.x, normal.y, normal.z);
        for vertex in facet.vertices {
            let _ = writeln!(text, "vertex {} {} {}", vertex.x, vertex.y, vertex.z);
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid wall\n"
}
