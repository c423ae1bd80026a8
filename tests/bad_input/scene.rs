//! Small sound cases; each test spoils one thing.

use crate::support::Folder;
use std::path::PathBuf;

/// Two grains sink in a box of water of 3 × 3 × 3 cells.
const COUPLED: &str = r#"[case]
title = "two grains sink in a box of water"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]

[time]
end = "20 ms"
window = "2 ms"

[output]
series = "2 ms"
frames = "10 ms"
restart = "4 ms"

[materials.glass]
density = "2500 kg/m^3"
youngs-modulus = "5 MPa"
poissons-ratio = 0.3

[pairs.glass-glass]
restitution = 0.9
sliding-friction = 0.3

[grains]
normal-law = "hertz"
domain = { lower = ["0 mm", "0 mm", "0 mm"], upper = ["30 mm", "30 mm", "30 mm"] }

[[insertion]]
name = "left"
material = "glass"
diameter = "1 mm"
at = [["14 mm", "15 mm", "20 mm"]]

[[insertion]]
name = "right"
material = "glass"
diameter = "1 mm"
at = [["17 mm", "15 mm", "20 mm"]]

[[wall]]
name = "floor"
material = "glass"
plane = { point = ["0 mm", "0 mm", "0 mm"], normal = [0, 0, 1] }

[fluid]
backend = "eulerian"
density = "1000 kg/m^3"
viscosity = "5 mPa s"

[fluid.mesh]
box = { lower = ["0 mm", "0 mm", "0 mm"], upper = ["30 mm", "30 mm", "30 mm"], cells = [3, 3, 3] }

[[fluid.boundary]]
on = ["x-min", "x-max", "y-min", "y-max", "z-min", "z-max"]
kind = "no-slip"

[coupling]
scheme = "serial-implicit"
drag = "di-felice"
"#;

/// One grain in a flow that is stated.
const CARRIED: &str = r#"[case]
title = "one grain in a stated flow"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]

[time]
end = "20 ms"
window = "2 ms"

[output]
series = "2 ms"
frames = "none"
restart = "4 ms"

[materials.glass]
density = "2500 kg/m^3"
youngs-modulus = "5 MPa"
poissons-ratio = 0.3

[grains]
normal-law = "hertz"

[[insertion]]
name = "grain"
material = "glass"
diameter = "1 mm"
at = [["0 mm", "0 mm", "0 mm"]]

[fluid]
backend = "imposed"
density = "1000 kg/m^3"
viscosity = "5 mPa s"
field = { velocity = ["0.1", "0", "0"], pressure = "-9810*z" }

[coupling]
scheme = "one-way"
drag = "di-felice"
"#;

/// A column of water in the corner of a tank, whose far wall is a line; no grains.
const TANK: &str = r#"[case]
title = "a column of water in a tank"
dimension = 2
gravity = ["0 m/s^2", "-9.81 m/s^2"]

[time]
end = "20 ms"
window = "2 ms"

[output]
series = "2 ms"
frames = "10 ms"
restart = "4 ms"

[fluid]
backend = "pfem"
density = "1000 kg/m^3"
viscosity = "1 mPa s"

[fluid.mesh]
box = { lower = ["0 m", "0 m"], upper = ["50 mm", "50 mm"], size = "5 mm" }

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
polyline.points = [["0.1 m", "0 m"], ["0.1 m", "1 m"]]
# moves
"#;

/// A case in a folder of its own.
pub struct Scene {
    pub folder: Folder,
    text: String,
}

impl Scene {
    fn new(text: &str) -> Scene {
        let scene = Scene { folder: Folder::new(), text: text.to_string() };
        scene.folder.write("case/case.toml", text);
        scene
    }

    pub fn coupled() -> Scene {
        Scene::new(COUPLED)
    }

    pub fn carried() -> Scene {
        Scene::new(CARRIED)
    }

    pub fn tank() -> Scene {
        Scene::new(TANK)
    }

    /// The case with one place of its text changed.
    pub fn with(mut self, from: &str, to: &str) -> Scene {
        assert_eq!(self.text.matches(from).count(), 1, "{from}");
        self.text = self.text.replace(from, to);
        self.folder.write("case/case.toml", &self.text);
        self
    }

    /// The case with one more file in its folder.
    pub fn with_file(self, name: &str, text: &str) -> Scene {
        self.folder.write(&format!("case/{name}"), text);
        self
    }

    /// The case's folder.
    pub fn path(&self) -> PathBuf {
        self.folder.join("case")
    }

    /// Where messages place this text: `case.toml:12: `, with the folder as given to the coupler.
    pub fn place(&self, text: &str) -> String {
        let at = self.text.find(text).unwrap_or_else(|| panic!("{text} is not in the case"));
        let line = self.text[..at].matches('\n').count() + 1;
        format!("{}:{line}: ", self.path().join("case.toml").display())
    }
}
