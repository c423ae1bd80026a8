//! What stays constant in a contact as long as the two bodies do.

/// Stiffness and damping of a pair before they grow with the overlap, and its friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// Normal stiffness, N/m times the law's unit of growth.
    pub normal_stiffness: f64,
    /// Normal damping, N s/m times the law's unit of growth.
    pub normal_damping: f64,
    /// Tangential stiffness.
    pub tangential_stiffness: f64,
    /// Tangential damping.
    pub tangential_damping: f64,
    /// Coefficient of sliding friction μ \[-\].
    pub sliding_friction: f64,
    /// Effective mass m* of the two bodies \[kg\].
    pub effective_mass: f64,
}

/// How stiffness and damping grow with the overlap: factors on [`Coefficients`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Growth {
    /// Factor on the stiffnesses.
    pub stiffness: f64,
    /// Factor on the dampings.
    pub damping: f64,
}
