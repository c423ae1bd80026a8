//! Drag laws, one a file: the exchange coefficient β of F = β(u − v) in the pressure-split (model A) equations.

mod di_felice;
mod di_felice_cylinder;
mod ergun;
mod gidaspow;
mod haider_levenspiel;
mod law;
mod none;
mod schiller_naumann;
mod slip;
mod stokes;
mod wen_yu;

#[cfg(test)]
mod conformance;

pub use di_felice::DiFelice;
pub use di_felice_cylinder::DiFeliceCylinder;
pub use ergun::Ergun;
pub use gidaspow::Gidaspow;
pub use haider_levenspiel::HaiderLevenspiel;
pub use law::{DragLaw, Explanation, Fitted};
pub use none::None;
pub use schiller_naumann::SchillerNaumann;
pub use slip::Slip;
pub use stokes::Stokes;
pub use wen_yu::WenYu;

/// From one line a law: the enum, the list of all, and the calls.
macro_rules! registry {
    ($($law:ident),+ $(,)?) => {
        /// The drag laws of the program.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Drag {
            $(#[doc = concat!("[`struct@", stringify!($law), "`]")] $law,)+
        }

        impl Drag {
            /// Every law.
            pub const ALL: &[Drag] = &[$(Drag::$law),+];

            /// β \[kg/s\] at a slip.
            #[inline]
            pub fn exchange_coefficient(self, slip: &Slip) -> f64 {
                match self {
                    $(Drag::$law => $law.exchange_coefficient(slip),)+
                }
            }

            /// Name, formula, validity and source.
            pub fn explain(self) -> Explanation {
                match self {
                    $(Drag::$law => Explanation {
                        name: $law::NAME,
                        formula: $law::FORMULA,
                        fitted: $law::FITTED,
                        validity: $law::VALIDITY,
                        source: $law::SOURCE,
                    },)+
                }
            }
        }
    };
}

registry! {
    None,
    Stokes,
    SchillerNaumann,
    HaiderLevenspiel,
    WenYu,
    Ergun,
    Gidaspow,
    DiFelice,
    DiFeliceCylinder,
}

impl Drag {
    /// The user's key.
    pub fn name(self) -> &'static str {
        self.explain().name
    }

    /// The law of this key.
    pub fn by_name(name: &str) -> Option<Drag> {
        Drag::ALL.iter().copied().find(|law| law.name() == name)
    }

    /// The grains that the law was fitted to.
    pub fn fitted(self) -> Fitted {
        self.explain().fitted
    }
}
