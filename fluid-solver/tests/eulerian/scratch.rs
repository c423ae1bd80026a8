use crate::support::*;
use fluid_solver::backend::eulerian::*;
use fluid_solver::backend::*;
use fluid_solver::boundary::*;
use fluid_solver::mesh::generate::Pipe;
use interface::frames::*;
use std::time::Instant;

#[test]
#[ignore]
fn cavity_speed() {
    let n: usize = std::env::var("N").map(|v| v.parse().unwrap()).unwrap_or(30);
    let properties = Properties { density: 1000.0, viscosity: 1e-3, gravity: [0.0; 3], tolerance: 1e-8 };
    let mesh = box_mesh::<3, 4>([0.0; 3], [1.0; 3], [n; 3], [false; 3], Some(0.1));
    let t = Instant::now();
    let mut flow = flow(mesh, properties, |name| match name { "z-max" => Condition::MovingWall(std::sync::Arc::new(|_, _| [1.0, 0.0,0.0])), _ => Condition::NoSlip });
    println!("setup {:?} nodes {}", t.elapsed(), flow.mesh().node_count());
    for k in 0..6 {
        let t = Instant::now();
        let it = advance(&mut flow, k as f64, 0.5 / n as f64, 1, |_, _| ());
        println!("step {:?} its {it}", t.elapsed());
    }
}
#[test]
#[ignore]
fn viscous_pipe() {
    for (rings, dt) in [(5, 1e-3), (5,1e-1),(10, 1e-4), (10, 1e-3),(10,1e-1)] {
    let properties = Properties { density: 1000.0, viscosity: 10.0, gravity: [0.0; 3], tolerance: 1e-8 };
    let mesh = Pipe { radius: 0.01, length: 0.04, rings, layers: rings*3 }.generate().unwrap();
    let mut flow = flow(mesh, properties, |name| match name { "inlet" => Condition::Inlet(Inflow::Speed{mean:0.02, profile: case_io::document::Profile::Parabolic}), "outlet" => Condition::Outlet{pressure:0.0}, _ => Condition::NoSlip });
    let t = Instant::now();
    let it = advance(&mut flow, 0.0, dt, 3, |_, _| ());
    let h = 0.01/rings as f64;
    println!("rings {rings} dt {dt} visc number {:.2e}: {:?} its/step {}", 10.0*dt/(1000.0*h*h), t.elapsed()/3, it/3);
    }
}
#[test]
#[ignore]
fn frozen_bed() {
    for (n, ratio) in [(10, 10.0), (10, 100.0), (10, 1000.0), (10, 1e4)] {
    let properties = Properties { density: 1000.0, viscosity: 1e-3, gravity: [0.0,0.0,-9.81], tolerance: 1e-8 };
    let mesh = box_mesh::<3, 4>([0.0; 3], [0.1; 3], [n; 3], [false; 3], Some(0.1));
    let flow = flow(mesh, properties, |name| match name { "z-min" => given(|_, _| [0.0, 0.0,0.02]), "z-max" => Condition::Outlet{pressure:0.0}, _ => Condition::Slip });
    let mut b = Eulerian::new(flow, Response::TwoWay, 1.0);
    let m = 20; let r = 0.1/m as f64*0.45;
    let mut grains = vec![];
    for i in 0..m*m*m/2 { let (x,y,z) = (i%m, i/m%m, i/m/m); let s=0.1/m as f64; grains.push(GrainRow{ id: i as u64, position: [(x as f64+0.5)*s,(y as f64+0.5)*s,(z as f64+0.5)*s], radius: r, mass: 1.0, ..Default::default()}); }
    b.populate(0.0, &grains).unwrap();
    let dt = 1e-3;
    let vol = 1e-3/(m*m*m) as f64;
    let row = ReactionRow{ exchange_coefficient: ratio*1000.0*vol/dt, ..Default::default() };
    for k in 0..3 {
    let t = Instant::now();
    b.save();
    let s = Step{time: k as f64*dt, length: dt};
    b.project(s, &grains).unwrap();
    let t1 = t.elapsed(); let t = Instant::now();
    let sol = b.solve(s, &vec![row; grains.len()]).unwrap();
    println!("n {n} ratio {ratio}: project {t1:?} solve {:?} its {}", t.elapsed(), sol.iterations);
    b.commit(s);
    }
    }
}
