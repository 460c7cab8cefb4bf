//! Those who listen.

use std::io::{ErrorKind, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::time::{Duration, Instant};

use super::shdr::Observations;

/// Most clients at a time.
const MAX_CLIENTS: usize = 16;

/// A client that does not take its lines for so long is let go.
const CLIENT_TIMEOUT: Duration = Duration::from_secs(1);

/// How often clients are looked after.
const POLL_INTERVAL: Duration = Duration::from_millis(5);

/// What a client is told of how long it may wait for the next answer, ms.
const HEARTBEAT: &str = "* PONG 10000\n";

/// The clients of a port.
pub struct StreamClients {
    listener: TcpListener,
    connected: Vec<StreamClient>,
    is_blocking: bool,
}

struct StreamClient {
    stream: TcpStream,
    /// It has got everything that was observed before it came.
    has_state: bool,
}

impl StreamClients {
    /// Nobody yet.
    pub fn of(listener: TcpListener) -> StreamClients {
        StreamClients { listener, connected: Vec::new(), is_blocking: true }
    }

    /// Waits until somebody listens.
    pub fn wait_for_one(&mut self) {
        while self.connected.is_empty() {
            match self.listener.accept() {
                Ok((stream, _)) => self.add(stream),
                Err(_) => std::thread::sleep(POLL_INTERVAL),
            }
        }
        self.is_blocking = self.listener.set_nonblocking(true).is_err();
    }

    /// Looks after the clients until a moment: new ones are told everything, heartbeats are answered.
    pub fn wait_until(&mut self, due: Instant, seen: &Observations) {
        loop {
            self.look_after(seen);
            let left = due.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return;
            }
            std::thread::sleep(left.min(POLL_INTERVAL));
        }
    }

    /// Sends what is new.
    pub fn send(&mut self, seen: &mut Observations) {
        let lines = seen.new_lines();
        if lines.is_empty() {
            return;
        }
        self.connected.retain_mut(|client| client.stream.write_all(lines.as_bytes()).is_ok());
    }

    fn look_after(&mut self, seen: &Observations) {
        while !self.is_blocking && self.connected.len() < MAX_CLIENTS {
            match self.listener.accept() {
                Ok((stream, _)) => self.add(stream),
                Err(_) => break,
            }
        }
        self.connected.retain_mut(|client| client.answer());
        if self.connected.iter().any(|client| !client.has_state) {
            let all = seen.all_lines();
            self.connected.retain_mut(|client| {
                let is_new = !std::mem::replace(&mut client.has_state, true);
                !is_new || client.stream.write_all(all.as_bytes()).is_ok()
            });
        }
    }

    fn add(&mut self, stream: TcpStream) {
        let ready = stream
            .set_nonblocking(false)
            .and_then(|()| stream.set_write_timeout(Some(CLIENT_TIMEOUT)))
            .and_then(|()| stream.set_read_timeout(Some(Duration::from_millis(1))))
            .and_then(|()| stream.set_nodelay(true));
        if ready.is_ok() {
            self.connected.push(StreamClient { stream, has_state: false });
        }
    }
}

impl StreamClient {
    /// Answers `* PING`; everything else is read over. False where it has gone.
    fn answer(&mut self) -> bool {
        let mut bytes = [0; 256];
        match self.stream.read(&mut bytes) {
            Ok(0) => false,
            Ok(count) => {
                let stated = bytes[..count].windows(6).any(|word| word == b"* PING");
                !stated || self.stream.write_all(HEARTBEAT.as_bytes()).is_ok()
            }
            Err(error) => matches!(
                error.kind(),
                ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted
            ),
        }
    }
}
