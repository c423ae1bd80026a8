//! Grains near walls, one by one: all but those that only planes at rest are near.

use crate::contact::{Coefficients, History};
use crate::domain::Image;
use crate::vector::Spin;

/// A grain and a surface of a wall near it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Row of the grain.
    pub grain: u32,
    /// Index of the surface.
    pub surface: u32,
    /// Which image of the grain's surroundings the surface is seen in.
    pub image: Image,
    /// Constants of the contact.
    pub coefficients: Coefficients,
}

/// A grain that touched a wall in the last step.
#[derive(Clone, Debug, PartialEq)]
pub struct WallContact {
    /// Row of the grain.
    pub grain: u32,
    /// Index of the wall.
    pub wall: u32,
    /// Unit normal, from the grain to the wall.
    pub normal: Spin,
    /// The tangential spring, and all the contact remembers besides.
    pub spring: History,
}
