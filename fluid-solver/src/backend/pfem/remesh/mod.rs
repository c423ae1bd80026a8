//! The mesh at t_{n+1}: which cells between the moved nodes are fluid.
