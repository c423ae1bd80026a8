//! Which walls a node touches.

/// A set of walls by index.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Contacts(u32);

impl Contacts {
    /// Walls that a set can tell apart.
    pub const MOST: usize = u32::BITS as usize;

    /// The set of these bits, one for each wall.
    pub fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    /// One bit for each wall.
    pub fn bits(self) -> u32 {
        self.0
    }

    /// Adds a wall.
    pub fn insert(&mut self, wall: usize) {
        self.0 |= 1 << wall;
    }

    /// Takes a wall away.
    pub fn remove(&mut self, wall: usize) {
        self.0 &= !(1 << wall);
    }

    /// Whether the wall is touched.
    pub fn contains(self, wall: usize) -> bool {
        self.0 >> wall & 1 == 1
    }

    /// Whether no wall is touched.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Walls that both touch.
    pub fn common(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// The walls, ascending.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..Self::MOST).filter(move |&wall| self.contains(wall))
    }
}
