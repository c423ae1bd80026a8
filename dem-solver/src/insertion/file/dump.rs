//! LIGGGHTS text dumps, in SI units.

use super::FileGrain;
use super::columns::{Columns, Names};
use surface::Flaw;

const NAMES: Names = ["x", "y", "z", "vx", "vy", "vz", "omegax", "omegay", "omegaz", "radius"];

/// The grains of the last snapshot, in the order of their `id` where there is one.
pub(super) fn read(text: &str) -> Result<Vec<FileGrain>, Flaw> {
    let lines: Vec<&str> = text.lines().collect();
    let start = lines
        .iter()
        .rposition(|line| line.starts_with("ITEM: ATOMS"))
        .ok_or_else(|| Flaw::whole("no line \"ITEM: ATOMS\"; a LIGGGHTS dump has one before its rows"))?;
    let names: Vec<&str> = lines[start].split_whitespace().skip(2).collect();
    let columns = Columns::of(start + 1, &names, &NAMES, 1.0)?;
    let identity = names.iter().position(|name| *name == "id");
    let rows = lines.iter().enumerate().skip(start + 1).filter(|(_, line)| !line.trim().is_empty());
    let grain = |(index, line): (usize, &&str)| {
        let cells: Vec<&str> = line.split_whitespace().collect();
        let grain = columns.grain(index + 1, &cells)?;
        let id = identity.map_or(Ok(0), |at| cells[at].parse::<u64>());
        let id = id.map_err(|_| Flaw::at(index + 1, "id: it must be a whole number".into()))?;
        Ok((id, grain))
    };
    let mut grains = rows.map(grain).collect::<Result<Vec<_>, Flaw>>()?;
    grains.sort_by_key(|(id, _)| *id);
    let stated = lines[..start].iter().rposition(|line| line.starts_with("ITEM: NUMBER OF ATOMS"));
    let stated = stated.and_then(|at| lines[at + 1].trim().parse::<usize>().ok());
    match stated {
        Some(count) if count != grains.len() => Err(Flaw::whole(format!(
            "{} rows where {count} are announced; the dump was cut short, write it again",
            grains.len()
        ))),
        _ => Ok(grains.into_iter().map(|(_, grain)| grain).collect()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_snapshot_counts_in_the_order_of_identities() {
        let snapshot = |x: f64| {
            format!(
                "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id type x y z omegax omegay omegaz radius \n10 1 0 0 0 1 2 3 0.2\n9 1 {x} 0 0.5 4 5 6 0.1 \n"
            )
        };
        let grains = read(&(snapshot(0.25) + &snapshot(0.75))).unwrap();
        let first = FileGrain {
            centre: [0.75, 0.0, 0.5],
            velocity: None,
            angular_velocity: Some([4.0, 5.0, 6.0]),
            radius: Some(0.1),
        };
        assert_eq!((grains.len(), grains[0]), (2, first));
    }

    #[test]
    fn messages_name_line_and_column() {
        let error = |text: &str| format!("a.dump{}", read(text).unwrap_err());
        let head = "ITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS x y\n";
        assert!(error(&format!("{head}1 2\n")).starts_with("a.dump: 1 rows where 2 are announced"));
        assert_eq!(error(&format!("{head}1 2\n3 x\n")), "a.dump:5: y: \"x\" is not a finite number");
        assert!(error("ITEM: TIMESTEP\n").contains("no line \"ITEM: ATOMS\""));
    }
}
