//! Writing and reading frames.

use super::{in_process, shared_memory};
use crate::error::InterfaceError;
use crate::frames::{Header, PROTOCOL, Row};
use crate::run::RunId;
use std::ops::Deref;

/// What the writer says of a frame; the rest of the header is filled in.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stamp {
    /// Window number.
    pub window: u64,
    /// Iteration, 0 before the first.
    pub iteration: u32,
    /// The instant that the rows describe \[s\].
    pub time: f64,
    /// Length of the window \[s\].
    pub step: f64,
    /// Grains were born, removed or re-sorted.
    pub order_changed: bool,
}

pub(super) enum Writer<R: Row> {
    SharedMemory(shared_memory::Writer<R>),
    InProcess(in_process::Writer<R>),
}

/// Publishes frames of one kind.
pub struct FrameWriter<R: Row> {
    writer: Writer<R>,
    run: RunId,
    sequence: u64,
}

impl<R: Row> FrameWriter<R> {
    pub(super) fn new(run: RunId, writer: Writer<R>) -> Self {
        FrameWriter { writer, run, sequence: 0 }
    }

    /// Publishes a frame; `row(i)` is written in place as row `i`.
    ///
    /// # Errors
    /// [`InterfaceError::NoSpace`] before memory runs out, [`InterfaceError::Transport`].
    pub fn write(
        &mut self,
        stamp: Stamp,
        rows: usize,
        row: impl FnMut(usize) -> R,
    ) -> Result<(), InterfaceError> {
        self.sequence += 1;
        let header = Header {
            protocol: PROTOCOL,
            iteration: stamp.iteration,
            run: self.run.0,
            window: stamp.window,
            sequence: self.sequence,
            rows: rows as u64,
            order_changed: u64::from(stamp.order_changed),
            time: stamp.time,
            step: stamp.step,
        };
        match &mut self.writer {
            Writer::SharedMemory(writer) => writer.write(header, rows, row),
            Writer::InProcess(writer) => writer.write(header, rows, row),
        }
    }
}

pub(super) enum Held<R: Row> {
    SharedMemory(shared_memory::Held<R>),
    InProcess(in_process::Held<R>),
}

pub(super) enum Reader<R: Row> {
    SharedMemory(shared_memory::Reader<R>),
    InProcess(in_process::Reader<R>),
}

/// Receives frames of one kind and keeps the newest.
pub struct FrameReader<R: Row> {
    reader: Reader<R>,
    run: RunId,
    newest: Option<Held<R>>,
}

/// The rows of a frame, in the memory they were written to.
pub struct FrameView<'a, R> {
    /// The frame's header.
    pub header: Header,
    rows: &'a [R],
}

impl<R> Deref for FrameView<'_, R> {
    type Target = [R];
    fn deref(&self) -> &[R] {
        self.rows
    }
}

impl<R: Row> FrameReader<R> {
    pub(super) fn new(run: RunId, reader: Reader<R>) -> Self {
        FrameReader { reader, run, newest: None }
    }

    /// The newest frame that has arrived.
    ///
    /// # Errors
    /// [`InterfaceError::FrameMissing`] if none has come since the run began, [`InterfaceError::Frame`] if its
    /// header is not of this run and protocol or its row count is not that of its memory.
    pub fn newest(&mut self) -> Result<FrameView<'_, R>, InterfaceError> {
        while let Some(held) = self.receive()? {
            self.newest = Some(held);
        }
        let frame = R::KIND.name();
        let (header, rows) = match self.newest.as_ref() {
            None => return Err(InterfaceError::FrameMissing { frame, window: 0 }),
            Some(Held::SharedMemory(held)) => held.parts(),
            Some(Held::InProcess(held)) => held.parts(),
        };
        expect(frame, "protocol", u64::from(header.protocol), u64::from(PROTOCOL))?;
        expect(frame, "run", header.run, self.run.0)?;
        expect(frame, "rows", header.rows, rows.len() as u64)?;
        Ok(FrameView { header, rows })
    }

    /// The newest frame, which must be of this window and iteration.
    ///
    /// # Errors
    /// As [`FrameReader::newest`], and [`InterfaceError::Frame`] for another window or iteration.
    pub fn of(&mut self, window: u64, iteration: u32) -> Result<FrameView<'_, R>, InterfaceError> {
        let view = self.newest()?;
        expect(R::KIND.name(), "window", view.header.window, window)?;
        expect(R::KIND.name(), "iteration", u64::from(view.header.iteration), u64::from(iteration))?;
        Ok(view)
    }

    fn receive(&mut self) -> Result<Option<Held<R>>, InterfaceError> {
        Ok(match &mut self.reader {
            Reader::SharedMemory(reader) => reader.receive()?.map(Held::SharedMemory),
            Reader::InProcess(reader) => reader.receive().map(Held::InProcess),
        })
    }
}

fn expect(frame: &'static str, field: &'static str, found: u64, expected: u64) -> Result<(), InterfaceError> {
    if found == expected {
        return Ok(());
    }
    Err(InterfaceError::Frame { frame, field, found, expected })
}
