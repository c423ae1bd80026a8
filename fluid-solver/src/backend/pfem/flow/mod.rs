//! A step on the mesh at t_n: velocity and pressure of its middle, as one system.
