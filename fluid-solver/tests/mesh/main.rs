//! Meshes: generators, checks, reader, search.

mod checks;
mod generators;
mod gmsh;
mod locate;
