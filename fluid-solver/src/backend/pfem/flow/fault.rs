//! Why a step is refused.

/// Why a step is refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FlowFault {
    /// A cell would be strained too far: a smaller step is right.
    #[error(
        "cell {cell} at {place:?} would be turned over, swollen or sheared too far in the step of {length:.3e} s; allowed {bound:.3e} s: take a smaller step"
    )]
    Inverted {
        /// The cell.
        cell: usize,
        /// Its first corner (m).
        place: Vec<f64>,
        /// Δt tried (s).
        length: f64,
        /// Δt at which it would not be (s).
        bound: f64,
    },
    /// The geometry or the linear solver does not converge.
    #[error(
        "the step at t = {time} s: residual {residual:.3e} N after {passes} passes and {iterations} iterations, allowed {target:.3e} N, the largest part at {place:?}: take a smaller step"
    )]
    NotConverged {
        /// t_n (s).
        time: f64,
        /// Passes done.
        passes: u64,
        /// Linear iterations done.
        iterations: u64,
        /// Norm reached (N).
        residual: f64,
        /// Norm allowed (N).
        target: f64,
        /// The node with the largest force left (m).
        place: Vec<f64>,
    },
    /// Fluid comes to the back of a wall without thickness.
    #[error(
        "at {place:?} m it runs round the end of the wall \"{wall}\", which holds it on one side only; allowed: fluid in front of a wall; give the wall a thickness, make it longer, or put a [[fluid.outlet]] before its end"
    )]
    RoundEnd {
        /// Where it came from (m).
        place: Vec<f64>,
        /// The name of the wall.
        wall: String,
    },
    /// A number that is not finite.
    #[error(
        "node {node}: the {quantity} is {value} at t = {time} s; it must be finite: look at the forces and walls there"
    )]
    NonFinite {
        /// The node.
        node: usize,
        /// What.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// t_n (s).
        time: f64,
    },
    /// A matrix that cannot be used.
    #[error(transparent)]
    Linear(#[from] linear::Error),
}
