//! Relaxation of the staggered iterations: x ← x + ω(H(x) − x), ω by the member.
//!
//! The fixed point x = H(x) is one pass of both solvers over the window. The factor is state: it is cloned with the
//! window and written into restart points.

mod aitken;
mod constant;
mod none;

#[cfg(test)]
mod conformance;

pub use aitken::Aitken;
pub use constant::Constant;
pub use none::None;

use serde::{Deserialize, Serialize};

/// How much of a residual is taken.
pub trait Relaxation {
    /// The user's key.
    const NAME: &'static str;
    /// The update in symbols.
    const FORMULA: &'static str;
    /// Where it is published.
    const SOURCE: &'static str;

    /// A window opens: what the iterations of the last one left is forgotten, save what the first of this one starts from.
    fn open(&mut self);

    /// ω \[-\] for the residual H(x) − x of this iteration.
    fn factor(&mut self, residual: &[f64]) -> f64;
}

/// The accelerations of the program, with their state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Acceleration {
    /// Every iterate as it comes.
    None(None),
    /// A constant part of every residual.
    Constant(Constant),
    /// Aitken's Δ².
    Aitken(Aitken),
}

impl Acceleration {
    /// Name, formula and source of every acceleration.
    pub fn explanations() -> [[&'static str; 3]; 3] {
        [explanation::<None>(), explanation::<Constant>(), explanation::<Aitken>()]
    }

    /// Name, formula and source of this one.
    pub fn explain(&self) -> [&'static str; 3] {
        match self {
            Acceleration::None(_) => explanation::<None>(),
            Acceleration::Constant(_) => explanation::<Constant>(),
            Acceleration::Aitken(_) => explanation::<Aitken>(),
        }
    }

    /// A window opens.
    pub fn open(&mut self) {
        match self {
            Acceleration::None(member) => member.open(),
            Acceleration::Constant(member) => member.open(),
            Acceleration::Aitken(member) => member.open(),
        }
    }

    /// x ← x + ω(H(x) − x); `iterate` is x, `residual` H(x) − x, of equal length throughout a window. Returns ω.
    pub fn relax(&mut self, iterate: &mut [f64], residual: &[f64]) -> f64 {
        let factor = match self {
            Acceleration::None(member) => member.factor(residual),
            Acceleration::Constant(member) => member.factor(residual),
            Acceleration::Aitken(member) => member.factor(residual),
        };
        for (x, r) in iterate.iter_mut().zip(residual) {
            *x += factor * r;
        }
        factor
    }
}

fn explanation<Member: Relaxation>() -> [&'static str; 3] {
    [Member::NAME, Member::FORMULA, Member::SOURCE]
}
