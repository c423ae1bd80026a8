//! Sound cases that tests spoil in one place.

use std::fs;
use std::path::Path;

pub(crate) use super::load::resolve;
use super::{Case, Document, Overrides};
use crate::error::CaseError;
use crate::output::test_directory::TestDirectory;
use crate::tree::Source;

/// A sphere settling in still water, both sides, 3D.
pub(crate) const SETTLING: &str = r#"[case]
title = "settling"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[time]
end = "2 s"
window = "1 ms"
[materials.glass]
density = "2500 kg/m^3"
youngs-modulus = "5 MPa"
poissons-ratio = 0.3
[pairs.glass-glass]
restitution = 0.9
sliding-friction = 0.3
[grains]
normal-law = "hertz"
[[insertion]]
name = "bed"
material = "glass"
diameter = "2 mm"
at = [["0 m", "0 m", "0.5 m"], ["0 m", "0 m", "0.6 m"]]
[[wall]]
name = "floor"
material = "glass"
plane = { point = ["0 m", "0 m", "0 m"], normal = [0, 0, 1] }
[fluid]
backend = "eulerian"
density = "998.2 kg/m^3"
viscosity = "1.002 mPa s"
[fluid.mesh]
box = { lower = ["-1 m", "-1 m", "0 m"], upper = ["1 m", "1 m", "2 m"], cells = [10, 10, 20] }
[[fluid.boundary]]
on = ["x-min", "x-max", "y-min", "y-max", "z-min"]
kind = "no-slip"
[[fluid.boundary]]
on = ["z-max"]
kind = "outlet"
[coupling]
scheme = "serial-implicit"
drag = "di-felice"
[[probe]]
name = "centre"
at = ["0 m", "0 m", "0.5 m"]
"#;

/// A tank of moving nodes with a weir, 2D, no grains.
pub(crate) const TANK: &str = r#"[case]
title = "tank"
dimension = 2
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[time]
end = "1 s"
window = "1 ms"
[fluid]
backend = "pfem"
density = "1000 kg/m^3"
viscosity = "1 mPa s"
[fluid.mesh]
box = { lower = ["0 m", "0 m"], upper = ["2 m", "1 m"], size = "0.1 m" }
[[fluid.boundary]]
on = ["x-min", "y-min"]
kind = "slip"
[[fluid.boundary]]
on = ["x-max", "y-max"]
kind = "free-surface"
[[fluid.boundary]]
on = ["weir"]
kind = "slip"
[[wall]]
name = "weir"
polyline = { points = [["3 m", "0 m"], ["3 m", "1 m"]] }
"#;

/// Discs on a line, 2D, no fluid.
pub(crate) const DRY: &str = r#"[case]
title = "dry"
dimension = 2
depth = "1 cm"
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[time]
end = "1 s"
[materials.glass]
density = "2500 kg/m^3"
youngs-modulus = "5 MPa"
poissons-ratio = 0.3
[materials.steel]
density = "7800 kg/m^3"
youngs-modulus = "50 MPa"
poissons-ratio = 0.3
[pairs.glass-glass]
restitution = 0.9
sliding-friction = 0.3
[pairs.steel-glass]
restitution = 0.8
sliding-friction = 0.1
[grains]
normal-law = "hooke"
characteristic-velocity = "1 m/s"
domain = { lower = ["0 m", "0 m"], upper = ["1 m", "1 m"] }
periodic = ["x"]
[[insertion]]
name = "lattice"
material = "glass"
diameter = "2 mm"
lattice = { lower = ["0 m", "0 m"], upper = ["1 cm", "1 cm"], spacing = "2.2 mm", turn = "36.87 deg" }
[[wall]]
name = "floor"
material = "steel"
plane = { point = ["0 m", "0 m"], normal = [0, 2.0] }
"#;

/// Flow between plates, 2D, no grains.
pub(crate) const CHANNEL: &str = r#"[case]
title = "channel"
dimension = 2
gravity = ["0 m/s^2", "0 m/s^2"]
[time]
end = "1 s"
[fluid]
backend = "eulerian"
density = "1 g/cm^3"
viscosity = "1 mPa*s"
[fluid.mesh]
box = { lower = ["0 m", "0 m"], upper = ["4 cm", "1 cm"], size = "1 mm" }
[[fluid.boundary]]
on = ["y-min", "y-max"]
kind = "no-slip"
[[fluid.boundary]]
on = ["x-min"]
kind = "inlet"
speed = "0.2 m/s"
profile = "parabolic"
[[fluid.boundary]]
on = ["x-max"]
kind = "outlet"
"#;

/// Grains carried by a stated flow, 3D.
pub(crate) const CARRIED: &str = r#"[case]
title = "carried"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[time]
end = "1 s"
window = "1 ms"
[materials.glass]
density = "2500 kg/m^3"
[grains]
normal-law = "none"
[[insertion]]
name = "tracer"
material = "glass"
diameter = "10 um"
random-box = { lower = ["0 m", "0 m", "0 m"], upper = ["1 m", "1 m", "1 m"], count = 10 }
[fluid]
backend = "imposed"
density = "1.2 kg/m^3"
viscosity = "18 uPa s"
field = { velocity = ["0.1*sin(t)", "0", "0"], pressure = "1.2*9.81*(1-z)" }
[coupling]
scheme = "one-way"
drag = "stokes"
"#;

/// The document of a sound case.
pub(crate) fn document(text: &str) -> Document {
    let source = Source::parse(Path::new("case.toml"), text).unwrap();
    resolve(&source).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The message with which a case is refused once `from` is replaced by `to`.
pub(crate) fn refusal(sound: &str, from: &str, to: &str) -> String {
    document(sound);
    assert!(sound.contains(from), "the fixture has no {from}");
    let text = sound.replacen(from, to, 1);
    match Source::parse(Path::new("case.toml"), &text).and_then(|source| resolve(&source)) {
        Ok(_) => panic!("this is accepted:\n{text}"),
        Err(error) => error.to_string(),
    }
}

/// Every row: what is replaced, by what, and the message.
pub(crate) fn assert_refusals(sound: &str, rows: &[(&str, &str, &str)]) {
    let (found, wanted): (Vec<_>, Vec<_>) =
        rows.iter().map(|(from, to, message)| (refusal(sound, from, to), message.to_string())).unzip();
    assert_eq!(found, wanted);
}

/// A case in a folder `settling` of its own.
pub(crate) struct Folder(pub TestDirectory);

impl Folder {
    pub(crate) fn new(text: &str) -> Self {
        let folder = Self(TestDirectory::new());
        fs::create_dir(folder.0.path("settling")).unwrap();
        fs::write(folder.0.path("settling/case.toml"), text).unwrap();
        folder
    }

    pub(crate) fn load(&self, set: &[&str], variant: Option<&str>) -> Result<Vec<Case>, CaseError> {
        let set = set.iter().map(|argument| argument.to_string()).collect();
        Case::load(&self.0.path("settling"), &Overrides { set, variant: variant.map(str::to_string) })
    }

    /// The message, with the folder's path left out.
    pub(crate) fn refusal(&self, set: &[&str], variant: Option<&str>) -> String {
        let message = self.load(set, variant).unwrap_err().to_string();
        message.replace(&format!("{}/", self.0.root().display()), "")
    }
}
