//! Coordination number.

use super::contacts::Contact;

/// How many touch how many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coordination {
    /// Grains that can move and touch anything, N_t.
    pub touching: usize,
    /// Contacts of two of them, N_c.
    pub between_grains: usize,
    /// Contacts of one of them with a wall or a frozen grain, N_w.
    pub on_walls: usize,
}

/// Counts the contacts of a world of so many grains.
pub fn coordination(contacts: &[Contact], grains: usize) -> Coordination {
    let mut touches = vec![false; grains];
    for contact in contacts {
        touches[contact.grain] = true;
        contact.other.into_iter().for_each(|other| touches[other] = true);
    }
    let between_grains = contacts.iter().filter(|contact| contact.other.is_some()).count();
    Coordination {
        touching: touches.into_iter().filter(|&touches| touches).count(),
        between_grains,
        on_walls: contacts.len() - between_grains,
    }
}

impl Coordination {
    /// Z = (2 N_c + N_w)/N_t, the mean number of contacts of a grain that touches anything; 0 if none does \[-\].
    pub fn mean(&self) -> f64 {
        (2 * self.between_grains + self.on_walls) as f64 / self.touching.max(1) as f64
    }
}
