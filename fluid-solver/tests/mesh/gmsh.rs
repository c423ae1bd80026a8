use fluid_solver::mesh::{Mesh, gmsh};
use std::path::{Path, PathBuf};

const FLAVOURS: [&str; 4] = ["2-text", "2-binary", "4-text", "4-binary"];

fn path(name: &str, flavour: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/meshes/{name}-{flavour}.msh"))
}

fn in_all_flavours<const D: usize, const N: usize>(name: &str) -> Mesh<D, N> {
    let meshes = FLAVOURS.map(|flavour| gmsh::read::<D, N>(&path(name, flavour)).unwrap());
    let [first, others @ ..] = &meshes;
    for (mesh, flavour) in others.iter().zip(&FLAVOURS[1..]) {
        assert_eq!(mesh.cells(), first.cells(), "{flavour}");
        assert_eq!(mesh.boundary(), first.boundary(), "{flavour}");
        assert_eq!(mesh.groups(), first.groups(), "{flavour}");
        // Text may be rounded in the last of 16 digits.
        let close = |a: &[f64; D], b: &[f64; D]| (0..D).all(|k| (a[k] - b[k]).abs() < 1e-15);
        assert!(mesh.points().iter().zip(first.points()).all(|(a, b)| close(a, b)), "{flavour}");
    }
    first.clone()
}

fn length_of_group<const D: usize, const N: usize>(mesh: &Mesh<D, N>, name: &str) -> f64 {
    let group = mesh.group(name);
    let faces = mesh.boundary().iter().filter(|face| Some(face.group) == group);
    faces.map(|face| mesh.area_vector(face).iter().map(|a| a * a).sum::<f64>().sqrt()).sum()
}

#[test]
fn the_four_flavours_of_a_periodic_plate_with_a_hole_are_one_mesh() {
    let mesh = in_all_flavours::<2, 3>("plate");
    assert_eq!(mesh.groups(), ["left", "right", "wall", "obstacle"]);
    let period = mesh.periodicity().0[0].unwrap();
    assert!((period.length - 2.0).abs() < 1e-12 && mesh.periodicity().0[1].is_none());
    assert_eq!(length_of_group(&mesh, "left"), 0.0, "periodic sides are no boundary");
    assert!((length_of_group(&mesh, "wall") - 4.0).abs() < 1e-12);
    let area: f64 = mesh.volumes().iter().sum();
    let hole = std::f64::consts::PI * 0.04;
    assert!(area > 2.0 - hole && area < 2.0 - 0.5 * hole, "a polygon in the circle, {area}");
}

#[test]
fn the_four_flavours_of_a_tank_are_one_mesh() {
    let mesh = in_all_flavours::<3, 4>("tank");
    assert_eq!(mesh.groups().len(), 3);
    let (bottom, top) = (length_of_group(&mesh, "bottom"), length_of_group(&mesh, "top"));
    let volume: f64 = mesh.volumes().iter().sum();
    let disc = std::f64::consts::PI / 4.0;
    assert!(bottom > 0.85 * disc && bottom < disc && top > 0.85 * disc && top < disc);
    assert!(volume > 0.85 * disc && volume < disc, "a polyhedron in the cylinder of height one: {volume}");
}

fn refusal<const D: usize, const N: usize>(bytes: &[u8]) -> String {
    gmsh::parse::<D, N>(Path::new("trial.msh"), bytes).unwrap_err().to_string()
}

#[test]
fn foreign_elements_are_refused_by_name_and_line() {
    let text = std::fs::read_to_string(path("plate", "2-text")).unwrap();
    let line = text.lines().position(|line| line == "$Elements").unwrap() + 3;
    let head = text.lines().nth(line - 1).unwrap();
    let number = head.split(' ').next().unwrap();
    let quadrangle = text.replacen(&format!("{head}\n"), &format!("{number} 3 2 1 1 1 2 3 4\n"), 1);
    let message = refusal::<2, 3>(quadrangle.as_bytes());
    assert!(
        message.contains("4-node quadrangle") && message.contains(&format!(":{line}: found")),
        "{message}"
    );
    let message = gmsh::read::<2, 3>(&path("tank", "4-binary")).unwrap_err().to_string();
    assert!(message.contains("Tetrahedron") && message.contains("dimension 2"), "{message}");
}

#[test]
fn files_of_other_versions_or_no_mesh_at_all_are_refused() {
    assert!(refusal::<2, 3>(b"").contains("$MeshFormat"));
    assert!(refusal::<2, 3>(b"solid cube").contains("\"solid\""));
    assert!(refusal::<2, 3>(b"$MeshFormat\n4 0 8\n$EndMeshFormat\n").contains("version 4"));
    assert!(refusal::<2, 3>(b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n").contains("no cells"));
    assert!(refusal::<2, 3>(b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1e3\n").contains(":5: found"));
    let missing = gmsh::read::<2, 3>(Path::new("/no/such.msh")).unwrap_err().to_string();
    assert!(missing.contains("/no/such.msh"), "{missing}");
}

#[test]
fn a_file_cut_anywhere_or_with_a_flipped_byte_never_panics() {
    for flavour in FLAVOURS {
        let bytes = std::fs::read(path("plate", flavour)).unwrap();
        let whole = gmsh::parse::<2, 3>(Path::new("whole"), &bytes).unwrap();
        for length in (0..bytes.len() - 2).step_by(7) {
            let cut = gmsh::parse::<2, 3>(Path::new("cut"), &bytes[..length]);
            // Only a cut before the last section, the periodic pairs, can go unseen.
            let unseen =
                |mesh: Mesh<2, 3>| mesh.volumes() == whole.volumes() && mesh.groups() == whole.groups();
            assert!(cut.is_err() || cut.is_ok_and(unseen), "{flavour} cut at {length}");
        }
        for position in (0..bytes.len()).step_by(5) {
            let mut flipped = bytes.clone();
            flipped[position] ^= 0x55;
            let _ = gmsh::parse::<2, 3>(Path::new("flipped"), &flipped);
        }
    }
}
