//! What can be wrong with an interaction.

use super::Shape;
use super::drag::Drag;

/// Why the interaction of a grain with the fluid cannot be evaluated.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum InteractionError {
    /// The law was fitted to grains of another shape.
    #[error(
        "coupling.drag: the law \"{}\" is fitted to {}, the grains are {shape}; allowed: {}; choose one of them",
        law.name(), law.fitted(), laws_for(*shape)
    )]
    LawOfOtherShape {
        /// The law asked for.
        law: Drag,
        /// The grains of the scene.
        shape: Shape,
    },
    /// A coefficient of the case is out of range.
    #[error("{key}: found {value:e}; allowed: {allowed}; correct it")]
    Coefficient {
        /// The key of the case.
        key: &'static str,
        /// The value found.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// An input of a grain is out of range or not finite.
    #[error("grain {grain}: {quantity} is {value:e}; allowed: {allowed}; {advice}")]
    OutOfRange {
        /// Id of the grain.
        grain: u64,
        /// The quantity.
        quantity: &'static str,
        /// The value found.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
        /// What to do.
        advice: &'static str,
    },
    /// The grain's own disturbance of the fluid is too large to be corrected.
    #[error(
        "grain {grain}: its own force takes {disturbance:.3} of its slip out of the sampled fluid velocity (kernel width/diameter \
         {width_ratio:.3}, Re {reynolds:.2e}); allowed: at most 0.5; use a coarser mesh (a wider kernel) or set \
         coupling.self-disturbance = false"
    )]
    Disturbance {
        /// Id of the grain.
        grain: u64,
        /// χ s β \[-\].
        disturbance: f64,
        /// Kernel width over diameter \[-\].
        width_ratio: f64,
        /// Reynolds number of the sampled slip \[-\].
        reynolds: f64,
    },
}

/// Names of the laws that cover a shape, separated by commas.
fn laws_for(shape: Shape) -> String {
    let covering = Drag::ALL.iter().filter(|law| law.fitted().covers(shape));
    covering.map(|law| law.name()).collect::<Vec<_>>().join(", ")
}
