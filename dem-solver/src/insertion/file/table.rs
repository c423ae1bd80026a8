//! CSV with units in the header.

use super::FileGrain;
use super::columns::{Columns, Names};
use surface::Flaw;

const NAMES: Names = [
    "x[m]",
    "y[m]",
    "z[m]",
    "vx[m/s]",
    "vy[m/s]",
    "vz[m/s]",
    "wx[rad/s]",
    "wy[rad/s]",
    "wz[rad/s]",
    "diameter[m]",
];

pub(super) fn read(text: &str) -> Result<Vec<FileGrain>, Flaw> {
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line));
    let header = lines.next().map_or("", |(_, line)| line);
    let names: Vec<&str> = header.split(',').map(str::trim).collect();
    if let Some(unknown) = names.iter().find(|name| !NAMES.contains(name)) {
        return Err(Flaw::at(1, format!("unknown column {unknown:?}; allowed: {}", NAMES.join(", "))));
    }
    let columns = Columns::of(1, &names, &NAMES, 0.5)?;
    let rows = lines.filter(|(_, line)| !line.trim().is_empty());
    let grain = |(number, line): (usize, &str)| {
        columns.grain(number, &line.split(',').map(str::trim).collect::<Vec<_>>())
    };
    rows.map(grain).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_velocities_spins_and_radii_are_read() {
        let grains = read("x[m],y[m],vx[m/s],wz[rad/s],diameter[m]\n1,2,3,7,0.5\n\n4,5,6,8,1e-3\n").unwrap();
        let first = FileGrain {
            centre: [1.0, 2.0, 0.0],
            velocity: Some([3.0, 0.0, 0.0]),
            angular_velocity: Some([0.0, 0.0, 7.0]),
            radius: Some(0.25),
        };
        assert_eq!((grains[0], grains[1].radius), (first, Some(5e-4)));
    }

    #[test]
    fn messages_name_line_and_column() {
        let error = |text: &str| format!("grains.csv{}", read(text).unwrap_err());
        assert_eq!(error("x[m],y[m]\n1,oops\n"), "grains.csv:2: y[m]: \"oops\" is not a finite number");
        assert_eq!(error("x[m],y[m]\n1,nan\n"), "grains.csv:2: y[m]: \"nan\" is not a finite number");
        assert_eq!(error("x[m],y[m]\n1\n"), "grains.csv:2: 1 values where the header has 2");
        assert_eq!(error("x[m],z[m]\n1,2\n"), "grains.csv:1: no column \"y[m]\"; found: x[m], z[m]");
        assert!(error("x,y\n1,2\n").starts_with("grains.csv:1: unknown column \"x\"; allowed: x[m], "));
        assert_eq!(
            error("x[m],y[m],diameter[m]\n0,0,-1\n"),
            "grains.csv:2: diameter[m]: a radius of -0.5 m; it must be positive"
        );
    }
}
