//! The element types of Gmsh that a mesh here can hold.

/// A linear simplex or a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ElementType {
    Point,
    Line,
    Triangle,
    Tetrahedron,
}

impl ElementType {
    /// Reads Gmsh's number; for another type gives its name.
    pub fn from_number(number: i32) -> Result<Self, String> {
        match number {
            15 => Ok(Self::Point),
            1 => Ok(Self::Line),
            2 => Ok(Self::Triangle),
            4 => Ok(Self::Tetrahedron),
            other => Err(foreign_name(other)),
        }
    }

    pub fn dimension(self) -> usize {
        match self {
            Self::Point => 0,
            Self::Line => 1,
            Self::Triangle => 2,
            Self::Tetrahedron => 3,
        }
    }

    pub fn node_count(self) -> usize {
        self.dimension() + 1
    }
}

fn foreign_name(number: i32) -> String {
    let name = match number {
        3 => "4-node quadrangle",
        5 => "8-node hexahedron",
        6 => "6-node prism",
        7 => "5-node pyramid",
        8 => "3-node second-order line",
        9 => "6-node second-order triangle",
        10 => "9-node second-order quadrangle",
        11 => "10-node second-order tetrahedron",
        12 => "27-node second-order hexahedron",
        13 => "18-node second-order prism",
        14 => "14-node second-order pyramid",
        16 => "8-node second-order quadrangle",
        17 => "20-node second-order hexahedron",
        18 => "15-node second-order prism",
        19 => "13-node second-order pyramid",
        20 | 21 => "third-order triangle",
        22..=25 => "triangle of order four or five",
        26..=28 => "line of order three to five",
        29..=31 => "tetrahedron of order three to five",
        _ => return format!("an element of the unknown type {number}"),
    };
    format!("a {name} (type {number})")
}
