//! Linear (P1) simplices: triangles in the plane, tetrahedra in space.

pub mod closest_point;
pub mod quadrature;
pub mod simplex;
