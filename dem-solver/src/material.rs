//! Materials, and what two of them share when they touch.

use crate::contact::damping_ratio;

/// What a grain or a wall is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Density ρ \[kg/m³\].
    pub density: f64,
    /// Young's modulus E \[Pa\].
    pub youngs_modulus: f64,
    /// Poisson's ratio ν \[-\].
    pub poissons_ratio: f64,
}

/// Two materials in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairMaterial {
    /// Young's modulus of two halves in a row, 2/(1/E_i + 1/E_j) \[Pa\].
    pub youngs_modulus: f64,
    /// Mean Poisson's ratio \[-\].
    pub poissons_ratio: f64,
    /// E*, 1/E* = Σ (1 - ν²)/E \[Pa\].
    pub effective_modulus: f64,
    /// G*, 1/G* = Σ 2 (2 - ν)(1 + ν)/E \[Pa\].
    pub effective_shear_modulus: f64,
    /// Coefficient of restitution e \[-\].
    pub restitution: f64,
    /// Damping ratio ζ that gives the pair's restitution \[-\].
    pub damping_ratio: f64,
    /// Coefficient of sliding friction μ \[-\].
    pub sliding_friction: f64,
    /// Coefficient of rolling friction μ_r \[-\].
    pub rolling_friction: f64,
    /// Damping ratio η of rolling \[-\].
    pub rolling_damping_ratio: f64,
    /// Density k of cohesive energy \[J/m³\].
    pub cohesion_energy_density: f64,
    /// Work of adhesion w \[J/m²\].
    pub work_of_adhesion: f64,
    /// Surface tension γ of the liquid between them \[N/m\].
    pub surface_tension: f64,
    /// Contact angle θ of the liquid \[rad\].
    pub contact_angle: f64,
    /// Volume of a bridge of the liquid over r³ of the smaller grain \[-\].
    pub bridge_volume_ratio: f64,
}

impl PairMaterial {
    /// The pair of two materials with restitution e in (0, 1] and friction μ (Johnson 1985, Eqs. 4.22 and 7.43), that
    /// neither resist rolling nor cohere.
    pub fn new(one: &Material, other: &Material, restitution: f64, sliding_friction: f64) -> Self {
        let both = |compliance: fn(&Material) -> f64| 1.0 / (compliance(one) + compliance(other));
        Self {
            youngs_modulus: 2.0 * both(|m| 1.0 / m.youngs_modulus),
            poissons_ratio: 0.5 * (one.poissons_ratio + other.poissons_ratio),
            effective_modulus: both(|m| (1.0 - m.poissons_ratio.powi(2)) / m.youngs_modulus),
            effective_shear_modulus: both(|m| {
                2.0 * (2.0 - m.poissons_ratio) * (1.0 + m.poissons_ratio) / m.youngs_modulus
            }),
            restitution,
            damping_ratio: damping_ratio(restitution),
            sliding_friction,
            rolling_friction: 0.0,
            rolling_damping_ratio: 0.0,
            cohesion_energy_density: 0.0,
            work_of_adhesion: 0.0,
            surface_tension: 0.0,
            contact_angle: 0.0,
            bridge_volume_ratio: 0.0,
        }
    }
}

/// The materials of a scene and all their pairs.
#[derive(Clone, Debug, PartialEq)]
pub struct Materials {
    list: Vec<Material>,
    micro: Vec<bool>,
    pairs: Vec<PairMaterial>,
}

impl Materials {
    /// Materials and, for each two of them, restitution and sliding friction.
    pub fn new(list: Vec<Material>, touch: impl Fn(usize, usize) -> (f64, f64)) -> Self {
        let pairs = (0..list.len())
            .flat_map(|a| (0..list.len()).map(move |b| (a.min(b), a.max(b))))
            .map(|(a, b)| {
                let (restitution, sliding_friction) = touch(a, b);
                PairMaterial::new(&list[a], &list[b], restitution, sliding_friction)
            })
            .collect();
        let micro = vec![false; list.len()];
        Self { list, micro, pairs }
    }

    /// The materials with more said of each pair.
    pub fn with(mut self, say: impl Fn(usize, usize, &mut PairMaterial)) -> Self {
        let count = self.list.len();
        for (k, pair) in self.pairs.iter_mut().enumerate() {
            let (one, other) = (k / count, k % count);
            say(one.min(other), one.max(other), pair);
        }
        self
    }

    /// The materials, those that `micro` names being of micro grains: they do not turn, and nothing rubs on them.
    ///
    /// Source: Oñate et al., Lagrangian analysis of multiscale particulate flows with the particle finite element method
    /// (2014), section 4: forces between microscopic particles act along the line of their centres.
    pub fn with_micro(mut self, micro: impl Fn(usize) -> bool) -> Self {
        self.micro = (0..self.list.len()).map(&micro).collect();
        self.with(|a, b, pair| {
            if micro(a) || micro(b) {
                (pair.sliding_friction, pair.rolling_friction) = (0.0, 0.0);
            }
        })
    }

    /// Whether grains of this material are micro grains.
    pub fn is_micro(&self, material: u32) -> bool {
        self.micro[material as usize]
    }

    /// The material of this index.
    pub fn get(&self, material: u32) -> &Material {
        &self.list[material as usize]
    }

    /// The pair of two materials.
    #[inline]
    pub fn pair(&self, one: u32, other: u32) -> &PairMaterial {
        &self.pairs[one as usize * self.list.len() + other as usize]
    }

    /// All pairs.
    pub fn pairs(&self) -> &[PairMaterial] {
        &self.pairs
    }

    /// Number of materials.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Largest damping ratio of all pairs.
    pub fn largest_damping_ratio(&self) -> f64 {
        self.pairs.iter().map(|pair| pair.damping_ratio).fold(0.0, f64::max)
    }

    /// Whether any pair rubs.
    pub fn rub(&self) -> bool {
        self.pairs.iter().any(|pair| pair.sliding_friction > 0.0)
    }
}
