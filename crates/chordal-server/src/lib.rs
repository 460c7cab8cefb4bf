//! The server of `chordal view`: a page on loopback that shows a program and its path, live.
//!
//! A thin shell around [`chordal_view`]. The page is built beforehand (`web/`, embedded from `page/`) and never
//! reads a program: it is told what the library finds. One file per concern: `guard` refuses whom the page
//! is not for, `page` has the files, `live` is the one connection of a page and `outbox` the way to it, `session` has
//! the threads that answer and work, `idle` closes connections that say nothing, `file` is the program on disk.
//!
//! ```
//! let server = chordal_server::Server::listen(0).unwrap();
//! // The address has a token, so that only who knows it sees the page.
//! assert!(server.url().starts_with("http://127.0.0.1:"));
//! // server.serve(programs)?;
//! ```

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a shell: sockets, threads, files and the clock are its business"
)]
#![forbid(unsafe_code)]

mod file;
mod guard;
mod idle;
mod live;
mod outbox;
mod page;
mod session;

use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::time::Duration;

pub use chordal_view::{Against, MachineChoice, Programs, Refusal};
pub use file::save;
pub use guard::Token;

/// Why there is no server.
#[derive(Debug, thiserror::Error)]
pub enum ServeError {
    /// The port is taken, or may not be used.
    #[error("cannot listen on 127.0.0.1:{port}: {error}")]
    Listen {
        /// The port asked for.
        port: u16,
        /// The system's word.
        error: io::Error,
    },
    /// The system gives no random numbers.
    #[error("the system gave no random numbers for the address: {0}")]
    Random(getrandom::Error),
    /// The server broke off.
    #[error("the server ended: {0}")]
    Ended(#[from] io::Error),
}

/// A server that listens, and has not answered yet.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    token: Token,
    idle: Duration,
}

/// So long a connection may say nothing. A page is asked in between whether it is still there, and its browser
/// answers by itself.
const IDLE: Duration = Duration::from_secs(120);

impl Server {
    /// Listens on loopback; port 0 takes any that is free. The token is 192 random bits.
    ///
    /// # Errors
    /// A port that is taken.
    pub fn listen(port: u16) -> Result<Server, ServeError> {
        let failed = |error| ServeError::Listen { port, error };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(failed)?;
        listener.set_nonblocking(true).map_err(failed)?;
        let address = listener.local_addr().map_err(failed)?;
        let token = Token::random().map_err(ServeError::Random)?;
        Ok(Server { listener, address, token, idle: IDLE })
    }

    /// The address of the page, token and all.
    pub fn url(&self) -> String {
        format!("http://{}/{}/", self.address, self.token.text())
    }

    /// Closes connections that say nothing for so long; two minutes where nothing else is said.
    #[must_use]
    pub fn closing_after(self, idle: Duration) -> Server {
        Server { idle, ..self }
    }

    /// Answers until the process ends.
    ///
    /// # Errors
    /// When the socket breaks.
    pub fn serve(self, programs: Arc<dyn Programs>) -> Result<(), ServeError> {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
        runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(self.listener)?;
            let app = page::router(self.token, self.address.port(), programs, self.idle);
            axum::serve(idle::Closing { listener, after: self.idle }, app).await
        })?;
        Ok(())
    }
}
