//! What a contact remembers, on its own.

use super::tangential::{Annuli, Spring};

/// All that one contact remembers.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    /// Its springs.
    pub spring: Spring,
    /// Its annuli, if the contacts of the scene slip in part.
    pub annuli: Option<Box<Annuli>>,
}

impl History {
    /// That of two bodies that do not touch.
    pub fn none() -> Self {
        Self { spring: Spring::relaxed(), annuli: None }
    }

    /// Whether the two bodies touched in the last step.
    pub fn is_active(&self) -> bool {
        self.spring.is_active()
    }

    /// The history as the second body sees it.
    pub fn reversed(self) -> Self {
        let annuli = self.annuli.map(|annuli| Box::new(annuli.reversed()));
        Self { spring: self.spring.reversed(), annuli }
    }

    /// Springs and annuli, these relaxed if there are none.
    pub fn parts(&self) -> (Spring, Annuli) {
        (self.spring, self.annuli.as_deref().copied().unwrap_or(Annuli::relaxed()))
    }

    /// Energy of the tangential spring \[J\].
    pub fn energy(&self) -> f64 {
        self.annuli.as_ref().map_or(self.spring.energy(), |annuli| annuli.energy(self.spring.stiffness))
    }
}
