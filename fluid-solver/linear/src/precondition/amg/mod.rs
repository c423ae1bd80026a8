//! Algebraic multigrid by smoothed aggregation.

mod aggregation;
mod coarse;
mod level;
mod product;
mod prolongator;
mod strength;

use crate::vector::remove_mean;
use crate::{Csr, Error, Preconditioner};
use coarse::Coarse;
use level::Level;

/// Vectors that the matrix maps to zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NullSpace {
    /// None: the matrix is positive definite.
    #[default]
    Empty,
    /// The constants: a Laplacian with flux conditions on the whole boundary of one connected domain.
    Constant,
}

/// How the hierarchy is built.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AmgOptions {
    /// θ in [0, 1): i and j are strongly coupled on level l if a_ij² > (θ/2ˡ)² a_ii a_jj.
    ///
    /// Zero, the default, takes every coupling: cheapest set-up, and new values never move the aggregates. 0.08 follows
    /// anisotropy and saves iterations on large regular meshes in 3D, but a refresh that moves a coupling across the
    /// threshold costs a new set-up.
    pub strength: f64,
    /// A level with at most so many unknowns is factored.
    pub coarse_size: usize,
    /// Vectors that the matrix maps to zero.
    pub null_space: NullSpace,
}

impl Default for AmgOptions {
    fn default() -> Self {
        Self { strength: 0.0, coarse_size: 400, null_space: NullSpace::Empty }
    }
}

/// One V-cycle with a forward Gauss–Seidel sweep down and a backward one up: symmetric, so fit for conjugate gradients.
///
/// With NullSpace::Constant the means of r and of z are removed: z = Π M⁻¹ Π r, Π = I − 1 1ᵀ/n.
///
/// Source: Vaněk, Mandel and Brezina, *Computing* 56 (1996) 179.
pub struct Amg {
    options: AmgOptions,
    levels: Vec<Level>,
    coarse: Coarse,
    scratch: Scratch,
}

struct Scratch {
    /// r without its mean.
    right: Vec<f64>,
    levels: Vec<LevelScratch>,
}

/// Residual on a level; right-hand side and correction on the next coarser one.
struct LevelScratch {
    residual: Vec<f64>,
    coarse_right: Vec<f64>,
    coarse_x: Vec<f64>,
}

impl LevelScratch {
    fn new(level: &Level) -> Self {
        let coarse = level.coarse().rows();
        Self {
            residual: vec![0.0; level.size()],
            coarse_right: vec![0.0; coarse],
            coarse_x: vec![0.0; coarse],
        }
    }
}

impl Amg {
    /// Builds the hierarchy of a symmetric matrix with positive diagonal.
    ///
    /// # Errors
    /// Not square, a coefficient not finite, a diagonal not positive or missing, a coarse matrix that cannot be factored.
    pub fn new(a: &Csr, options: AmgOptions) -> Result<Self, Error> {
        let mut levels: Vec<Level> = Vec::new();
        let mut strength = options.strength;
        let coarsest = loop {
            let finest_left = levels.last().map_or(a, Level::coarse);
            if finest_left.rows() <= options.coarse_size {
                break finest_left;
            }
            match Level::coarsen(finest_left, strength)? {
                Some(level) => levels.push(level),
                None => break finest_left,
            }
            strength *= 0.5;
        };
        let coarse = Coarse::new(coarsest.clone(), options.null_space)?;
        let mut scratch =
            Scratch { right: Vec::new(), levels: levels.iter().map(LevelScratch::new).collect() };
        if options.null_space == NullSpace::Constant {
            scratch.right = vec![0.0; a.rows()];
        }
        Ok(Self { options, levels, coarse, scratch })
    }

    /// Takes new values on the same pattern: the bits are those of a new set-up, the symbolic part is kept while the
    /// strong couplings stay where they are.
    ///
    /// # Errors
    /// As [`Self::new`], and another pattern. After an error the hierarchy must not be used before a refresh succeeds.
    pub fn refresh(&mut self, a: &Csr) -> Result<(), Error> {
        a.pattern().require_same(self.levels.first().map_or(self.coarse.pattern(), Level::pattern))?;
        let mut rest = self.levels.as_mut_slice();
        let mut values = a.values();
        while let Some((level, coarser)) = rest.split_first_mut() {
            if !level.refresh(values)? {
                *self = Self::new(a, self.options)?;
                return Ok(());
            }
            values = level.coarse().values();
            rest = coarser;
        }
        self.coarse.refresh(values)
    }

    /// Number of levels, the factored one included.
    pub fn levels(&self) -> usize {
        self.levels.len() + 1
    }

    /// Entries of all matrices relative to those of the finest.
    pub fn operator_complexity(&self) -> f64 {
        let coarse = self.coarse.pattern().entries();
        let entries = |level: &Level| level.pattern().entries();
        let all: usize = self.levels.iter().map(entries).sum::<usize>() + coarse;
        all as f64 / self.levels.first().map_or(coarse, entries).max(1) as f64
    }
}

impl Preconditioner for Amg {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let Self { options, levels, coarse, scratch } = self;
        match options.null_space {
            NullSpace::Empty => cycle(levels, coarse, &mut scratch.levels, r, z),
            NullSpace::Constant => {
                scratch.right.copy_from_slice(r);
                remove_mean(&mut scratch.right);
                cycle(levels, coarse, &mut scratch.levels, &scratch.right, z);
                remove_mean(z);
            }
        }
    }
}

/// x ← approximate solution of A x = b on the first of the levels.
fn cycle(levels: &[Level], coarse: &mut Coarse, scratch: &mut [LevelScratch], b: &[f64], x: &mut [f64]) {
    let (Some((level, coarser)), Some((here, below))) = (levels.split_first(), scratch.split_first_mut())
    else {
        return coarse.solve(b, x);
    };
    level.smooth_and_restrict(b, x, &mut here.residual, &mut here.coarse_right);
    cycle(coarser, coarse, below, &here.coarse_right, &mut here.coarse_x);
    level.correct_and_smooth(&here.coarse_x, b, x);
}
