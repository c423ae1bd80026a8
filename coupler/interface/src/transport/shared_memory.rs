//! iceoryx2 shared memory: one prefix and one root folder per run, no silent overflow, signals left alone.

use super::control::{Receiver, Sender, Watch};
use super::frame::{Reader as AnyReader, Writer as AnyWriter};
use super::{
    CommandReceiver, CommandSender, CouplerEnds, Deadlines, DemEnds, FluidEnds, FrameReader, FrameWriter,
};
use crate::error::InterfaceError;
use crate::frames::{Header, Row};
use crate::message::{Command, Report, decode, encode};
use crate::pulse::{Abandon, Pulse};
use crate::run::{RunId, Who, make_runs_folder, require_space};
use iceoryx2::port::client::Client as IoxClient;
use iceoryx2::port::listener::{Listener, ListenerWaitError};
use iceoryx2::port::notifier::Notifier;
use iceoryx2::port::publisher::Publisher;
use iceoryx2::port::server::Server as IoxServer;
use iceoryx2::port::subscriber::Subscriber;
use iceoryx2::prelude::*;
use iceoryx2::sample::Sample;
use std::sync::Arc;
use std::time::Duration;

type Service = ipc_threadsafe::Service;
type ControlService =
    iceoryx2::service::port_factory::request_response::PortFactory<Service, [u8], (), [u8], ()>;
type FrameService<R> = iceoryx2::service::port_factory::publish_subscribe::PortFactory<Service, [R], Header>;

/// Frames that may be under way to one reader; lockstep needs two.
const BUFFER: usize = 4;
/// Slots that lockstep touches at most per frame; the rest of the segment stays unallocated.
const TOUCHED_SLOTS: u64 = 4;
const FIRST_ROWS: usize = 1024;

/// A node of one run.
struct Session {
    run: RunId,
    node: Node<Service>,
}

impl Session {
    fn open(run: RunId) -> Result<Session, InterfaceError> {
        set_log_level(LogLevel::Fatal);
        make_runs_folder()?;
        let root = run.root();
        let failed = |detail: String| transport("setting up a node", detail, run);
        std::fs::create_dir_all(&root).map_err(|error| failed(error.to_string()))?;
        let mut config = Config::default();
        config.global.prefix =
            FileName::new(run.prefix().as_bytes()).map_err(|error| failed(format!("{error:?}")))?;
        let root =
            Path::new(root.as_os_str().as_encoded_bytes()).map_err(|error| failed(format!("{error:?}")))?;
        config.global.set_root_path(&root);
        let node = NodeBuilder::new()
            .config(&config)
            .signal_handling_mode(SignalHandlingMode::Disabled)
            .create::<Service>()
            .map_err(|error| failed(format!("{error:?}")))?;
        Ok(Session { run, node })
    }

    fn name(&self, text: &str) -> Result<ServiceName, InterfaceError> {
        text.try_into().map_err(|error| transport("naming a service", format!("{error:?}"), self.run))
    }

    fn frames<R: Row>(&self) -> Result<FrameService<R>, InterfaceError> {
        self.node
            .service_builder(&self.name(R::KIND.name())?)
            .publish_subscribe::<[R]>()
            .user_header::<Header>()
            .enable_safe_overflow(false)
            .subscriber_max_buffer_size(BUFFER)
            .max_publishers(1)
            .max_subscribers(2)
            .open_or_create()
            .map_err(|error| transport("opening a frame service", format!("{error:?}"), self.run))
    }

    fn writer<R: Row>(&self) -> Result<FrameWriter<R>, InterfaceError> {
        let publisher = self
            .frames::<R>()?
            .publisher_builder()
            .initial_max_slice_len(FIRST_ROWS)
            .allocation_strategy(AllocationStrategy::PowerOfTwo)
            .create()
            .map_err(|error| transport("creating a publisher", format!("{error:?}"), self.run))?;
        let writer = Writer { publisher, capacity: 0, run: self.run };
        Ok(FrameWriter::new(self.run, AnyWriter::SharedMemory(writer)))
    }

    fn reader<R: Row>(&self) -> Result<FrameReader<R>, InterfaceError> {
        let subscriber = self
            .frames::<R>()?
            .subscriber_builder()
            .create()
            .map_err(|error| transport("creating a subscriber", format!("{error:?}"), self.run))?;
        let reader = Reader { subscriber, run: self.run };
        Ok(FrameReader::new(self.run, AnyReader::SharedMemory(reader)))
    }

    fn bell(&self, from: Who, to: Who) -> Result<Bell, InterfaceError> {
        let failed = |detail: String| transport("creating an event", detail, self.run);
        let ring = |from: Who, to: Who| {
            self.node
                .service_builder(&self.name(&format!("{from}-to-{to}"))?)
                .event()
                .open_or_create()
                .map_err(|error| failed(format!("{error:?}")))
        };
        Ok(Bell {
            notifier: ring(from, to)?.notifier_builder().create().map_err(|e| failed(format!("{e:?}")))?,
            listener: ring(to, from)?.listener_builder().create().map_err(|e| failed(format!("{e:?}")))?,
            run: self.run,
        })
    }

    fn control_service(&self, who: Who) -> Result<ControlService, InterfaceError> {
        self.node
            .service_builder(&self.name(&format!("control-{who}"))?)
            .request_response::<[u8], [u8]>()
            .max_clients(1)
            .max_servers(1)
            .open_or_create()
            .map_err(|error| transport("opening a control service", format!("{error:?}"), self.run))
    }

    fn client(&self, who: Who) -> Result<Client, InterfaceError> {
        let client = self
            .control_service(who)?
            .client_builder()
            .initial_max_slice_len(1024)
            .allocation_strategy(AllocationStrategy::PowerOfTwo)
            .create()
            .map_err(|error| transport("creating a client", format!("{error:?}"), self.run))?;
        Ok(Client { client, pending: None, bell: self.bell(Who::Coupler, who)? })
    }

    fn server(&self, who: Who) -> Result<Server, InterfaceError> {
        let server = self
            .control_service(who)?
            .server_builder()
            .initial_max_slice_len(4096)
            .allocation_strategy(AllocationStrategy::PowerOfTwo)
            .create()
            .map_err(|error| transport("creating a server", format!("{error:?}"), self.run))?;
        Ok(Server { server, active: None, bell: self.bell(who, Who::Coupler)? })
    }
}

/// The coupler's ends of a new run.
///
/// # Errors
/// [`InterfaceError::Transport`] if shared memory cannot be set up.
pub fn create(run: RunId, deadlines: Deadlines) -> Result<CouplerEnds, InterfaceError> {
    let session = Session::open(run)?;
    let pulse = Arc::new(Pulse::start(run, Who::Coupler, None)?);
    let watch = Watch { pulse: Some(pulse), peers: Vec::new(), deadlines };
    let control = |who: Who| -> Result<CommandSender, InterfaceError> {
        let sender = Sender::SharedMemory(Box::new(session.client(who)?));
        Ok(CommandSender { who, sender, watch: watch.clone() })
    };
    Ok(CouplerEnds {
        grains: session.reader()?,
        impulse: session.reader()?,
        samples: session.reader()?,
        hydro: session.writer()?,
        reaction: session.writer()?,
        dem: control(Who::Dem)?,
        fluid: control(Who::Fluid)?,
    })
}

/// The DEM's ends of a run that the coupler has created. Call `abandon` ends the process when the coupler is
/// gone and the computing thread does not notice.
///
/// # Errors
/// [`InterfaceError::Transport`].
pub fn join_as_dem(run: RunId, deadlines: Deadlines, abandon: Abandon) -> Result<DemEnds, InterfaceError> {
    let session = Session::open(run)?;
    let (grains, impulse, hydro) = (session.writer()?, session.writer()?, session.reader()?);
    let control = session.control(Who::Dem, deadlines, abandon)?;
    Ok(DemEnds { control, grains, impulse, hydro })
}

/// The fluid's ends of a run that the coupler has created; see [`join_as_dem`].
///
/// # Errors
/// [`InterfaceError::Transport`].
pub fn join_as_fluid(
    run: RunId,
    deadlines: Deadlines,
    abandon: Abandon,
) -> Result<FluidEnds, InterfaceError> {
    let session = Session::open(run)?;
    let (grains, samples, reaction) = (session.reader()?, session.writer()?, session.reader()?);
    let control = session.control(Who::Fluid, deadlines, abandon)?;
    Ok(FluidEnds { control, grains, samples, reaction })
}

impl Session {
    /// The control wire of a participant; its heart begins to beat when all its ports exist.
    fn control(
        &self,
        who: Who,
        deadlines: Deadlines,
        abandon: Abandon,
    ) -> Result<CommandReceiver, InterfaceError> {
        let receiver = Receiver::SharedMemory(Box::new(self.server(who)?));
        let pulse = Some(Arc::new(Pulse::start(self.run, who, Some(abandon))?));
        Ok(CommandReceiver { receiver, watch: Watch { pulse, peers: vec![Who::Coupler], deadlines } })
    }
}

fn transport(what: &'static str, detail: String, run: RunId) -> InterfaceError {
    InterfaceError::Transport { what, detail, path: run.root().display().to_string() }
}

/// Wakes the other side and is woken by it.
struct Bell {
    notifier: Notifier<Service>,
    listener: Listener<Service>,
    run: RunId,
}

impl Bell {
    fn ring(&self) -> Result<(), InterfaceError> {
        self.notifier
            .notify()
            .map(drop)
            .map_err(|error| transport("waking the peer", format!("{error:?}"), self.run))
    }

    fn wait(&self, wait: Duration) -> Result<(), InterfaceError> {
        match self.listener.timed_wait(drop, wait) {
            // A signal, such as the one that wakes a suspended program, ends the wait early.
            Ok(_) | Err(ListenerWaitError::InterruptSignal) => Ok(()),
            Err(error) => Err(transport("waiting for the peer", format!("{error:?}"), self.run)),
        }
    }
}

pub(super) struct Writer<R: Row> {
    publisher: Publisher<Service, [R], Header>,
    /// Rows that fit without new memory.
    capacity: usize,
    run: RunId,
}

impl<R: Row> Writer<R> {
    pub(super) fn write(
        &mut self,
        header: Header,
        rows: usize,
        row: impl FnMut(usize) -> R,
    ) -> Result<(), InterfaceError> {
        if rows > self.capacity {
            // A segment is sparse: without this look a full file system kills the writer with SIGBUS.
            let capacity = rows.next_power_of_two().max(FIRST_ROWS);
            require_space(TOUCHED_SLOTS * (capacity * size_of::<R>()) as u64, rows as u64)?;
            self.capacity = capacity;
        }
        let mut sample = self
            .publisher
            .loan_slice_uninit(rows)
            .map_err(|error| transport("borrowing memory for a frame", format!("{error:?}"), self.run))?;
        *sample.user_header_mut() = header;
        sample
            .write_from_fn(row)
            .send()
            .map(drop)
            .map_err(|error| transport("sending a frame", format!("{error:?}"), self.run))
    }
}

pub(super) struct Held<R: Row>(Sample<Service, [R], Header>);

impl<R: Row> Held<R> {
    pub(super) fn parts(&self) -> (Header, &[R]) {
        (*self.0.user_header(), self.0.payload())
    }
}

pub(super) struct Reader<R: Row> {
    subscriber: Subscriber<Service, [R], Header>,
    run: RunId,
}

impl<R: Row> Reader<R> {
    pub(super) fn receive(&mut self) -> Result<Option<Held<R>>, InterfaceError> {
        let sample = self
            .subscriber
            .receive()
            .map_err(|error| transport("receiving a frame", format!("{error:?}"), self.run))?;
        Ok(sample.map(Held))
    }
}

type Pending = iceoryx2::pending_response::PendingResponse<Service, [u8], (), [u8], ()>;
type Active = iceoryx2::active_request::ActiveRequest<Service, [u8], (), [u8], ()>;

pub(super) struct Client {
    client: IoxClient<Service, [u8], (), [u8], ()>,
    pending: Option<Pending>,
    bell: Bell,
}

impl Client {
    pub(super) fn send(&mut self, command: &Command) -> Result<(), InterfaceError> {
        let bytes = encode(command)?;
        let failed = |detail: String| transport("sending a command", detail, self.bell.run);
        // The response channel of a command that was never answered is closed before the next is sent.
        self.pending = None;
        let request = self.client.loan_slice_uninit(bytes.len()).map_err(|e| failed(format!("{e:?}")))?;
        self.pending = Some(request.write_from_slice(&bytes).send().map_err(|e| failed(format!("{e:?}")))?);
        self.bell.ring()
    }

    pub(super) fn poll(&mut self, wait: Duration) -> Result<Option<Report>, InterfaceError> {
        let Some(pending) = &self.pending else { return Ok(None) };
        for attempt in [false, true] {
            if attempt {
                self.bell.wait(wait)?;
            }
            let response = pending
                .receive()
                .map_err(|error| transport("receiving a report", format!("{error:?}"), self.bell.run))?;
            if let Some(response) = response {
                let report = decode(response.payload());
                // Tells the participant that its answer has been read.
                self.pending = None;
                return report.map(Some);
            }
        }
        Ok(None)
    }
}

pub(super) struct Server {
    server: IoxServer<Service, [u8], (), [u8], ()>,
    active: Option<Active>,
    bell: Bell,
}

impl Server {
    pub(super) fn poll(&mut self, wait: Duration) -> Result<Option<Command>, InterfaceError> {
        for attempt in [false, true] {
            if attempt {
                self.bell.wait(wait)?;
            }
            let request = self
                .server
                .receive()
                .map_err(|error| transport("receiving a command", format!("{error:?}"), self.bell.run))?;
            if let Some(request) = request {
                let command = decode(request.payload())?;
                self.active = Some(request);
                return Ok(Some(command));
            }
        }
        Ok(None)
    }

    /// Whether the coupler has yet to read the last answer.
    pub(super) fn is_awaited(&self) -> bool {
        self.active.as_ref().is_some_and(Active::is_connected)
    }

    pub(super) fn answer(&mut self, report: &Report) -> Result<(), InterfaceError> {
        let bytes = encode(report)?;
        let failed = |detail: String| transport("sending a report", detail, self.bell.run);
        let Some(request) = &self.active else { return Ok(()) };
        let response = request.loan_slice_uninit(bytes.len()).map_err(|e| failed(format!("{e:?}")))?;
        response.write_from_slice(&bytes).send().map_err(|e| failed(format!("{e:?}")))?;
        self.bell.ring()
    }
}
