//! The shape of a rigid body.

use nalgebra::{Matrix3, Rotation3, SymmetricEigen, UnitQuaternion};

use super::{Body, BodyError, MassProperties, Mobility};
use crate::vector::Vector;

/// A principal moment may be larger than the sum of the others by this fraction: flat bodies, rounded.
const ROUNDING: f64 = 1e-9;

/// A sphere, or a disc, of a clump.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    /// Its centre, in the frame of the clump \[m\].
    pub offset: Vector<3>,
    /// r \[m\].
    pub radius: f64,
}

/// A rigid arrangement of members with its mass, in its principal frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Clump {
    members: Vec<Member>,
    mass: f64,
    moments: [f64; 3],
    centre: Vector<3>,
    axes: UnitQuaternion<f64>,
    mobilities: Vec<Mobility>,
}

impl Clump {
    /// Spheres of one density \[kg/m³\], in any frame.
    ///
    /// # Errors
    /// No member, a bad one, or no mass.
    pub fn of_spheres(members: &[Member], density: f64) -> Result<Self, BodyError> {
        check(members)?;
        Self::with_mass(members, &MassProperties::of_spheres(members, density))
    }

    /// Spheres with a stated mass, centre of mass and inertia.
    ///
    /// # Errors
    /// No member, a bad one, no mass, or an inertia that no matter has.
    pub fn with_mass(members: &[Member], properties: &MassProperties) -> Result<Self, BodyError> {
        check_mass(properties)?;
        let eigen = SymmetricEigen::new(properties.inertia);
        let mut order = [0, 1, 2];
        order.sort_by(|&one, &other| eigen.eigenvalues[one].total_cmp(&eigen.eigenvalues[other]));
        let [x, y] = [order[0], order[1]].map(|axis| Vector::from(eigen.eigenvectors.column(axis)));
        let axes = Matrix3::from_columns(&[x, y, x.cross(&y)]);
        let axes = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
        Self::new(members, properties, order.map(|axis| eigen.eigenvalues[axis]), axes)
    }

    /// Discs of one density \[kg/m³\] in the plane z = 0, in a slab of this depth \[m\].
    ///
    /// # Errors
    /// No member, a bad one, one off the plane, or no mass.
    pub fn of_discs(members: &[Member], density: f64, depth: f64) -> Result<Self, BodyError> {
        check(members)?;
        if let Some((member, off)) = members.iter().enumerate().find(|(_, m)| m.offset.z != 0.0) {
            return Err(BodyError::BadPlace { member, at: off.offset.into() });
        }
        let properties = MassProperties::of_discs(members, density, depth);
        // It turns about z only: any moments about x and y do, and like ones make the rotation exact.
        Self::new(members, &properties, [properties.inertia[(2, 2)]; 3], UnitQuaternion::identity())
    }

    fn new(
        members: &[Member],
        properties: &MassProperties,
        moments: [f64; 3],
        axes: UnitQuaternion<f64>,
    ) -> Result<Self, BodyError> {
        check(members)?;
        check_mass(properties)?;
        let [least, middle, most] = moments;
        if !(least > 0.0 && most.is_finite() && most <= (least + middle) * (1.0 + ROUNDING)) {
            return Err(BodyError::BadInertia { moments });
        }
        let MassProperties { mass, centre, .. } = *properties;
        let into_principal = |member: &Member| Member {
            offset: axes.inverse_transform_vector(&(member.offset - centre)),
            ..*member
        };
        let members: Vec<_> = members.iter().map(into_principal).collect();
        let mobilities = members.iter().map(|member| Mobility::of(member, mass, &moments)).collect();
        Ok(Self { members, mass, moments, centre, axes, mobilities })
    }

    /// A body of this shape: the clump's own frame lies at `origin` \[m\], turned by `rotation`; its centre of mass moves
    /// with `velocity` \[m/s\], and it spins with `angular_velocity` \[rad/s\].
    pub fn body(
        &self,
        origin: Vector<3>,
        rotation: UnitQuaternion<f64>,
        velocity: Vector<3>,
        angular_velocity: Vector<3>,
    ) -> Body {
        let orientation = rotation * self.axes;
        let spin = orientation.inverse_transform_vector(&angular_velocity);
        let momentum = spin.component_mul(&Vector::from(self.moments));
        Body {
            centre: origin + rotation * self.centre,
            orientation,
            velocity,
            angular_momentum: orientation * momentum,
        }
    }

    /// The members, in the principal frame.
    pub fn members(&self) -> &[Member] {
        &self.members
    }

    /// How it gives way where its members are pushed, in their order.
    pub fn mobilities(&self) -> &[Mobility] {
        &self.mobilities
    }

    /// Radius of the smallest sphere around its centre of mass that holds all members \[m\].
    pub fn bounding_radius(&self) -> f64 {
        self.members.iter().map(|member| member.offset.norm() + member.radius).fold(0.0, f64::max)
    }

    /// m \[kg\].
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Principal moments of inertia, ascending \[kg m²\].
    pub fn moments(&self) -> [f64; 3] {
        self.moments
    }
}

/// Finds what cannot be a member.
fn check(members: &[Member]) -> Result<(), BodyError> {
    if members.is_empty() {
        return Err(BodyError::NoMembers);
    }
    for (member, &Member { offset, radius }) in members.iter().enumerate() {
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(BodyError::BadRadius { member, radius });
        }
        if !offset.iter().all(|component| component.is_finite()) {
            return Err(BodyError::BadPlace { member, at: offset.into() });
        }
    }
    Ok(())
}

/// Finds what cannot be a mass, or is no inertia at all.
fn check_mass(&MassProperties { mass, inertia, .. }: &MassProperties) -> Result<(), BodyError> {
    if !(mass > 0.0 && mass.is_finite()) {
        return Err(BodyError::NoMass { mass });
    }
    if !inertia.iter().all(|component| component.is_finite()) {
        return Err(BodyError::BadInertia { moments: inertia.diagonal().into() });
    }
    Ok(())
}
