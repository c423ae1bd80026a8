//! Channels between threads of one process: the same code as over shared memory, without processes.

use super::control::{Receiver, Sender, Watch};
use super::frame::{Reader as AnyReader, Writer as AnyWriter};
use super::{
    CommandReceiver, CommandSender, CouplerEnds, Deadlines, DemEnds, FluidEnds, FrameReader, FrameWriter,
};
use crate::error::InterfaceError;
use crate::frames::{Header, Row};
use crate::message::{Command, Report};
use crate::run::{RunId, Who};
use std::sync::Arc;
use std::sync::mpsc;
use std::time::Duration;

type Shared<R> = Arc<(Header, Vec<R>)>;

pub(super) struct Writer<R>(Vec<mpsc::Sender<Shared<R>>>);

impl<R: Row> Writer<R> {
    pub(super) fn write(
        &mut self,
        header: Header,
        rows: usize,
        row: impl FnMut(usize) -> R,
    ) -> Result<(), InterfaceError> {
        let frame = Arc::new((header, (0..rows).map(row).collect()));
        for reader in &self.0 {
            // A reader that is gone shows on the control wire.
            let _ = reader.send(Arc::clone(&frame));
        }
        Ok(())
    }
}

pub(super) struct Held<R>(Shared<R>);

impl<R: Row> Held<R> {
    pub(super) fn parts(&self) -> (Header, &[R]) {
        (self.0.0, &self.0.1)
    }
}

pub(super) struct Reader<R>(mpsc::Receiver<Shared<R>>);

impl<R: Row> Reader<R> {
    pub(super) fn receive(&mut self) -> Option<Held<R>> {
        self.0.try_recv().ok().map(Held)
    }
}

pub(super) struct Client {
    who: Who,
    commands: mpsc::Sender<Command>,
    reports: mpsc::Receiver<Report>,
}

impl Client {
    pub(super) fn send(&mut self, command: &Command) -> Result<(), InterfaceError> {
        self.commands.send(command.clone()).map_err(|_| gone(self.who))
    }

    pub(super) fn poll(&mut self, wait: Duration) -> Result<Option<Report>, InterfaceError> {
        match self.reports.recv_timeout(wait) {
            Ok(report) => Ok(Some(report)),
            Err(mpsc::RecvTimeoutError::Timeout) => Ok(None),
            Err(mpsc::RecvTimeoutError::Disconnected) => Err(gone(self.who)),
        }
    }
}

pub(super) struct Server {
    commands: mpsc::Receiver<Command>,
    reports: mpsc::Sender<Report>,
}

impl Server {
    pub(super) fn poll(&mut self, wait: Duration) -> Result<Option<Command>, InterfaceError> {
        match self.commands.recv_timeout(wait) {
            Ok(command) => Ok(Some(command)),
            Err(mpsc::RecvTimeoutError::Timeout) => Ok(None),
            Err(mpsc::RecvTimeoutError::Disconnected) => Err(gone(Who::Coupler)),
        }
    }

    pub(super) fn answer(&mut self, report: &Report) -> Result<(), InterfaceError> {
        self.reports.send(report.clone()).map_err(|_| gone(Who::Coupler))
    }
}

fn gone(who: Who) -> InterfaceError {
    InterfaceError::PeerDied { who, how: String::new() }
}

/// All ends of one run inside this process.
pub fn connect(run: RunId) -> (CouplerEnds, DemEnds, FluidEnds) {
    let (grains, [coupler_grains, fluid_grains]) = frames(run);
    let (impulse, [coupler_impulse]) = frames(run);
    let (samples, [coupler_samples]) = frames(run);
    let (hydro, [dem_hydro]) = frames(run);
    let (reaction, [fluid_reaction]) = frames(run);
    let (dem, dem_control) = control(Who::Dem);
    let (fluid, fluid_control) = control(Who::Fluid);
    (
        CouplerEnds {
            grains: coupler_grains,
            impulse: coupler_impulse,
            samples: coupler_samples,
            hydro,
            reaction,
            dem,
            fluid,
        },
        DemEnds { control: dem_control, grains, impulse, hydro: dem_hydro },
        FluidEnds { control: fluid_control, grains: fluid_grains, samples, reaction: fluid_reaction },
    )
}

fn frames<R: Row, const N: usize>(run: RunId) -> (FrameWriter<R>, [FrameReader<R>; N]) {
    let (senders, readers): (Vec<_>, Vec<_>) = (0..N)
        .map(|_| {
            let (sender, receiver) = mpsc::channel();
            (sender, FrameReader::new(run, AnyReader::InProcess(Reader(receiver))))
        })
        .unzip();
    let Ok(readers) = readers.try_into() else { unreachable!("N readers were made") };
    (FrameWriter::new(run, AnyWriter::InProcess(Writer(senders))), readers)
}

fn control(who: Who) -> (CommandSender, CommandReceiver) {
    let (commands, command_receiver) = mpsc::channel();
    let (reports, report_receiver) = mpsc::channel();
    let watch = Watch { pulse: None, peers: Vec::new(), deadlines: Deadlines::default() };
    let client = Client { who, commands, reports: report_receiver };
    let server = Server { commands: command_receiver, reports };
    (
        CommandSender { who, sender: Sender::InProcess(client), watch: watch.clone() },
        CommandReceiver { receiver: Receiver::InProcess(server), watch },
    )
}
