use fluid_solver::mesh::{Mesh, MeshError, MeshParts, PeriodicPairs};

/// Two triangles in a unit square, sides named.
fn square() -> MeshParts<2, 3> {
    MeshParts {
        points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        cells: vec![[0, 1, 2], [0, 2, 3]],
        boundary: vec![([0, 1], 0), ([1, 2], 1), ([2, 3], 0), ([3, 0], 1)],
        groups: vec!["floor".into(), "side".into()],
        periodic: vec![],
    }
}

fn fault(change: impl FnOnce(&mut MeshParts<2, 3>)) -> (MeshError, String) {
    let mut parts = square();
    change(&mut parts);
    let error = Mesh::new(parts).unwrap_err();
    (error.clone(), error.to_string())
}

#[test]
fn the_square_itself_is_sound() {
    let mesh = Mesh::new(square()).unwrap();
    assert_eq!(mesh.volumes(), [0.5, 0.5]);
    assert_eq!(mesh.size(), [1.0; 4]);
}

#[test]
fn each_fault_is_named_with_its_place_and_value() {
    use MeshError::*;
    assert_eq!(Mesh::<3, 4>::new(MeshParts::default()).unwrap_err(), Empty);
    assert!(matches!(fault(|p| p.points[2][1] = f64::NAN).0, NotFinite { point: 2, .. }));
    assert!(matches!(
        fault(|p| p.cells[1][2] = 9).0,
        NoSuchPoint { what: "cell", index: 1, point: 9, last: 3 }
    ));
    assert!(matches!(fault(|p| p.points.push([5.0; 2])).0, UnreferencedPoint { point: 4, .. }));
    let (error, text) = fault(|p| p.cells[1].swap(0, 1));
    assert!(matches!(error, CellVolume { cell: 1, volume: -0.5, .. }) && text.contains("inverted"), "{text}");
    let (error, text) = fault(|p| p.points[3] = [0.5, 0.5]);
    assert!(matches!(error, CellVolume { cell: 1, .. }) && text.contains("degenerate"), "{text}");
    assert!(matches!(fault(|p| p.points.iter_mut().for_each(|x| x[0] *= 1e300)).0, CellVolume { .. }));
    assert!(matches!(fault(|p| p.boundary.truncate(3)).0, FaceWithoutGroup { cell: 1, .. }));
    assert!(matches!(fault(|p| p.boundary.push(([0, 2], 0))).0, FaceNotOnBoundary { .. }));
    assert!(matches!(fault(|p| p.boundary.push(([1, 0], 1))).0, FaceListedTwice { .. }));
    assert!(matches!(fault(|p| p.boundary[0].1 = 2).0, NoSuchGroup { face: 0, group: 2, count: 2 }));
    assert!(matches!(fault(|p| p.groups.push("lid".into())).0, EmptyGroup { group } if group == "lid"));
    let third = |p: &mut MeshParts<2, 3>| {
        p.points.push([2.0, 1.0]);
        p.cells.push([0, 4, 2]);
    };
    assert!(matches!(fault(third).0, FaceShared { cells, .. } if cells == [0, 1, 2]));
}

#[test]
fn two_parts_without_a_common_face_are_refused() {
    let (error, text) = fault(|p| {
        p.points.extend([[3.0, 0.0], [4.0, 0.0], [3.0, 1.0]]);
        p.cells.push([4, 5, 6]);
        p.boundary.extend([([4, 5], 0), ([5, 6], 0), ([6, 4], 0)]);
    });
    assert!(matches!(error, MeshError::Disconnected { cell: 2, reached: 2, cells: 3, .. }), "{text}");
}

#[test]
fn periodic_sides_must_match_and_be_three_cells_apart() {
    let pairs = |pairs: &[(u32, u32)], axis| PeriodicPairs { axis, pairs: pairs.to_vec() };
    let refused = |list: Vec<PeriodicPairs>| fault(|p| p.periodic = list).1;
    assert!(refused(vec![pairs(&[(1, 0), (2, 3)], 0)]).contains("three cells"));
    assert!(refused(vec![pairs(&[(2, 0)], 0)]).contains("displaced"));
    assert!(refused(vec![pairs(&[], 0)]).contains("no pairs"));
    assert!(refused(vec![pairs(&[(1, 0)], 5)]).contains("dimension"));
    assert!(refused(vec![pairs(&[(1, 1)], 0)]).contains("zero"));
    assert!(refused(vec![pairs(&[(1, 9)], 0)]).contains("point 9"));
}
