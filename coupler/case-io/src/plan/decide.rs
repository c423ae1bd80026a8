//! Whether a part is on, and what in the case says so.

use super::Part;
use crate::document::{
    Acceleration, Backend, BoundaryVelocity, Coupling, Document, Drag, Escape, Fluid, Grains, Insertion,
    NormalLaw, Pair, Placement, Scheme, WallShape,
};

type Decision = (bool, String);

pub(super) fn decide(part: Part, document: &Document) -> Decision {
    match part {
        Part::Grains
        | Part::Contacts
        | Part::ContactDamping
        | Part::Friction
        | Part::TangentialHistory
        | Part::Rotation
        | Part::RollingResistance
        | Part::TwistingResistance
        | Part::Lubrication
        | Part::Cohesion
        | Part::Bonds
        | Part::Clumps
        | Part::PlaneWalls
        | Part::RoundWalls
        | Part::TriangleWalls
        | Part::PeriodicWrap
        | Part::InsertionOverTime
        | Part::FrozenGrains
        | Part::Deletion
        | Part::RemovalOfEscaped
        | Part::CriticalSubstep
        | Part::Sleep => match &document.grains {
            Some(grains) => of_grains(part, document, grains),
            None => off("there is no [grains]"),
        },
        Part::Fluid
        | Part::FlowSolution
        | Part::Convection
        | Part::FluidGravity
        | Part::BodyForce
        | Part::BoundaryExpressions
        | Part::Probes => match &document.fluid {
            Some(fluid) => of_fluid(part, document, fluid),
            None => off("there is no [fluid]"),
        },
        Part::Coupling
        | Part::TwoWay
        | Part::VoidFraction
        | Part::Drag
        | Part::SelfDisturbance
        | Part::AddedMass
        | Part::GivingWay
        | Part::ImplicitIterations
        | Part::Acceleration => match &document.coupling {
            Some(coupling) => of_coupling(part, coupling),
            None => off("there is no [coupling]"),
        },
        Part::Frames => interval("frames", document.output.frames(document.time.end)),
        Part::RestartPoints => interval("restart", document.output.restart(document.time.end)),
    }
}

fn on(why: impl Into<String>) -> Decision {
    (true, why.into())
}

fn off(why: impl Into<String>) -> Decision {
    (false, why.into())
}

/// On because of these names, off if there are none.
fn named<'a>(what: &str, names: impl Iterator<Item = &'a str>) -> Decision {
    let names: Vec<&str> = names.collect();
    if names.is_empty() { off(format!("no {what}")) } else { on(format!("{what}: {}", names.join(", "))) }
}

/// The word by which the case names a choice.
fn word(choice: impl serde::Serialize) -> String {
    serde_json::to_string(&choice).unwrap_or_default()
}

/// On because the case chooses.
fn chosen(key: &str, choice: Option<impl serde::Serialize>) -> Decision {
    choice.map_or_else(|| off(format!("no {key}")), |choice| on(format!("{key} = {}", word(choice))))
}

fn of_grains(part: Part, document: &Document, grains: &Grains) -> Decision {
    let insertions = |is: fn(&Insertion) -> bool| {
        document
            .insertion
            .iter()
            .filter(move |insertion| is(insertion))
            .map(|insertion| insertion.name.as_str())
    };
    // A loaded document has a pair for every contact that is possible, and no other.
    let pairs = |is: fn(&Pair) -> bool| {
        document.pairs.iter().filter(move |(_, pair)| is(pair)).map(|(name, _)| name.as_str())
    };
    let walls = |is: fn(WallShape) -> bool| {
        document.wall.iter().filter(move |wall| wall.shape().is_some_and(is)).map(|wall| wall.name.as_str())
    };
    match part {
        Part::Contacts if grains.normal_law == NormalLaw::None => off("normal-law = \"none\""),
        Part::Contacts if document.pairs.is_empty() => off("a lone grain without walls"),
        Part::Contacts => on(format!("normal-law = {}", word(grains.normal_law))),
        Part::ContactDamping => named("pair with restitution below 1", pairs(|pair| pair.restitution < 1.0)),
        Part::Rotation | Part::Bonds if !document.bond.is_empty() => {
            on(format!("{} [[bond]]", document.bond.len()))
        }
        Part::Rotation if !document.clump.is_empty() => on(format!("{} [[clump]]", document.clump.len())),
        Part::Friction | Part::TangentialHistory | Part::Rotation => {
            named("pair with sliding-friction", pairs(|pair| pair.sliding_friction > 0.0))
        }
        Part::RollingResistance => chosen("rolling-law", grains.rolling_law),
        Part::TwistingResistance => chosen("twisting-law", grains.twisting_law),
        Part::Lubrication => match &grains.lubrication {
            Some(_) => on("[grains.lubrication]"),
            None => off("no [grains.lubrication]"),
        },
        Part::Cohesion => chosen("cohesion-law", grains.cohesion_law),
        Part::Bonds => off("no [[bond]]"),
        Part::Clumps => named("insertion of clumps", insertions(|i| i.clump.is_some())),
        Part::PlaneWalls => named("wall with plane", walls(|shape| matches!(shape, WallShape::Plane(_)))),
        Part::RoundWalls => named(
            "wall with cylinder or sphere",
            walls(|shape| matches!(shape, WallShape::Cylinder(_) | WallShape::Sphere(_))),
        ),
        Part::TriangleWalls => {
            let named_walls = walls(|shape| {
                !matches!(shape, WallShape::Plane(_) | WallShape::Cylinder(_) | WallShape::Sphere(_))
            });
            named("wall with polyline, stl, obj or mesh", named_walls)
        }
        Part::PeriodicWrap => {
            let axes: Vec<String> = grains.periodic.iter().map(word).collect();
            named("periodic axis", axes.iter().map(|axis| axis.trim_matches('"')))
        }
        Part::InsertionOverTime => {
            named("insertion with rate", insertions(|i| matches!(i.placement(), Some(Placement::Rate(_)))))
        }
        Part::FrozenGrains => named("frozen insertion", insertions(|i| i.frozen)),
        Part::Deletion => named("deletion", document.deletion.iter().map(|deletion| deletion.name.as_str())),
        Part::RemovalOfEscaped => {
            (grains.escape == Escape::Remove, format!("escape = {}", word(grains.escape)))
        }
        Part::CriticalSubstep => match document.time.substep {
            Some(substep) => off(format!("substep = \"{substep}\"")),
            None => on(format!("substep-safety = {}", document.time.substep_safety)),
        },
        Part::Sleep if grains.sleep.is_some() => on("[grains.sleep]"),
        Part::Sleep => off("no [grains.sleep]"),
        _ => on(format!("[grains], {} [[insertion]]", document.insertion.len())),
    }
}

fn of_fluid(part: Part, document: &Document, fluid: &Fluid) -> Decision {
    let backend = format!("backend = {}", word(fluid.backend));
    let solved = fluid.backend != Backend::Imposed;
    match part {
        Part::FluidGravity if solved => match document.case.gravity.to_array() == [0.0; 3] {
            true => off("gravity is 0"),
            false => on("gravity is not 0"),
        },
        Part::BodyForce if solved => match &fluid.body_force {
            Some(force) if force.to_array() != [0.0; 3] => on("body-force is not 0"),
            Some(_) => off("body-force is 0"),
            None => off("no body-force"),
        },
        Part::BoundaryExpressions => named(
            "boundary with expressions",
            fluid
                .boundary
                .iter()
                .filter(|boundary| matches!(boundary.velocity, Some(BoundaryVelocity::Expression(_))))
                .flat_map(|boundary| boundary.on.iter().map(String::as_str)),
        ),
        Part::Probes => named("probe", document.probe.iter().map(|probe| probe.name.as_str())),
        Part::Fluid => on(backend),
        _ => (solved, backend),
    }
}

fn of_coupling(part: Part, coupling: &Coupling) -> Decision {
    let scheme = format!("scheme = {}", word(coupling.scheme));
    let drag = format!("drag = {}", word(coupling.drag));
    let pushed = coupling.scheme != Scheme::OneWay;
    let iterated = coupling.scheme == Scheme::SerialImplicit;
    match part {
        Part::TwoWay | Part::VoidFraction => (pushed, scheme),
        Part::Drag => (coupling.drag != Drag::None, drag),
        Part::SelfDisturbance if coupling.drag == Drag::None => off(drag),
        Part::SelfDisturbance if !pushed => off(scheme),
        Part::SelfDisturbance => {
            (coupling.self_disturbance, format!("self-disturbance = {}", coupling.self_disturbance))
        }
        Part::AddedMass => (coupling.added_mass > 0.0, format!("added-mass = {}", coupling.added_mass)),
        Part::GivingWay => (coupling.scheme == Scheme::SerialExplicit, scheme),
        Part::ImplicitIterations if iterated => on(format!("{scheme}, at most {}", coupling.max_iterations)),
        Part::ImplicitIterations => off(scheme),
        Part::Acceleration if iterated => (
            coupling.acceleration != Acceleration::None,
            format!("acceleration = {}", word(coupling.acceleration)),
        ),
        Part::Acceleration => off(scheme),
        _ => on(scheme),
    }
}

fn interval(key: &str, interval: Option<f64>) -> Decision {
    interval.map_or_else(|| off(format!("{key} = \"none\"")), |seconds| on(format!("every {seconds} s")))
}

#[cfg(test)]
mod tests {
    use super::super::{Part, Plan};
    use crate::document::fixture::{CARRIED, CHANNEL, DRY, SETTLING, document};

    fn on(text: &str) -> Vec<Part> {
        Plan::of(&document(text)).items().iter().filter(|item| item.on).map(|item| item.what).collect()
    }

    #[test]
    fn a_case_pays_for_what_it_uses() {
        use Part::*;
        assert_eq!(on(CARRIED), [Grains, CriticalSubstep, Fluid, Coupling, Drag, Frames, RestartPoints]);
        assert_eq!(
            on(DRY),
            [
                Grains,
                Contacts,
                ContactDamping,
                Friction,
                TangentialHistory,
                Rotation,
                PlaneWalls,
                PeriodicWrap,
                CriticalSubstep,
                Frames,
                RestartPoints
            ]
        );
        assert_eq!(on(CHANNEL), [Fluid, FlowSolution, Convection, Frames, RestartPoints]);
        let without = [
            RollingResistance,
            TwistingResistance,
            Lubrication,
            Cohesion,
            Bonds,
            Clumps,
            RoundWalls,
            TriangleWalls,
            PeriodicWrap,
            InsertionOverTime,
            FrozenGrains,
            Deletion,
            RemovalOfEscaped,
            Sleep,
            BodyForce,
            BoundaryExpressions,
            AddedMass,
            GivingWay,
        ];
        assert_eq!(
            on(SETTLING),
            Part::ALL.iter().copied().filter(|part| !without.contains(part)).collect::<Vec<_>>()
        );
    }

    #[test]
    fn each_key_switches_its_part() {
        let grid = "[[insertion]]\nname = \"grid\"\nmaterial = \"glass\"\ndiameter = \"1 mm\"\nfrozen = true\n\
                    at = [[\"1 m\", \"0 m\", \"1 m\"]]\n";
        let region = r#"lower = ["0 m", "0 m", "0 m"], upper = ["1 m", "1 m", "1 m"]"#;
        let random = (
            format!("random-box = {{ {region}, count = 10 }}"),
            format!("rate = {{ {region}, number-rate = \"1 1/s\" }}"),
        );
        let friction = "sliding-friction = 0.3\n[grains]\n";
        let with = |said: &str, law: &str| format!("sliding-friction = 0.3\n{said}\n[grains]\n{law}\n");
        let rolling = with("rolling-friction = 0.1", "rolling-law = \"cdt\"");
        let cohesive = with("cohesion-energy-density = \"1 Pa\"", "cohesion-law = \"sjkr\"");
        let twisting = with("", "twisting-law = \"marshall\"");
        let film = "lubrication = { viscosity = \"1 mPa s\", roughness = \"1 um\", cut-off = \"1 mm\" }";
        let lubricated = with("", film);
        const BONDED: &str = "[[bond]]\nlaw = \"cohesive\"\ngap = \"1 m\"\nyoungs-modulus = \"1 Pa\"\npoissons-ratio = 0\n[[wall]]";
        for (base, from, to, part) in [
            (SETTLING, "drag = \"di-felice\"", "drag = \"none\"", Part::Drag),
            (SETTLING, "drag = \"di-felice\"", "drag = \"none\"", Part::SelfDisturbance),
            (SETTLING, "drag =", "self-disturbance = false\ndrag =", Part::SelfDisturbance),
            (SETTLING, "drag =", "added-mass = 0.5\ndrag =", Part::AddedMass),
            (SETTLING, "drag =", "acceleration = \"none\"\ndrag =", Part::Acceleration),
            (SETTLING, "serial-implicit", "serial-explicit", Part::ImplicitIterations),
            (SETTLING, "serial-implicit", "one-way", Part::TwoWay),
            (SETTLING, "serial-implicit", "one-way", Part::VoidFraction),
            (SETTLING, "\"-9.81 m/s^2\"", "\"0 m/s^2\"", Part::FluidGravity),
            (SETTLING, "[[insertion]]", &format!("{grid}[[insertion]]"), Part::FrozenGrains),
            (SETTLING, "[[insertion]]", "escape = \"remove\"\n[[insertion]]", Part::RemovalOfEscaped),
            (SETTLING, "[[insertion]]", "sleep = {}\n[[insertion]]", Part::Sleep),
            (SETTLING, "window =", "substep = \"1 us\"\nwindow =", Part::CriticalSubstep),
            (SETTLING, "[grains]", "[output]\nframes = \"none\"\n[grains]", Part::Frames),
            (SETTLING, "[grains]", "[output]\nrestart = \"none\"\n[grains]", Part::RestartPoints),
            (SETTLING, "sliding-friction = 0.3", "sliding-friction = 0", Part::Friction),
            (SETTLING, "sliding-friction = 0.3", "sliding-friction = 0", Part::Rotation),
            (SETTLING, "restitution = 0.9", "restitution = 1", Part::ContactDamping),
            (SETTLING, friction, &rolling, Part::RollingResistance),
            (SETTLING, friction, &twisting, Part::TwistingResistance),
            (SETTLING, friction, &lubricated, Part::Lubrication),
            (SETTLING, friction, &cohesive, Part::Cohesion),
            (SETTLING, "[[wall]]", BONDED, Part::Bonds),
            (SETTLING, "plane = {", "mesh = { boundary = [\"z-min\"] } #", Part::TriangleWalls),
            (SETTLING, "plane = {", "mesh = { boundary = [\"z-min\"] } #", Part::PlaneWalls),
            (CHANNEL, "density", "body-force = [\"1 m/s^2\", \"0 m/s^2\"]\ndensity", Part::BodyForce),
            (
                CHANNEL,
                "speed = \"0.2 m/s\"\nprofile = \"parabolic\"",
                "velocity = { expression = [\"y\", \"0\"] }",
                Part::BoundaryExpressions,
            ),
            (CARRIED, &random.0, &random.1, Part::InsertionOverTime),
        ] {
            let changed = base.replacen(from, to, 1);
            assert_ne!(
                Plan::of(&document(base)).is_on(part),
                Plan::of(&document(&changed)).is_on(part),
                "{to} does not switch {}",
                part.name()
            );
        }
    }

    #[test]
    fn the_hash_follows_what_is_on() {
        let hash = |text: &str| Plan::of(&document(text)).hash();
        assert_eq!(hash(SETTLING), hash(&SETTLING.replace("\"2 s\"", "\"3 s\"")));
        assert_ne!(hash(SETTLING), hash(&SETTLING.replace("sliding-friction = 0.3", "sliding-friction = 0")));
    }

    #[test]
    fn the_table_says_why() {
        let table = Plan::of(&document(DRY)).to_string();
        assert_eq!(table.lines().count(), Part::ALL.len());
        for line in [
            "contacts                        on   normal-law = \"hooke\"",
            "friction                        on   pair with sliding-friction: glass-glass, steel-glass",
            "triangle walls                  off  no wall with polyline, stl, obj or mesh",
            "periodic wrap                   on   periodic axis: x",
            "fluid                           off  there is no [fluid]",
            "drag                            off  there is no [coupling]",
            "restart points                  on   every 0.25 s",
        ] {
            assert!(table.lines().any(|found| found == line), "{line}\n{table}");
        }
    }
}
