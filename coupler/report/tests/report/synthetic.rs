//! Run directories as a run would leave them, without a run.

use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};

use case_io::exit_code::ExitCode;
use case_io::output::series::SeriesWriter;
use case_io::output::vtk::{Collection, Field, Format, GrainPoints, UnstructuredGrid};
use case_io::summary::{Check, Counts, Exit, LedgerMaximum, Seconds, Summary};

/// An empty directory of that name, kept after the test for whoever wants to look at it.
pub fn empty_directory(name: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&directory);
    for part in ["series", "frames"] {
        fs::create_dir_all(directory.join(part)).unwrap();
    }
    directory
}

pub fn summary() -> Summary {
    let check = |name: &str, value: f64, reference: f64, why: &str| Check {
        name: name.to_owned(),
        value,
        reference,
        tolerance: 0.02 * reference.abs(),
        pass: (value - reference).abs() <= 0.02 * reference.abs(),
        why: why.to_owned(),
    };
    let seconds = |wall: f64| Seconds { wall, cpu: 1.9 * wall };
    let ledger = |residual: f64, tolerance: f64| LedgerMaximum { residual, tolerance };
    Summary {
        case: "Settling of 2000 glass beads in water".to_owned(),
        case_hash: "9f86d081884c7d659a2feaa0c55ad015".to_owned(),
        program_version: "0.1.0".to_owned(),
        exit: Exit { code: ExitCode::CheckFailed, reason: "The bed is too high.".to_owned() },
        time: 0.5,
        seconds: [
            ("dem-solver".to_owned(), seconds(41.2)),
            ("fluid: pressure".to_owned(), seconds(63.0)),
            ("fluid: momentum".to_owned(), seconds(22.5)),
            ("sampling and deposition".to_owned(), seconds(9.1)),
            ("coupler".to_owned(), seconds(1.8)),
            ("output".to_owned(), seconds(2.4)),
        ]
        .into(),
        counts: Counts {
            windows: 500,
            refused: 2,
            iterations: 1430,
            substeps: 25_000,
            grains: 2000,
            nodes: 6171,
        },
        peak_memory: 312 << 20,
        taken: [("energy-taken-by-sleep[J]".to_owned(), 2.5e-9)].into(),
        audits: [("volume-by-overlap[m^3]".to_owned(), -1.5e-6)].into(),
        thrift: [("neighbour-lists-reused".to_owned(), 23_118), ("single-iteration-windows".to_owned(), 87)]
            .into(),
        ledger: [
            ("mass".to_owned(), ledger(0.0, 1e-12)),
            ("momentum".to_owned(), ledger(3.1e-15, 1e-12)),
            ("fluid-volume".to_owned(), ledger(2.2e-9, 1e-6)),
        ]
        .into(),
        checks: vec![
            check("terminal velocity", -0.1482, -0.1494, "Di Felice 1994, single sphere limit"),
            check("bed height", 0.0531, 0.0502, "random loose packing, 0.59 by volume"),
        ],
    }
}

/// Series of `rows` rows: grains, fluid, convergence, ledger.
pub fn write_series(directory: &Path, rows: usize) {
    let path = |name: &str| directory.join("series").join(name);
    let mut grains = SeriesWriter::create(
        &path("grains.csv"),
        &["t[s]", "mean-vx[m/s]", "mean-vz[m/s]", "largest-speed[m/s]", "kinetic-energy[J]", "contacts[1]"],
    )
    .unwrap();
    let mut fluid =
        SeriesWriter::create(&path("fluid.csv"), &["t[s]", "largest-speed[m/s]", "bed-pressure[Pa]"])
            .unwrap();
    let mut convergence = SeriesWriter::create(
        &path("convergence.csv"),
        &["t[s]", "iterations[1]", "velocity-residual[1]", "pressure-residual[1]"],
    )
    .unwrap();
    let mut ledger = SeriesWriter::create(
        &path("ledger.csv"),
        &["t[s]", "momentum-residual[kg m/s]", "volume-residual[m^3]"],
    )
    .unwrap();
    let mut random = Random(7);
    for row in 0..rows {
        let t = row as f64 / 1000.0;
        let fall = -0.15 * (1.0 - (-t / 0.03).exp()) * (1.0 / (1.0 + ((t - 0.35) / 0.02).exp()));
        let noise = 0.004 * (random.next() - 0.5);
        let contacts = (5800.0 / (1.0 + ((0.3 - t) / 0.04).exp())).round();
        grains.row(&[t, noise, fall, -1.4 * fall + noise.abs(), 11.0e-6 * fall * fall, contacts]).unwrap();
        fluid.row(&[t, 0.05 * fall.abs() + 0.2 * noise.abs(), 1962.0 + 120.0 * fall.abs()]).unwrap();
        let iterations = (2.0 + 2.5 * random.next() * fall.abs() / 0.15).round();
        convergence
            .row(&[t, iterations, 1e-4 * random.next() + 1e-6, 10f64.powf(-3.0 - 2.0 * random.next())])
            .unwrap();
        ledger.row(&[t, 1e-15 * random.next(), 10f64.powf(-13.0 + 4.0 * random.next())]).unwrap();
    }
}

/// Five frames of spheres that settle in a box of tetrahedra.
pub fn write_frames_in_space(directory: &Path) {
    const SIZE: [f64; 3] = [0.06, 0.04, 0.12];
    const CELLS: [usize; 3] = [16, 10, 30];
    let (points, cells) = box_of_tetrahedra(SIZE, CELLS);
    let frames = directory.join("frames");
    let mut grain_index = Collection::create(&frames.join("grains.pvd")).unwrap();
    let mut fluid_index = Collection::create(&frames.join("fluid.pvd")).unwrap();
    let mut random = Random(3);
    let radii: Vec<f64> = (0..2000).map(|_| 0.0013 + 0.0006 * random.next()).collect();
    let starts: Vec<[f64; 3]> = radii
        .iter()
        .enumerate()
        .map(|(i, &r)| {
            let place = [i % 15, i / 15 % 10, i / 150];
            std::array::from_fn(|k| {
                (place[k] as f64 + 0.5) * 0.004 + (0.004 - 2.0 * r) * (random.next() - 0.5)
            })
        })
        .collect();
    for frame in 0..5 {
        let progress = f64::from(frame) / 4.0;
        let centres: Vec<[f64; 3]> = starts
            .iter()
            .map(|&[x, y, z]| [x, y, (z + 0.06 * (1.0 - progress)).min(0.118) - 0.1 * z * progress])
            .collect();
        let speed = |z: f64| 0.15 * (PI * progress).sin() * (0.3 + 0.7 * z / 0.12) + 0.003;
        let velocities: Vec<[f64; 3]> = centres
            .iter()
            .map(|c| [0.01 * (random.next() - 0.5), 0.0, -speed(c[2]) * (0.7 + 0.3 * random.next())])
            .collect();
        let flow: Vec<[f64; 3]> = points
            .iter()
            .map(|p| {
                let (x, z) = (2.0 * PI * p[0] / SIZE[0], PI * p[2] / SIZE[2]);
                let strength = 0.03 * (PI * progress).sin() + 0.002;
                [strength * x.sin() * z.cos(), 0.0, strength * x.cos() * z.sin()]
            })
            .collect();
        let time = 0.5 * progress;
        let name = format!("grains-{frame}.vtp");
        let fields = [Field::scalar("radius", &radii), Field::vector("velocity", &velocities)];
        GrainPoints { centres: &centres, fields: &fields }
            .write(&frames.join(&name), Format::default())
            .unwrap();
        grain_index.push(time, &name).unwrap();
        let name = format!("fluid-{frame}.vtu");
        UnstructuredGrid {
            points: &points,
            cells: &cells,
            point_fields: &[Field::vector("velocity", &flow)],
            cell_fields: &[],
        }
        .write(&frames.join(&name), Format::default())
        .unwrap();
        fluid_index.push(time, &name).unwrap();
    }
}

/// Three frames of discs in a collapsing column of triangles.
pub fn write_frames_in_the_plane(directory: &Path) {
    let frames = directory.join("frames");
    let mut grain_index = Collection::create(&frames.join("grains.pvd")).unwrap();
    let mut fluid_index = Collection::create(&frames.join("fluid.pvd")).unwrap();
    let mut random = Random(11);
    const N: usize = 40;
    let cells: Vec<[u32; 3]> = (0..N * N)
        .flat_map(|cell| {
            let a = (cell / N * (N + 1) + cell % N) as u32;
            let (b, c, d) = (a + 1, a + N as u32 + 2, a + N as u32 + 1);
            [[a, b, c], [a, c, d]]
        })
        .collect();
    for frame in 0..3 {
        let stretch = 1.0 + 1.1 * f64::from(frame);
        let flow = |p: [f64; 2]| {
            let height = 0.3 / stretch * (1.3 - 0.6 * p[0] / (0.15 * stretch));
            [p[0], p[1] * height / 0.3]
        };
        let place = |u: f64, v: f64| flow([0.15 * stretch * u, 0.3 * v]);
        let points: Vec<[f64; 2]> = (0..(N + 1) * (N + 1))
            .map(|node| place((node % (N + 1)) as f64 / N as f64, (node / (N + 1)) as f64 / N as f64))
            .collect();
        let velocity = |p: &[f64; 2]| [2.0 * p[0] * f64::from(frame), -2.0 * p[1] * f64::from(frame).sqrt()];
        let velocities: Vec<[f64; 2]> = points.iter().map(velocity).collect();
        // Grains do not stretch: they move apart and sink.
        let centres: Vec<[f64; 2]> = (0..300)
            .map(|i| {
                let (column, row) = (i % 15, i / 15);
                let [x, y] = place((column as f64 + 0.5 + 0.5 * (row % 2) as f64) / 15.5, row as f64 / 24.0);
                [x, y + 0.006]
            })
            .collect();
        let radii: Vec<f64> = centres.iter().map(|_| 0.0032 + 0.0015 * random.next()).collect();
        let speeds: Vec<[f64; 2]> =
            centres.iter().map(|c| velocity(c).map(|v| v * (0.8 + 0.1 * random.next()))).collect();
        let time = 0.1 * f64::from(frame);
        let name = format!("grains-{frame}.vtp");
        let fields = [Field::scalar("radius", &radii), Field::vector("velocity", &speeds)];
        GrainPoints { centres: &centres, fields: &fields }
            .write(&frames.join(&name), Format::default())
            .unwrap();
        grain_index.push(time, &name).unwrap();
        let name = format!("fluid-{frame}.vtu");
        UnstructuredGrid {
            points: &points,
            cells: &cells,
            point_fields: &[Field::vector("velocity", &velocities)],
            cell_fields: &[],
        }
        .write(&frames.join(&name), Format::default())
        .unwrap();
        fluid_index.push(time, &name).unwrap();
    }
}

/// A box cut into cubes and these into six tetrahedra each.
fn box_of_tetrahedra(size: [f64; 3], cells: [usize; 3]) -> (Vec<[f64; 3]>, Vec<[u32; 4]>) {
    let nodes = cells.map(|count| count + 1);
    let number = |i: [usize; 3]| (i[0] + nodes[0] * (i[1] + nodes[1] * i[2])) as u32;
    let grid = |counts: [usize; 3]| {
        (0..counts.iter().product())
            .map(move |n: usize| [n % counts[0], n / counts[0] % counts[1], n / counts[0] / counts[1]])
    };
    let points =
        grid(nodes).map(|i| std::array::from_fn(|k| size[k] * i[k] as f64 / cells[k] as f64)).collect();
    // From one corner of the cube to the opposite one along three axes in every order.
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let tetrahedra = grid(cells)
        .flat_map(|corner| {
            orders.map(|order| {
                let mut at = corner;
                let mut path = [number(at); 4];
                for (step, axis) in order.into_iter().enumerate() {
                    at[axis] += 1;
                    path[step + 1] = number(at);
                }
                path
            })
        })
        .collect();
    (points, tetrahedra)
}

/// Numbers between 0 and 1: a linear congruential generator, D. E. Knuth, MMIX.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}
