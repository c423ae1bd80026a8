//! Faces of the surface, found by their corners.

/// No node.
const FREE: u32 = u32::MAX;

/// A table of faces; two that lie back to back are none.
#[derive(Clone, Debug, Default)]
pub struct Faces {
    slots: Vec<Slot>,
}

#[derive(Clone, Copy, Debug)]
struct Slot {
    /// Ascending; [`FREE`] where there is no face.
    corners: [u32; 3],
    /// How often the face turns as its ascending corners do, less how often it turns the other way.
    turns: i32,
    met: bool,
}

impl Faces {
    /// Fills the table; none was met yet.
    pub fn read(&mut self, faces: &[[u32; 3]]) {
        let free = Slot { corners: [FREE; 3], turns: 0, met: false };
        self.slots.clear();
        self.slots.resize((2 * faces.len() + 2).next_power_of_two(), free);
        for &face in faces {
            let (corners, turn) = ascending(face);
            let slot = self.slot(corners);
            self.slots[slot].corners = corners;
            self.slots[slot].turns += turn;
        }
    }

    /// Whether a face is one of the surface, turning as this one does, or the other way round; it is met now.
    #[inline]
    pub fn meet(&mut self, face: [u32; 3]) -> Option<bool> {
        let (corners, turn) = ascending(face);
        let slot = self.slot(corners);
        let slot = &mut self.slots[slot];
        slot.met = true;
        (slot.turns != 0).then_some(slot.turns * turn > 0)
    }

    /// Whether a face is one of the surface, turning as this one does, or the other way round.
    pub fn side(&self, face: [u32; 3]) -> Option<bool> {
        let (corners, turn) = ascending(face);
        let turns = self.slots[self.slot(corners)].turns;
        (turns != 0).then_some(turns * turn > 0)
    }

    /// Whether a face of the table was met.
    pub fn was_met(&self, face: [u32; 3]) -> bool {
        self.slots[self.slot(ascending(face).0)].met
    }

    /// Whether a face is one of the surface that was never met.
    pub fn is_missing(&self, face: [u32; 3]) -> bool {
        let slot = &self.slots[self.slot(ascending(face).0)];
        slot.turns != 0 && !slot.met
    }

    /// Where a face is, or would be.
    #[inline]
    fn slot(&self, corners: [u32; 3]) -> usize {
        let [a, b, c] = corners.map(u64::from);
        let key = a.wrapping_mul(0x9e37_79b9_7f4a_7c15)
            ^ b.wrapping_mul(0xc2b2_ae3d_27d4_eb4f)
            ^ c.wrapping_mul(0x1656_67b1_9e37_79f9);
        let last = self.slots.len() - 1;
        let mut slot = (key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) as usize & last;
        while self.slots[slot].corners != corners && self.slots[slot].corners[0] != FREE {
            slot = (slot + 1) & last;
        }
        slot
    }
}

/// The corners in ascending order, and 1 if they turn as before, else −1.
#[inline]
fn ascending([mut a, mut b, mut c]: [u32; 3]) -> ([u32; 3], i32) {
    let mut turn = 1;
    let mut order = |low: &mut u32, high: &mut u32| {
        if low > high {
            std::mem::swap(low, high);
            turn = -turn;
        }
    };
    order(&mut a, &mut b);
    order(&mut b, &mut c);
    order(&mut a, &mut b);
    ([a, b, c], turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_are_found_from_either_side_and_two_back_to_back_are_none() {
        let mut faces = Faces::default();
        faces.read(&[[3, 1, 2], [5, 6, 7], [7, 6, 5], [1, 2, 9]]);
        assert_eq!([[1, 2, 3], [2, 1, 3]].map(|face| faces.meet(face)), [Some(true), Some(false)]);
        assert_eq!([[5, 6, 7], [1, 2, 4]].map(|face| faces.meet(face)), [None, None]);
        assert_eq!(
            [[1, 2, 9], [1, 2, 3], [5, 6, 7]].map(|face| faces.is_missing(face)),
            [true, false, false]
        );
        assert_eq!(
            [[9, 1, 2], [2, 1, 9], [1, 2, 4]].map(|face| faces.side(face)),
            [Some(true), Some(false), None]
        );
    }
}
