//! Vectors of three components, each in lanes.

use std::ops::{Add, Mul, Neg, Sub};

use super::Lanes;

/// A vector per lane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Vec3<L> {
    /// First component.
    pub x: L,
    /// Second component.
    pub y: L,
    /// Third component.
    pub z: L,
}

impl<L: Lanes> Vec3<L> {
    /// The vector of these components.
    #[inline(always)]
    pub fn new(x: L, y: L, z: L) -> Self {
        Self { x, y, z }
    }

    /// Zero in every lane.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::new(L::splat(0.0), L::splat(0.0), L::splat(0.0))
    }

    /// a·b.
    #[inline(always)]
    pub fn dot(self, other: Self) -> L {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// a × b.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// |a|².
    #[inline(always)]
    pub fn norm_squared(self) -> L {
        self.dot(self)
    }

    /// The vector where the mask holds, else zero.
    #[inline(always)]
    pub fn only(self, mask: L::Mask) -> Self {
        Self::new(self.x.only(mask), self.y.only(mask), self.z.only(mask))
    }

    /// `yes` where the mask holds, else `no`.
    #[inline(always)]
    pub fn select(mask: L::Mask, yes: Self, no: Self) -> Self {
        Self::new(L::select(mask, yes.x, no.x), L::select(mask, yes.y, no.y), L::select(mask, yes.z, no.z))
    }

    /// The first components of three slices.
    #[inline(always)]
    pub fn load(x: &[f64], y: &[f64], z: &[f64]) -> Self {
        Self::new(L::load(x), L::load(y), L::load(z))
    }
}

impl<L: Lanes> Add for Vec3<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<L: Lanes> Sub for Vec3<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<L: Lanes> Neg for Vec3<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<L: Lanes> Mul<L> for Vec3<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: L) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}
