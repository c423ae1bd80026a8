//! Model problems.

use linear::{BlockCsr, Csr, Pattern};
use std::sync::Arc;

/// Nodes of a regular grid with n[k] nodes along axis k, the last axis fastest; and its edges with their axis.
fn edges<const D: usize>(n: [usize; D]) -> (usize, Vec<([u32; 2], usize)>) {
    let nodes = n.iter().product();
    let stride: [usize; D] = std::array::from_fn(|k| n[k + 1..].iter().product());
    let mut edges = Vec::new();
    for i in 0..nodes {
        for k in 0..D {
            if i / stride[k] % n[k] + 1 < n[k] {
                edges.push(([i as u32, (i + stride[k]) as u32], k));
            }
        }
    }
    (nodes, edges)
}

/// Graph Laplacian with a weight per edge: flux conditions all around.
pub fn neumann<const D: usize>(n: [usize; D], weight: impl Fn(usize, usize) -> f64) -> Csr {
    let (nodes, edges) = edges(n);
    let mut a = Csr::zeros(Arc::new(Pattern::from_elements(nodes, edges.iter().map(|e| e.0)).unwrap()));
    for ([i, j], axis) in edges {
        let (i, j, w) = (i as usize, j as usize, weight(i as usize, axis));
        for (row, column, value) in [(i, i, w), (j, j, w), (i, j, -w), (j, i, -w)] {
            a.add(row, column, value);
        }
    }
    a
}

/// The (2D+1)-point Laplacian, unknowns inside, zero all around.
pub fn dirichlet<const D: usize>(n: [usize; D]) -> Csr {
    let mut a = neumann(n, |_, _| 1.0);
    for i in 0..a.rows() {
        let slot = a.pattern().slot(i, i).unwrap();
        a.values_mut()[slot] = 2.0 * D as f64;
    }
    a
}

/// Linear triangles on n×n nodes sheared by x ← x + shear · y, flux conditions, and a small mass.
pub fn sheared_triangles(n: usize, shear: f64) -> Csr {
    let node = |i: usize, j: usize| (i * n + j) as u32;
    let place = |k: u32| {
        let (i, j) = (k as usize / n, k as usize % n);
        [i as f64 + shear * j as f64, j as f64]
    };
    let mut triangles = Vec::new();
    for i in 0..n - 1 {
        for j in 0..n - 1 {
            triangles.push([node(i, j), node(i + 1, j), node(i + 1, j + 1)]);
            triangles.push([node(i, j), node(i + 1, j + 1), node(i, j + 1)]);
        }
    }
    let mut a = Csr::zeros(Arc::new(Pattern::from_elements(n * n, &triangles).unwrap()));
    for t in &triangles {
        let x = t.map(place);
        // Edge opposite to each node; ∇Nᵢ·∇Nⱼ |T| = eᵢ·eⱼ / (4 |T|).
        let edge: [[f64; 2]; 3] = std::array::from_fn(|k| {
            let (p, q) = (x[(k + 1) % 3], x[(k + 2) % 3]);
            [q[0] - p[0], q[1] - p[1]]
        });
        let doubled_area = (edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0]).abs();
        for k in 0..3 {
            for l in 0..3 {
                let product = edge[k][0] * edge[l][0] + edge[k][1] * edge[l][1];
                a.add(t[k] as usize, t[l] as usize, product / (2.0 * doubled_area));
            }
            a.add(t[k] as usize, t[k] as usize, 1e-4 * doubled_area / 6.0);
        }
    }
    a
}

/// −Δu + w·∇u on the unit square, central differences, unknowns inside; `peclet` = w h / (2 ν) of the cells.
///
/// The wind w turns once around the centre, so that no order of the unknowns follows it.
pub fn convection_diffusion(n: usize, peclet: f64) -> Csr {
    let (_, edges) = edges([n, n]);
    let mut a = dirichlet([n, n]);
    for ([i, j], axis) in edges {
        let (i, j) = (i as usize, j as usize);
        let centre = |k: usize| k as f64 / (n - 1) as f64 - 0.5;
        let wind = if axis == 0 { 2.0 * centre(i % n) } else { -2.0 * centre(i / n) };
        a.add(i, j, peclet * wind);
        a.add(j, i, -peclet * wind);
    }
    a
}

/// Velocity matrix in two dimensions: convection and diffusion of each component, coupled by a rotation and a mass.
pub fn velocity(n: usize, peclet: f64, mass: f64) -> BlockCsr<2> {
    let scalar = convection_diffusion(n, peclet);
    let mut a = BlockCsr::zeros(scalar.pattern().clone());
    for (block, &value) in a.blocks_mut().iter_mut().zip(scalar.values()) {
        *block = [[value, 0.1 * value], [-0.1 * value, value]];
    }
    for i in 0..n * n {
        a.add(i, i, &[[mass, 0.0], [0.0, mass]]);
    }
    a
}

/// A right-hand side without structure, entries in [−0.5, 0.5).
pub fn rough(n: usize) -> Vec<f64> {
    let mut state = 1u64;
    let mut draw = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    (0..n).map(|_| draw()).collect()
}

/// ‖b − A x‖ / ‖b‖.
pub fn relative_residual(a: &Csr, b: &[f64], x: &[f64]) -> f64 {
    let mut r = b.to_vec();
    a.multiply_subtract(x, &mut r);
    linear::vector::norm(&r) / linear::vector::norm(b)
}

/// ‖x − y‖ / ‖y‖.
pub fn relative_difference(x: &[f64], y: &[f64]) -> f64 {
    let difference: Vec<f64> = x.iter().zip(y).map(|(x, y)| x - y).collect();
    linear::vector::norm(&difference) / linear::vector::norm(y)
}
