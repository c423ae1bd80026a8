//! Tables of cases: boxes of fluid and walls.

/// Sides of a box, those of a plane first.
const SIDES: [&str; 6] = ["x-min", "x-max", "y-min", "y-max", "z-min", "z-max"];

/// Lengths as a list of the case.
pub fn lengths<const D: usize>(x: [f64; D]) -> String {
    let each = x.map(|x| format!("\"{x} m\""));
    format!("[{}]", each.join(", "))
}

/// A box of fluid, `wet` of whose sides lie against walls that it slips along; the others are free.
pub fn tank<const D: usize>(
    lower: [f64; D],
    upper: [f64; D],
    size: f64,
    keys: &str,
    wet: &[&str],
    further: &str,
) -> String {
    let (walls, free): (Vec<&str>, Vec<&str>) = SIDES[..2 * D].iter().partition(|side| wet.contains(side));
    let mut text = format!(
        "[fluid.mesh.box]\nlower = {}\nupper = {}\nsize = \"{size} m\"\n{keys}\n",
        lengths(lower),
        lengths(upper)
    );
    for (sides, kind) in [(free, "free-surface"), (walls, "slip")] {
        if !sides.is_empty() {
            text += &boundary(&sides, kind);
        }
    }
    text + further
}

/// What holds on some sides.
pub fn boundary(sides: &[&str], kind: &str) -> String {
    format!("[[fluid.boundary]]\non = {sides:?}\nkind = \"{kind}\"\n")
}

/// A plane wall that no side of the mesh is on.
pub fn plane<const D: usize>(name: &str, point: [f64; D], normal: [f64; D]) -> String {
    wall(name, &format!("plane = {{ point = {}, normal = {normal:?} }}", lengths(point)))
}

/// The shape of a wall in the plane.
pub fn polyline(points: &[[f64; 2]]) -> String {
    let points: Vec<String> = points.iter().map(|point| lengths(*point)).collect();
    format!("polyline.points = [{}]", points.join(", "))
}

/// A wall of some shape that no side of the mesh is on.
pub fn wall(name: &str, shape: &str) -> String {
    format!("{}[[wall]]\nname = \"{name}\"\n{shape}\n", boundary(&[name], "slip"))
}

/// Cells of a size (m) where a key of `[[fluid.pfem.refine]]` says so.
pub fn refined(place: &str, size: f64) -> String {
    format!("[[fluid.pfem.refine]]\n{place}\nsize = \"{size} m\"\n")
}

/// A ball of fluid (2D: a disc) that falls.
pub fn drop<const D: usize>(centre: [f64; D], radius: f64, speed: f64) -> String {
    let velocity = std::array::from_fn::<_, D, _>(|k| if k + 1 == D { -speed } else { 0.0 });
    let each = velocity.map(|v| format!("\"{v} m/s\""));
    format!(
        "[[fluid.body]]\nsphere = {{ centre = {}, radius = \"{radius} m\" }}\nvelocity = [{}]\n",
        lengths(centre),
        each.join(", ")
    )
}
