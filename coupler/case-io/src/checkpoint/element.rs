//! The numbers a bulk array may hold.

use serde::{Deserialize, Serialize};

/// The element type of a section, as stored in the header.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum ElementType {
    /// f64
    F64,
    /// u64
    U64,
    /// u32
    U32,
    /// u8
    U8,
}

impl ElementType {
    /// Bytes per element.
    pub(super) fn size(self) -> u64 {
        match self {
            Self::F64 | Self::U64 => 8,
            Self::U32 => 4,
            Self::U8 => 1,
        }
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f64 {}
    impl Sealed for u64 {}
    impl Sealed for u32 {}
    impl Sealed for u8 {}
}

/// A number that may fill a bulk array: f64, u64, u32 or u8.
pub trait Element: bytemuck::Pod + sealed::Sealed {
    /// Its type in the header.
    const TYPE: ElementType;
}

impl Element for f64 {
    const TYPE: ElementType = ElementType::F64;
}
impl Element for u64 {
    const TYPE: ElementType = ElementType::U64;
}
impl Element for u32 {
    const TYPE: ElementType = ElementType::U32;
}
impl Element for u8 {
    const TYPE: ElementType = ElementType::U8;
}
