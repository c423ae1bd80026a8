//! Remeshing in space.

use crate::support::{WATER, block, flow, gravity, largest_speed, tank, touch};
use fluid_solver::backend::Step;
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::flow::FlowFault;
use fluid_solver::backend::pfem::remesh::{Books, SpaceRemesher, TargetSize, energy};
use fluid_solver::backend::pfem::wall::Grip;

#[test]
fn trial() {
    let n: usize = std::env::var("N").map_or(6, |n| n.parse().unwrap());
    let h = 0.1 / n as f64;
    let mut cloud: Cloud<3, 4> = block([0.1, 0.05, 0.1], [n, n / 2, n], 0.0);
    let walls = tank([0.3, 0.05, 0.3], Grip::Slip);
    touch(&mut cloud, &walls);
    let mut books = Books::start(&cloud);
    let v0 = books.volume.target;
    let mut remesher = SpaceRemesher::default();
    let mut flow = flow(WATER, 1e-6);
    let e = |c: &Cloud<3, 4>| {
        let e = energy(c);
        e.kinetic + 9.81 * e.moment[2]
    };
    let e0 = e(&cloud);
    let mut time = 0.0;
    let (mut t_flow, mut t_mesh, mut steps, mut lost, mut its) = (0.0, 0.0, 0, 0, 0);
    let mut worst = 0f64;
    let mut next = 0.0;
    let end: f64 = std::env::var("T").map_or(0.3, |n| n.parse().unwrap());
    while time < end {
        let mut length = 1e-3f64;
        let c = std::time::Instant::now();
        loop {
            match flow.solve(&cloud, &walls, Step { time, length }, &gravity()) {
                Ok(s) => {
                    its += s.iterations;
                    s.advance(&mut cloud, Step { time, length });
                    break;
                }
                Err(FlowFault::Inverted { cell, bound, .. }) => {
                    lost += 1;
                    length = (0.5 * length).min(0.9 * bound);
                    if length < 1e-6 {
                        panic!("{time} {cell} {:?}", cloud.cells[cell].map(|n| cloud.place[n as usize]))
                    }
                }
                Err(f) => panic!("{time} {f:?}"),
            }
        }
        t_flow += c.elapsed().as_secs_f64();
        time += length;
        let c = std::time::Instant::now();
        let events = remesher.remesh(&mut cloud, &walls, time, &TargetSize::Constant(h), &mut books).unwrap();
        t_mesh += c.elapsed().as_secs_f64();
        steps += 1;
        worst = worst.max((books.volume.missing() / v0).abs());
        if time >= next {
            next += 0.02;
            let front = cloud.place.iter().map(|x| x[0]).fold(0.0, f64::max);
            println!(
                "t {time:.3} nodes {} cells {} front {front:.3} vol {:.2e} drops {:.1e} E/E0 {:.4} speed {:.2} lost {lost} its {its} {events:?}",
                cloud.place.len(),
                cloud.cells.len(),
                books.volume.missing() / v0,
                books.volume.drops / v0,
                e(&cloud) / e0,
                largest_speed(&cloud)
            );
        }
    }
    println!(
        "steps {steps} lost {lost} worst {worst:.2e} flow {:.1} us/node mesh {:.2} us/node\n{:?}",
        t_flow / steps as f64 / cloud.place.len() as f64 * 1e6,
        t_mesh / steps as f64 / cloud.place.len() as f64 * 1e6,
        books.volume
    );
}
