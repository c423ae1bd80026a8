//! What stays the same during a run: materials, walls, laws, gravity, the domain.

use crate::body::ClumpKind;
use crate::bond::BondLaw;
use crate::contact::{Coefficients, ExtraConstants, Extras, NormalLaw, normal::Normal};
use crate::deletion::Deletion;
use crate::domain::Domain;
use crate::material::Materials;
use crate::sleep::SleepBound;
use crate::vector::Vector;
use crate::wall::Walls;

/// What happens when a grain leaves the domain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Escape {
    /// The run stops.
    #[default]
    Stop,
    /// The grain is removed at the end of the window, and booked.
    Remove,
}

/// The constant part of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene<const D: usize> {
    /// Where grains may be.
    pub domain: Domain<D>,
    /// How far each image of the domain is, by its code.
    pub shifts: Vec<Vector<D>>,
    /// What happens to grains that leave the domain.
    pub escape: Escape,
    /// Acceleration of gravity g \[m/s²\].
    pub gravity: Vector<D>,
    /// Depth of the slab \[m\] (2D).
    pub depth: f64,
    /// Materials and their pairs.
    pub materials: Materials,
    /// The normal contact law.
    pub normal_law: NormalLaw,
    /// Laws besides normal and tangential force.
    pub extras: Extras,
    /// Laws of bonds.
    pub bond_laws: Vec<BondLaw>,
    /// Kinds of clumps.
    pub clumps: Vec<ClumpKind>,
    /// The walls.
    pub walls: Walls<D>,
    /// When idle grains sleep; nothing where none does.
    pub sleep: Option<SleepBound>,
    /// Where grains are taken out.
    pub deletions: Vec<Deletion<D>>,
}

impl<const D: usize> Scene<D> {
    /// A scene in all space, without walls or gravity.
    pub fn new(materials: Materials, normal_law: NormalLaw) -> Self {
        let domain = Domain::unbounded();
        Self {
            domain,
            shifts: domain.shifts(),
            escape: Escape::Stop,
            gravity: Vector::zeros(),
            depth: 1.0,
            materials,
            normal_law,
            extras: Extras::default(),
            bond_laws: vec![],
            clumps: vec![],
            walls: Walls::new(vec![]),
            sleep: None,
            deletions: vec![],
        }
    }

    /// The scene in this domain.
    pub fn in_domain(self, domain: Domain<D>) -> Self {
        Self { domain, shifts: domain.shifts(), ..self }
    }

    /// The scene with this gravity.
    pub fn with_gravity(self, gravity: [f64; D]) -> Self {
        Self { gravity: gravity.into(), ..self }
    }

    /// The scene with these walls.
    pub fn with_walls(self, walls: Walls<D>) -> Self {
        Self { walls, ..self }
    }

    /// The scene with these laws besides normal and tangential force.
    pub fn with_extras(self, extras: Extras) -> Self {
        Self { extras, ..self }
    }

    /// The scene with these laws of bonds.
    pub fn with_bond_laws(self, bond_laws: Vec<BondLaw>) -> Self {
        Self { bond_laws, ..self }
    }

    /// The scene with these kinds of clumps.
    pub fn with_clumps(self, clumps: Vec<ClumpKind>) -> Self {
        Self { clumps, ..self }
    }

    /// The scene in which idle grains sleep within this bound.
    pub fn with_sleep(self, bound: SleepBound) -> Self {
        Self { sleep: Some(bound), ..self }
    }

    /// Constants of the contact of two materials at this effective radius \[m\] and effective mass \[kg\]; nothing
    /// where nothing touches.
    pub fn coefficients(&self, materials: (u32, u32), radius: f64, mass: f64) -> Option<Coefficients> {
        let pair = self.materials.pair(materials.0, materials.1);
        match self.normal_law {
            NormalLaw::Hooke(law) => Some(Normal::<D>::coefficients(&law, pair, radius, mass)),
            NormalLaw::Hertz(law) | NormalLaw::HertzPartialSlip(law) => {
                Some(Normal::<D>::coefficients(&law, pair, radius, mass))
            }
            NormalLaw::Onate(law) => Some(Normal::<D>::coefficients(&law, pair, radius, mass)),
            NormalLaw::LiggghtsHooke(law) => Some(Normal::<D>::coefficients(&law, pair, radius, mass)),
            NormalLaw::LiggghtsHertz(law) => Some(Normal::<D>::coefficients(&law, pair, radius, mass)),
            NormalLaw::None => None,
        }
    }

    /// Constants of the laws besides normal and tangential force, of two materials whose contact has these
    /// coefficients, at this effective and this smaller radius \[m\] and inertia about the contact \[kg m²\].
    pub fn extra_constants(
        &self,
        materials: (u32, u32),
        coefficients: &Coefficients,
        (effective, smaller): (f64, f64),
        inertia: f64,
    ) -> ExtraConstants {
        let pair = self.materials.pair(materials.0, materials.1);
        let rolling = self.extras.rolling.map(|law| law.constants(coefficients, pair, effective, inertia));
        let cohesion = self.extras.cohesion.map(|law| law.constants(pair, effective, smaller));
        ExtraConstants {
            rolling: rolling.unwrap_or_default(),
            cohesion: cohesion.unwrap_or_default(),
            lubrication: self.extras.lubrication.map_or(0.0, |law| law.strength(effective)),
            effective_radius: effective,
        }
    }

    /// Largest gap over which a grain of this radius and any other body may act on each other \[m\].
    pub fn reach(&self, largest_radius: f64) -> f64 {
        let Extras { cohesion, lubrication, .. } = self.extras;
        let pairs = cohesion.iter().flat_map(|law| self.materials.pairs().iter().map(|pair| (*law, pair)));
        let reaches = pairs.map(|(law, pair)| law.constants(pair, largest_radius, largest_radius).reach);
        reaches.fold(lubrication.map_or(0.0, |lubrication| lubrication.cut_off), f64::max)
    }
}
