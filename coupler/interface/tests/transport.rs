//! A made-up solver behind both transports: what is written arrives, in order, in step, or is refused.

use interface::InterfaceError;
use interface::frames::{GrainRow, HydroRow, ImpulseRow, PROTOCOL};
use interface::ledger::GrainLedger;
use interface::message::{
    Books, Command, Commit, Committed, Failure, Hello, Opened, Ready, Report, Solved, TooLarge, Usage, Window,
};
use interface::participant::{Advance, Opening, Participant, serve};
use interface::run::RunId;
use interface::transport::{CouplerEnds, Deadlines, DemEnds, Stamp, in_process, shared_memory};

/// Grains that move with the velocity they are told.
struct Follower {
    ends_grains: interface::transport::FrameWriter<GrainRow>,
    impulse: interface::transport::FrameWriter<ImpulseRow>,
    hydro: interface::transport::FrameReader<HydroRow>,
    position: Vec<f64>,
    saved: Vec<f64>,
    window: Window,
}

fn too_large(bound: f64) -> TooLarge {
    TooLarge { bound, reason: "it goes too far".into() }
}

impl Participant for Follower {
    fn identity(&self) -> (String, String) {
        ("7".into(), "8".into())
    }
    fn ready(&mut self) -> Result<Ready, Failure> {
        Ok(Ready {
            size: self.position.len() as u64,
            largest_step: 1.0,
            time: 0.0,
            notes: Vec::new(),
            surface: None,
        })
    }
    fn open(&mut self, window: Window) -> Result<Opening, Failure> {
        if window.step > 1.0 {
            return Ok(Opening::TooLarge(too_large(1.0)));
        }
        self.window = window;
        self.saved.clone_from(&self.position);
        Ok(Opening::Opened(Opened { rows: self.position.len() as u64, grains_changed: false }))
    }
    fn advance(&mut self, iteration: u32) -> Result<Advance, Failure> {
        if self.window.step > 0.75 {
            self.position.fill(f64::NAN);
            return Ok(Advance::TooLarge(too_large(0.7)));
        }
        let hydro = self.hydro.of(self.window.number, iteration)?;
        for (position, row) in self.position.iter_mut().zip(hydro.iter()) {
            *position += self.window.step * row.fluid_velocity[0];
        }
        let stamp = Stamp { window: self.window.number, iteration, ..Default::default() };
        let grain = |i: usize| GrainRow {
            id: i as u64,
            position: [self.position[i], 0.0, 0.0],
            ..Default::default()
        };
        self.ends_grains.write(stamp, self.position.len(), grain)?;
        self.impulse.write(stamp, self.position.len(), |_| ImpulseRow::default())?;
        Ok(Advance::Solved(Box::new(Solved {
            books: Books::Grains(GrainLedger::default()),
            largest_step: 1.0,
            work: 1,
        })))
    }
    fn restore(&mut self) -> Result<(), Failure> {
        self.position.clone_from(&self.saved);
        Ok(())
    }
    fn commit(&mut self, _: &Commit) -> Result<Committed, Failure> {
        Ok(Committed { largest_step: 1.0, size: self.position.len() as u64 })
    }
    fn stop(&mut self, _: &str) -> Usage {
        Usage::default()
    }
}

fn follow(ends: DemEnds, grains: usize) -> Result<(), InterfaceError> {
    let mut control = ends.control;
    let follower = Follower {
        ends_grains: ends.grains,
        impulse: ends.impulse,
        hydro: ends.hydro,
        position: vec![0.0; grains],
        saved: Vec::new(),
        window: Window { number: 0, time: 0.0, step: 0.0, grains_changed: false },
    };
    serve(&mut control, None, |_| Ok(follower))
}

fn hello() -> Command {
    Command::Hello(Hello {
        protocol: PROTOCOL,
        version: env!("CARGO_PKG_VERSION").into(),
        case_hash: "7".into(),
        plan_hash: "8".into(),
        surface: None,
    })
}

/// Three windows of two iterations each, each offered thrice, as the first is refused when it is opened and the second when it
/// is advanced; every iteration moves grain `i` by `step · i`.
fn drive(mut ends: CouplerEnds, grains: usize) -> Vec<f64> {
    assert!(
        matches!(ends.dem.ask(&hello()).unwrap(), Report::Ready(Ready { size, .. }) if size == grains as u64)
    );
    for number in 0..3 {
        let open = |step| Command::Open(Window { number, time: 0.0, step, grains_changed: false });
        assert_eq!(ends.dem.ask(&open(2.0)).unwrap(), Report::TooLarge(too_large(1.0)));
        assert!(matches!(ends.dem.ask(&open(0.8)).unwrap(), Report::Opened(_)));
        let advance = Command::Advance { iteration: 1 };
        assert_eq!(ends.dem.ask(&advance).unwrap(), Report::TooLarge(too_large(0.7)));
        assert_eq!(ends.dem.ask(&Command::Restore).unwrap(), Report::Restored);
        assert!(matches!(ends.dem.ask(&open(0.5)).unwrap(), Report::Opened(_)));
        for iteration in 1..=2 {
            let stamp = Stamp { window: number, iteration, ..Default::default() };
            let row = |i: usize| HydroRow { fluid_velocity: [i as f64, 0.0, 0.0], ..Default::default() };
            ends.hydro.write(stamp, grains, row).unwrap();
            assert!(matches!(ends.dem.ask(&Command::Advance { iteration }).unwrap(), Report::Solved(_)));
            assert_eq!(ends.grains.of(number, iteration).unwrap().len(), grains);
            assert_eq!(ends.impulse.of(number, iteration).unwrap().len(), grains);
            if iteration == 1 {
                assert_eq!(ends.dem.ask(&Command::Restore).unwrap(), Report::Restored);
            }
        }
        assert!(matches!(ends.dem.ask(&Command::Commit(Commit::default())).unwrap(), Report::Committed(_)));
    }
    let positions = ends.grains.newest().unwrap().iter().map(|row| row.position[0]).collect();
    assert!(matches!(ends.dem.ask(&Command::Stop { reason: "done".into() }).unwrap(), Report::Ended(_)));
    positions
}

fn expected(grains: usize) -> Vec<f64> {
    (0..grains).map(|i| 1.5 * i as f64).collect()
}

/// More rows than the first segment holds, so that it grows.
const GRAINS: usize = 5000;

#[test]
fn windows_restore_and_commit_exactly_inside_one_process() {
    let (coupler, dem, _fluid) = in_process::connect(RunId::new());
    let thread = std::thread::spawn(|| follow(dem, GRAINS));
    assert!(drive(coupler, GRAINS) == expected(GRAINS));
    thread.join().unwrap().unwrap();
}

#[test]
fn windows_restore_and_commit_exactly_over_shared_memory() {
    let run = RunId::new();
    let coupler = shared_memory::create(run, Deadlines::default()).unwrap();
    let (sender, receiver) = std::sync::mpsc::channel();
    let thread = std::thread::spawn(move || {
        let dem = shared_memory::join_as_dem(run, Deadlines::default(), Box::new(|| ())).unwrap();
        sender.send(()).unwrap();
        follow(dem, GRAINS)
    });
    receiver.recv().unwrap();
    assert!(coupler.dem.has_joined());
    assert!(drive(coupler, GRAINS) == expected(GRAINS));
    thread.join().unwrap().unwrap();
    let prefix = format!("silt_{run}");
    let left: Vec<_> = std::fs::read_dir("/dev/shm")
        .unwrap()
        .flatten()
        .filter(|entry| entry.file_name().to_string_lossy().starts_with(&prefix))
        .collect();
    assert!(left.is_empty(), "left in shared memory: {left:?}");
}

#[test]
fn an_empty_scene_crosses_too() {
    let (coupler, dem, _fluid) = in_process::connect(RunId::new());
    let thread = std::thread::spawn(|| follow(dem, 0));
    assert!(drive(coupler, 0).is_empty());
    thread.join().unwrap().unwrap();
}

#[test]
fn a_message_out_of_turn_ends_the_participant_with_its_reason() {
    let (mut coupler, dem, _fluid) = in_process::connect(RunId::new());
    let thread = std::thread::spawn(|| follow(dem, 1));
    let error = coupler.dem.ask(&Command::Restore).unwrap_err().to_string();
    assert_eq!(error, "restore is not allowed when the participant is launched; allowed: hello, stop");
    assert!(thread.join().unwrap().is_err());
    assert!(matches!(coupler.dem.ask(&hello()), Err(InterfaceError::PeerDied { .. })));
}

#[test]
fn a_participant_refuses_another_version_case_or_plan() {
    let Command::Hello(good) = hello() else { unreachable!() };
    for bad in [
        Hello { protocol: 99, ..good.clone() },
        Hello { version: "0.0.0".into(), ..good.clone() },
        Hello { case_hash: "1".into(), ..good.clone() },
        Hello { plan_hash: "1".into(), ..good },
    ] {
        let (mut coupler, dem, _fluid) = in_process::connect(RunId::new());
        let thread = std::thread::spawn(|| follow(dem, 1));
        let error = coupler.dem.ask(&Command::Hello(bad)).unwrap_err();
        assert_eq!(error.exit_code(), 5, "{error}");
        assert!(thread.join().unwrap().is_err());
    }
}

#[test]
fn a_frame_of_another_window_is_refused() {
    let (mut coupler, mut dem, _fluid) = in_process::connect(RunId::new());
    coupler
        .hydro
        .write(Stamp { window: 3, iteration: 1, ..Default::default() }, 0, |_| HydroRow::default())
        .unwrap();
    let error = dem.hydro.of(4, 1).err().unwrap().to_string();
    assert_eq!(error, "frame hydro: window is 3, 4 was expected; the two programs are out of step");
}
