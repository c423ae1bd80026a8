//! From a case to a fluid of moving nodes.

use super::backend::{Pfem, Setting};
use super::body::Body;
use super::cloud::Cloud;
use super::first_mesh::refine;
use super::flow::{self, Control, Flow};
use super::gate::{self, Gates, Opening};
use super::remesh::{Grading, Near, Recognition, Remesher, Source, SpaceRemesher, TargetSize};
use super::renewal::Renewal;
use super::wall::{Wall, refuse_gaps, walls};
use crate::backend::{FluidBackend, Response};
use crate::boundary::velocity_field;
use crate::element::simplex::{Vector, distance, longest_edge, volume_and_gradients};
use crate::error::FluidError;
use crate::grains::Spreading;
use crate::mesh::bins::{Bins, bounds};
use crate::mesh::{self, Mesh};
use case_io::document::{self, Case, Dimension, Fluid, MeshSource, Region};

/// Circles of cells that are fluid are at most this many sizes in radius.
const ALPHA: f64 = 1.25;
/// A node this near to a wall touches it, in sizes; nearer to another node, both are one.
const TOUCHING: f64 = 1e-6;
/// What the size of cells gains per way from where they are fine, unless stated.
const GROWTH: f64 = 0.3;
/// Nodes are at most this many target sizes apart at the start; in an alpha shape as far as corners of its largest regular cell.
const SPARSE: f64 = 2.5;

/// The fluid of a case.
///
/// # Errors
/// A mesh, a body or a wall that is refused.
pub fn of(case: &Case, fluid: &Fluid, response: Response) -> Result<Box<dyn FluidBackend>, FluidError> {
    let has_mesh = fluid.mesh.is_some();
    let recognition = match fluid.pfem.as_ref().map(|pfem| pfem.recognition).unwrap_or_default() {
        document::Recognition::MovedDomain => Recognition::MovedDomain,
        document::Recognition::AlphaShape => Recognition::AlphaShape { alpha: ALPHA },
    };
    match case.document.case.dimension {
        Dimension::Two => {
            let mesh = has_mesh.then(|| mesh::case::plane(case, fluid)).transpose()?;
            let renewal = Box::new(Remesher::<2, 3>::new(recognition).under(lifted_against(case, fluid)));
            Ok(Box::new(backend::<2, 3>(case, fluid, mesh, (recognition, renewal), response)?))
        }
        Dimension::Three => {
            let mesh = has_mesh.then(|| mesh::case::space(case, fluid)).transpose()?;
            let renewal = Box::new(SpaceRemesher::new(recognition).under(lifted_against(case, fluid)));
            Ok(Box::new(backend::<3, 4>(case, fluid, mesh, (recognition, renewal), response)?))
        }
    }
}

fn backend<const D: usize, const N: usize>(
    case: &Case,
    fluid: &Fluid,
    mesh: Option<Mesh<D, N>>,
    (recognition, mut renewal): (Recognition, Box<dyn Renewal<D, N>>),
    response: Response,
) -> Result<Pfem<D, N>, FluidError> {
    let table = &case.document.case;
    let stated = fluid.pfem.as_ref().and_then(|pfem| pfem.size).map(|size| size.si());
    let first = mesh.as_ref().map(|mesh| start(fluid, mesh));
    let size = stated.or(first.as_ref().map(Body::mean_size)).unwrap_or_default();
    if let (Some(mesh), Some(size)) = (&mesh, stated) {
        refuse_coarse(case, mesh, size)?;
    }
    let mut walls = walls(case, fluid, mesh.as_ref())?;
    refuse_gaps(case, &walls, size)?;
    let (mut all, mut velocity) = bodies(case, fluid, first, size)?;
    let openings = gate::open(case, fluid, mesh.as_ref(), &mut walls, size, &mut all)?;
    velocity.resize(all.place.len(), [0.0; D]);
    refuse_unfit(case, &all, size, sparse::<D>(recognition))?;
    let outlets = gate::outlets(case, fluid, mesh.as_ref(), &walls, size, &all)?;
    let mut cloud = all.cloud();
    cloud.velocity = velocity;
    touch(case, &mut cloud, &walls, size)?;
    enter(&mut cloud, &walls, &openings);
    let size = target_size(fluid, size);
    refine(&mut cloud, &mut *renewal, &walls, &size)?;
    let setting = Setting {
        walls,
        size,
        acceleration: acceleration(case, fluid),
        response,
        spreading: spreading(fluid),
        density: fluid.density.si(),
        depth: if D == 2 { table.depth() } else { 1.0 },
        surface: mesh.as_ref().map(Mesh::surface),
    };
    let properties = flow::Fluid {
        density: fluid.density.si(),
        rheology: rheology(fluid),
        bulk_modulus: fluid.pfem.as_ref().and_then(|pfem| pfem.bulk_modulus).map(|modulus| modulus.si()),
    };
    let scheme = match fluid.pfem.as_ref().map(|pfem| pfem.scheme).unwrap_or_default() {
        document::FlowScheme::Monolithic => flow::Scheme::Monolithic,
        document::FlowScheme::Segregated => flow::Scheme::Segregated,
        document::FlowScheme::FractionalStep => flow::Scheme::FractionalStep,
    };
    let control = Control { tolerance: fluid.solve_tolerance(), scheme, ..Control::default() };
    Ok(Pfem::new(setting, cloud, Flow::new(properties, control), renewal, Gates::new(outlets)))
}

/// Gravity and body force (m/s²).
fn acceleration<const D: usize>(case: &Case, fluid: &Fluid) -> Vector<D> {
    let body_force = fluid.body_force.as_ref().map_or([0.0; D], |force| force.to_array());
    let gravity: Vector<D> = case.document.case.gravity.to_array();
    std::array::from_fn(|k| gravity[k] + body_force[k])
}

/// What remeshing lifts volume against: where there are grains it is they that raise the surface.
fn lifted_against<const D: usize>(case: &Case, fluid: &Fluid) -> Vector<D> {
    if case.document.grains.is_some() { [0.0; D] } else { acceleration(case, fluid) }
}

/// Target size of the cells: finer than `coarse` (m) where the case says so.
fn target_size(fluid: &Fluid, coarse: f64) -> TargetSize {
    let Some(pfem) = fluid.pfem.as_ref().filter(|pfem| !pfem.refine.is_empty()) else {
        return TargetSize::Constant(coarse);
    };
    let near = |stated: &document::Refinement| match (stated.near, stated.region()) {
        (_, Some(Region::Box(lower, upper))) => Near::Box(lower.to_array(), upper.to_array()),
        (_, Some(Region::Sphere(centre, radius))) => Near::Sphere(centre.to_array(), radius.si()),
        (Some(document::Near::Walls), _) => Near::Walls,
        (Some(document::Near::Grains), _) => Near::Grains,
        _ => Near::Surface,
    };
    let source = |stated| Source { near: near(stated), size: stated.size.si().min(coarse) };
    let sources = pfem.refine.iter().map(source).collect();
    let growth = pfem.growth.unwrap_or(GROWTH);
    TargetSize::Graded(Grading { coarse, growth, sources, by_grains: Vec::new() })
}

/// On which nodes grains act.
fn spreading(fluid: &Fluid) -> Spreading {
    match fluid.pfem.as_ref().map(|pfem| pfem.grains).unwrap_or_default() {
        document::GrainNodes::Kernel => Spreading::Kernel,
        document::GrainNodes::Nodal => Spreading::Nodal,
    }
}

/// What resists shear.
fn rheology(fluid: &Fluid) -> flow::Rheology {
    let viscosity = fluid.viscosity.si();
    match &fluid.rheology {
        None => flow::Rheology::Newtonian(flow::Newtonian { viscosity }),
        Some(stated) => flow::Rheology::HerschelBulkley(flow::HerschelBulkley {
            consistency: viscosity,
            exponent: stated.exponent(),
            yield_stress: stated.yield_stress.si(),
            creep_rate: stated.creep_rate(viscosity),
        }),
    }
}

/// The body that the mesh is, its top where the case states it.
fn start<const D: usize, const N: usize>(fluid: &Fluid, mesh: &Mesh<D, N>) -> Body<D, N> {
    let body = Body::of_mesh(mesh);
    let Some(MeshSource::Box(stated)) = fluid.mesh.as_ref().and_then(|mesh| mesh.source()) else {
        return body;
    };
    let Some(surface) = &stated.surface else { return body };
    let (lower, upper) = (stated.lower.to_array::<D>(), stated.upper.to_array::<D>());
    let height = |x: &Vector<D>| {
        let across = std::array::from_fn(|k| if k + 1 < D { x[k] } else { 0.0 });
        surface.evaluate(across, 0.0)
    };
    body.with_surface(lower[D - 1], upper[D - 1], height)
}

/// All bodies of the case, with their velocities.
fn bodies<const D: usize, const N: usize>(
    case: &Case,
    fluid: &Fluid,
    first: Option<Body<D, N>>,
    size: f64,
) -> Result<(Body<D, N>, Vec<Vector<D>>), FluidError> {
    let mut all = first.unwrap_or_default();
    let whole = velocity_field(fluid.velocity.as_ref());
    let mut velocity: Vec<Vector<D>> = all.place.iter().map(|x| whole(x, 0.0)).collect();
    for (index, stated) in fluid.body.iter().enumerate() {
        let key = format!("fluid.body[{index}]");
        let body = match stated.region() {
            Some(Region::Box(lower, upper)) => Body::of_box(lower.to_array(), upper.to_array(), size)?,
            Some(Region::Sphere(centre, radius)) => Body::of_sphere(centre.to_array(), radius.si(), size)
                .map_err(|error| case.error(&key, error, "", ""))?,
            _ => return Err(case.error(&key, "it has no shape", "box, sphere", "").into()),
        };
        let own = stated.velocity.as_ref().map_or(whole.clone(), |own| velocity_field(Some(own)));
        velocity.extend(body.place.iter().map(|x| own(x, 0.0)));
        all.join(body);
    }
    Ok((all, velocity))
}

/// Refuses cells larger than the mesh.
fn refuse_coarse<const D: usize, const N: usize>(
    case: &Case,
    mesh: &Mesh<D, N>,
    size: f64,
) -> Result<(), FluidError> {
    let (lower, upper) = bounds(mesh.nodes());
    let shortest = (0..D).map(|k| upper[k] - lower[k]).fold(f64::INFINITY, f64::min);
    if size <= shortest * (1.0 + TOUCHING) {
        return Ok(());
    }
    let allowed = format!("at most the shortest edge of the box around the mesh, {shortest:.3e} m");
    Err(case.error("fluid.pfem.size", format!("it is {size:.3e} m"), allowed, "").into())
}

/// How many target sizes nodes may be apart at the start: a regular simplex of edge e has the circumradius
/// e √(D/(2(D + 1))), and one larger than α h is no fluid of an alpha shape.
fn sparse<const D: usize>(recognition: Recognition) -> f64 {
    match recognition {
        Recognition::MovedDomain => SPARSE,
        Recognition::AlphaShape { alpha } => SPARSE.min(alpha * (2.0 * (D as f64 + 1.0) / D as f64).sqrt()),
    }
}

/// Refuses a fluid without volume, nodes more than `sparse` sizes apart, and nodes at one place.
fn refuse_unfit<const D: usize, const N: usize>(
    case: &Case,
    body: &Body<D, N>,
    size: f64,
    sparse: f64,
) -> Result<(), FluidError> {
    let least = TOUCHING * size.powi(D as i32);
    for cell in &body.cells {
        let vertices = body.vertices(cell);
        if volume_and_gradients(&vertices).0 <= least {
            let found = format!("the fluid at {:?} m has no volume", vertices[0]);
            return Err(case.error("fluid.mesh", found, "", "raise its surface above its bottom").into());
        }
    }
    let edge = |cell: &[u32; N]| (longest_edge(&body.vertices(cell)), cell[0]);
    let Some((longest, node)) = body.cells.iter().map(edge).reduce(|a, b| if b.0 > a.0 { b } else { a })
    else {
        return Err(case
            .error("fluid", "it has a volume of 0", "", "add [fluid.mesh] or [[fluid.body]]")
            .into());
    };
    if longest > sparse * size {
        let found =
            format!("{size:.3e} m, but at {:?} m nodes are {longest:.3e} m apart", body.place[node as usize]);
        let allowed = format!("{:.3e} m or more", longest / sparse);
        return Err(case
            .error("fluid.pfem.size", found, allowed, "make the mesh finer, or its cells alike")
            .into());
    }
    match twins(&body.place, TOUCHING * size) {
        Some(x) => {
            let found = format!("two nodes are at {x:?} m");
            Err(case.error("fluid", found, "", "take one away, or part the bodies").into())
        }
        None => Ok(()),
    }
}

/// A place with another nearer than `near` (m).
fn twins<const D: usize>(places: &[Vector<D>], near: f64) -> Option<Vector<D>> {
    let around = |x: &Vector<D>| (x.map(|c| c - near), x.map(|c| c + near));
    let bins = Bins::new(bounds(places), places.len(), places.len(), |node| around(&places[node]));
    places.iter().enumerate().find_map(|(node, x)| {
        let others = bins.bin(&bins.index(x)).iter().map(|&other| other as usize);
        others.filter(|&other| other > node).find(|&other| distance(x, &places[other]) < near).map(|_| *x)
    })
}

/// Finds the walls that nodes touch at the start.
fn touch<const D: usize, const N: usize>(
    case: &Case,
    cloud: &mut Cloud<D, N>,
    walls: &[Wall<D>],
    size: f64,
) -> Result<(), FluidError> {
    for (x, contacts) in cloud.place.iter().zip(&mut cloud.contacts) {
        for (index, wall) in walls.iter().enumerate().filter(|(_, wall)| wall.inflow.is_none()) {
            let gap = wall.touch(x, 0.0).gap;
            if gap < -TOUCHING * size {
                let found =
                    format!("the fluid at {x:?} m is {:.3e} m behind the wall \"{}\"", -gap, wall.name);
                let advice = "move the wall or the fluid, or turn the wall round";
                return Err(case.error("fluid", found, "fluid on the walls' own side", advice).into());
            }
            if gap <= TOUCHING * size {
                contacts.insert(index);
            }
        }
    }
    Ok(())
}

/// Puts nodes into inlets; they and the layers of cells before inlets have the velocity of what comes in.
fn enter<const D: usize, const N: usize>(cloud: &mut Cloud<D, N>, walls: &[Wall<D>], openings: &[Opening]) {
    for Opening { wall, nodes, layer } in openings {
        nodes.iter().for_each(|&node| cloud.contacts[node as usize].insert(*wall));
        let Some(inflow) = &walls[*wall].inflow else { continue };
        for node in nodes.iter().map(|&node| node as usize).chain(layer.clone()) {
            cloud.velocity[node] = inflow.stated(&cloud.place[node], 0.0);
        }
    }
}
