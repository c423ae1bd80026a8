//! Liveness: heartbeats in shared memory, counted by the watcher's own ticks.
//!
//! Each program has a small thread that increments its counter. A watcher measures a peer's silence in its
//! own ticks, so that a suspended terminal (all programs stopped together) harms nothing.

use crate::error::InterfaceError;
use crate::run::{RunId, Who, process_start};
use std::fs::{File, OpenOptions};
use std::os::fd::AsRawFd;
use std::os::unix::fs::OpenOptionsExt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

/// Interval of the heartbeats.
pub const TICK: Duration = Duration::from_millis(50);

/// In the place of its pid: the program has left. No process has this one.
const LEFT: u64 = u64::MAX;

/// The shared table: per program its pid, start time and heartbeat count.
#[repr(C)]
struct Table {
    pid: [AtomicU64; 3],
    start: [AtomicU64; 3],
    beats: [AtomicU64; 3],
}

/// The table, mapped.
pub(crate) struct PulseMap {
    table: *mut Table,
    file: File,
    run: RunId,
}

// SAFETY: the table holds only atomics and stays mapped for the life of the map.
unsafe impl Send for PulseMap {}
// SAFETY: as above.
unsafe impl Sync for PulseMap {}

impl PulseMap {
    fn open(run: RunId, create: bool) -> Result<PulseMap, InterfaceError> {
        let path = run.pulse_path();
        let failed = |what: &'static str, detail: std::io::Error| InterfaceError::Transport {
            what,
            detail: detail.to_string(),
            path: path.display().to_string(),
        };
        let file = OpenOptions::new()
            .read(true)
            .write(true)
            .create_new(create)
            .mode(0o600)
            .open(&path)
            .map_err(|error| failed("opening the heartbeat table", error))?;
        let size = size_of::<Table>();
        if create {
            // Allocated, not sparse: writing to it cannot raise SIGBUS later.
            // SAFETY: the descriptor is open.
            let code = unsafe { libc::posix_fallocate(file.as_raw_fd(), 0, size as libc::off_t) };
            if code != 0 {
                return Err(failed(
                    "allocating the heartbeat table",
                    std::io::Error::from_raw_os_error(code),
                ));
            }
        } else if file.metadata().map_or(0, |data| data.len()) < size as u64 {
            let short = std::io::Error::other("the file is too short");
            return Err(failed("reading the heartbeat table", short));
        }
        // SAFETY: the file is open for reading and writing and at least `size` bytes long.
        let address = unsafe {
            libc::mmap(
                std::ptr::null_mut(),
                size,
                libc::PROT_READ | libc::PROT_WRITE,
                libc::MAP_SHARED,
                file.as_raw_fd(),
                0,
            )
        };
        if address == libc::MAP_FAILED {
            return Err(failed("mapping the heartbeat table", std::io::Error::last_os_error()));
        }
        Ok(PulseMap { table: address.cast(), file, run })
    }

    fn table(&self) -> &Table {
        // SAFETY: mapped in `open`, unmapped in `drop`, page-aligned, all bit patterns valid.
        unsafe { &*self.table }
    }

    fn enter(&self, who: Who) {
        let pid = std::process::id();
        self.table().start[who.index()].store(process_start(pid).unwrap_or(0), Ordering::SeqCst);
        self.table().pid[who.index()].store(u64::from(pid), Ordering::SeqCst);
    }

    /// Whether the program has entered and its process lives.
    fn is_alive(&self, who: Who) -> bool {
        let pid = self.table().pid[who.index()].load(Ordering::SeqCst);
        let start = self.table().start[who.index()].load(Ordering::SeqCst);
        pid != 0 && u32::try_from(pid).ok().and_then(process_start) == Some(start)
    }

    fn has_entered(&self, who: Who) -> bool {
        self.table().pid[who.index()].load(Ordering::SeqCst) != 0
    }

    /// Leaves; the last one out removes the run's shared memory. Serialised by a lock on the table's file.
    fn leave(&self, who: Who) {
        // SAFETY: the descriptor is open; the lock goes with it.
        unsafe { libc::flock(self.file.as_raw_fd(), libc::LOCK_EX) };
        self.table().pid[who.index()].store(LEFT, Ordering::SeqCst);
        if !Who::ALL.into_iter().any(|other| self.is_alive(other)) {
            self.run.remove();
        }
        // SAFETY: as above.
        unsafe { libc::flock(self.file.as_raw_fd(), libc::LOCK_UN) };
    }

    /// Whether any program of the run lives. A run without a table is being set up or dead: it counts as
    /// alive for as long as its folder is young.
    pub(crate) fn any_alive(run: RunId) -> bool {
        match PulseMap::open(run, false) {
            Ok(map) => Who::ALL.into_iter().any(|who| map.is_alive(who)),
            Err(_) => run
                .root()
                .metadata()
                .and_then(|data| data.modified())
                .is_ok_and(|time| time.elapsed().map_or(true, |age| age < Duration::from_secs(5))),
        }
    }
}

impl Drop for PulseMap {
    fn drop(&mut self) {
        // SAFETY: the address and size are those of the mapping made in `open`.
        unsafe { libc::munmap(self.table.cast(), size_of::<Table>()) };
    }
}

struct Shared {
    map: PulseMap,
    who: Who,
    /// Own ticks.
    ticks: AtomicU64,
    /// Own tick at which each peer's counter last moved.
    heard: [AtomicU64; 3],
    ending: AtomicBool,
}

/// This program's heartbeat, and its ear for the others'.
pub struct Pulse {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

/// What to do when the parent is gone and the computing thread does not notice: called once from the
/// heartbeat's thread. Executables pass an exit; threads of one process need none.
pub type Abandon = Box<dyn FnOnce() + Send>;

/// How long the computing thread may take to notice that the coupler is gone.
const GRACE: Duration = Duration::from_secs(3);

impl Pulse {
    /// Starts to beat. The coupler makes the table, the solvers open it.
    ///
    /// # Errors
    /// [`InterfaceError::Transport`] if the table cannot be made or opened.
    pub fn start(run: RunId, who: Who, mut abandon: Option<Abandon>) -> Result<Pulse, InterfaceError> {
        let map = PulseMap::open(run, who == Who::Coupler)?;
        map.enter(who);
        let shared = Arc::new(Shared {
            map,
            who,
            ticks: AtomicU64::new(0),
            heard: Default::default(),
            ending: AtomicBool::new(false),
        });
        let own = Arc::clone(&shared);
        let thread = std::thread::spawn(move || {
            let mut last = [0; 3];
            let mut orphaned_ticks = 0;
            while !own.ending.load(Ordering::Relaxed) {
                beat(&own, &mut last);
                if who != Who::Coupler && !own.map.is_alive(Who::Coupler) {
                    orphaned_ticks += 1;
                }
                if TICK * orphaned_ticks > GRACE
                    && let Some(abandon) = abandon.take()
                {
                    own.map.leave(who);
                    abandon();
                }
                std::thread::park_timeout(TICK);
            }
        });
        Ok(Pulse { shared, thread: Some(thread) })
    }

    /// Whether a peer has joined the run.
    pub fn has_joined(&self, peer: Who) -> bool {
        self.shared.map.has_entered(peer)
    }

    /// Own time: ticks counted by the heartbeat, standing still while this process is stopped.
    pub fn now(&self) -> Duration {
        TICK * u32::try_from(self.shared.ticks.load(Ordering::Relaxed)).unwrap_or(u32::MAX)
    }

    /// An error if a peer that has joined has left or is dead, or silent for longer than the deadline.
    ///
    /// # Errors
    /// [`InterfaceError::PeerDied`], [`InterfaceError::PeerFrozen`].
    pub fn check(&self, peer: Who, deadline: Duration) -> Result<(), InterfaceError> {
        if !self.has_joined(peer) {
            return Ok(());
        }
        if !self.shared.map.is_alive(peer) {
            return Err(InterfaceError::PeerDied { who: peer, how: String::new() });
        }
        let heard = self.shared.heard[peer.index()].load(Ordering::Relaxed);
        let silence = self.shared.ticks.load(Ordering::Relaxed).saturating_sub(heard);
        let silence = TICK.as_secs_f64() * silence as f64;
        if silence > deadline.as_secs_f64() {
            return Err(InterfaceError::PeerFrozen { who: peer, seconds: silence });
        }
        Ok(())
    }
}

fn beat(shared: &Shared, last: &mut [u64; 3]) {
    let tick = shared.ticks.fetch_add(1, Ordering::Relaxed) + 1;
    shared.map.table().beats[shared.who.index()].fetch_add(1, Ordering::SeqCst);
    for who in Who::ALL {
        let beats = shared.map.table().beats[who.index()].load(Ordering::SeqCst);
        // Who has not come yet is not silent.
        if beats != last[who.index()] || !shared.map.has_entered(who) {
            last[who.index()] = beats;
            shared.heard[who.index()].store(tick, Ordering::Relaxed);
        }
    }
}

impl Drop for Pulse {
    fn drop(&mut self) {
        self.shared.ending.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            thread.thread().unpark();
            let _ = thread.join();
        }
        self.shared.map.leave(self.shared.who);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_one_out_removes_the_run_and_a_silent_peer_is_found_frozen() {
        let run = RunId::new();
        let coupler = Pulse::start(run, Who::Coupler, None).unwrap();
        assert!(!coupler.has_joined(Who::Dem));
        assert!(coupler.check(Who::Dem, Duration::ZERO).is_ok(), "nobody misses who never came");
        let dem = Pulse::start(run, Who::Dem, None).unwrap();
        std::thread::sleep(4 * TICK);
        assert!(coupler.check(Who::Dem, 3 * TICK).is_ok());
        dem.shared.ending.store(true, Ordering::Relaxed);
        std::thread::sleep(8 * TICK);
        assert!(matches!(coupler.check(Who::Dem, 3 * TICK), Err(InterfaceError::PeerFrozen { .. })));
        assert!(run.pulse_path().exists());
        drop(dem);
        assert!(
            matches!(coupler.check(Who::Dem, Duration::MAX), Err(InterfaceError::PeerDied { .. })),
            "who has left is missed"
        );
        // Both programs live in this process; the table tells them apart.
        assert!(run.pulse_path().exists());
        drop(coupler);
        assert!(!run.pulse_path().exists());
    }

    #[test]
    fn a_run_without_living_processes_is_swept() {
        let run = RunId::new();
        let map = PulseMap::open(run, true).unwrap();
        map.table().pid[0].store(u64::from(u32::MAX), Ordering::SeqCst);
        crate::run::sweep();
        assert!(!run.pulse_path().exists());
    }
}
