//! The server of `chordal view`: serves a page on loopback that shows a program and its path while it is edited.
//!
//! It is a thin layer around [`chordal_view`]. The page is built beforehand (`web/`, embedded from `page/`) and never
//! interprets a program: it gets the results of the library. The modules: `guard` refuses requests that do not come
//! from the page, `page` has the files, `page_connection` is the connection of a page and `outbox` sends to it,
//! `session` has the threads that answer and work, `idle_timeout` closes idle connections, `file` is the program on
//! disk.
//!
//! ```
//! let server = chordal_server::PageServer::listen(0).unwrap();
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
mod idle_timeout;
mod outbox;
mod page;
mod page_connection;
mod session;

use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::time::Duration;

pub use chordal_view::{ComparedProgram, ListedMachine, ProgramRefusal, ProgramSource};
pub use file::save;
pub use guard::AccessToken;

/// Why the server could not start or ended.
#[derive(Debug, thiserror::Error)]
pub enum PageServerError {
    /// The port is in use or not permitted.
    #[error("cannot listen on 127.0.0.1:{port}: {error}")]
    Listen {
        /// The requested port.
        port: u16,
        /// The error of the operating system.
        error: io::Error,
    },
    /// The system provides no random numbers.
    #[error("the system gave no random numbers for the address: {0}")]
    Random(getrandom::Error),
    /// The server ended with an error.
    #[error("the server ended: {0}")]
    Ended(#[from] io::Error),
}

/// A server that listens and does not answer yet.
#[derive(Debug)]
pub struct PageServer {
    listener: TcpListener,
    address: SocketAddr,
    token: AccessToken,
    idle: Duration,
}

/// A connection that receives nothing for this time is closed. The server sends pings in between, which the browser
/// answers by itself, so that open pages stay connected.
const IDLE_LIMIT: Duration = Duration::from_secs(120);

impl PageServer {
    /// Listens on loopback; port 0 takes any free port. The token has 192 random bits.
    ///
    /// # Errors The port is in use or not permitted, or the system provides no random numbers.
    pub fn listen(port: u16) -> Result<PageServer, PageServerError> {
        let failed = |error| PageServerError::Listen { port, error };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(failed)?;
        listener.set_nonblocking(true).map_err(failed)?;
        let address = listener.local_addr().map_err(failed)?;
        let token = AccessToken::random().map_err(PageServerError::Random)?;
        Ok(PageServer { listener, address, token, idle: IDLE_LIMIT })
    }

    /// The address of the page, with the token.
    pub fn url(&self) -> String {
        format!("http://{}/{}/", self.address, self.token.text())
    }

    /// Sets the time after which an idle connection is closed; two minutes by default.
    #[must_use]
    pub fn closing_after(self, idle: Duration) -> PageServer {
        PageServer { idle, ..self }
    }

    /// Answers requests until the process ends.
    ///
    /// # Errors The runtime cannot be started or the socket fails.
    pub fn serve(self, programs: Arc<dyn ProgramSource>) -> Result<(), PageServerError> {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
        runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(self.listener)?;
            let app = page::router(self.token, self.address.port(), programs, self.idle);
            axum::serve(idle_timeout::IdleListener { listener, after: self.idle }, app).await
        })?;
        Ok(())
    }
}
