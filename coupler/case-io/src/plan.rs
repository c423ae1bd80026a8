//! The plan of a case: which physics and algorithms are on, which are off, and why.

mod decide;

use std::fmt;

use serde::Serialize;

use crate::checkpoint::checksum;
use crate::document::Document;

macro_rules! parts {
    ($($part:ident: $name:literal,)*) => {
        /// A part of the physics or of the algorithm that a case may do without.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum Part {
            $(#[doc = concat!("The ", $name, ".")] $part,)*
        }

        impl Part {
            /// All parts, in the order of a window.
            pub const ALL: &[Self] = &[$(Self::$part),*];

            /// What it is called.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$part => $name,)*
                }
            }
        }
    };
}

parts! {
    Grains: "grains",
    Contacts: "contacts",
    ContactDamping: "contact damping",
    Friction: "friction",
    TangentialHistory: "tangential history",
    Rotation: "rotation",
    RollingResistance: "rolling resistance",
    TwistingResistance: "twisting resistance",
    Lubrication: "lubrication",
    Cohesion: "cohesion",
    Bonds: "bonds",
    Clumps: "clumps",
    PlaneWalls: "plane walls",
    RoundWalls: "round walls",
    TriangleWalls: "triangle walls",
    PeriodicWrap: "periodic wrap",
    InsertionOverTime: "insertion over time",
    FrozenGrains: "frozen grains",
    Deletion: "deletion",
    RemovalOfEscaped: "removal of escaped grains",
    CriticalSubstep: "critical substep",
    Sleep: "sleep of idle grains",
    Fluid: "fluid",
    FlowSolution: "flow solution",
    Convection: "convection",
    FluidGravity: "gravity on the fluid",
    BodyForce: "body force",
    BoundaryExpressions: "boundary expressions",
    Probes: "probes",
    Coupling: "coupling",
    TwoWay: "two-way coupling",
    VoidFraction: "void fraction",
    Drag: "drag",
    SelfDisturbance: "self-disturbance correction",
    AddedMass: "added mass",
    GivingWay: "grains giving way",
    ImplicitIterations: "implicit iterations",
    Acceleration: "acceleration of the iterations",
    Frames: "frames",
    RestartPoints: "restart points",
}

/// One part, on or off.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Item {
    /// The part.
    pub what: Part,
    /// Whether this case uses it.
    pub on: bool,
    /// What in the case says so.
    pub why: String,
}

/// All parts, on or off.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Plan {
    items: Vec<Item>,
}

impl Plan {
    /// Derives the plan from a loaded document.
    pub fn of(document: &Document) -> Self {
        let items = Part::ALL
            .iter()
            .map(|&what| {
                let (on, why) = decide::decide(what, document);
                Item { what, on, why }
            })
            .collect();
        Self { items }
    }

    /// Every part once, in the order of a window.
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// Whether a part is on.
    pub fn is_on(&self, part: Part) -> bool {
        self.items.iter().any(|item| item.what == part && item.on)
    }

    /// 64 bits in hexadecimal over what is on: participants with different plans refuse each other.
    pub fn hash(&self) -> String {
        let on: Vec<&str> = self.items.iter().filter(|item| item.on).map(|item| item.what.name()).collect();
        format!("{:016x}", checksum(on.join("\n").as_bytes()))
    }
}

impl fmt::Display for Plan {
    /// One line for each part: its name, on or off, why.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let width = Part::ALL.iter().map(|part| part.name().len()).max().unwrap_or(0);
        for Item { what, on, why } in &self.items {
            let state = if *on { "on " } else { "off" };
            writeln!(f, "{:width$}  {state}  {why}", what.name())?;
        }
        Ok(())
    }
}
