//! The server of `chordal view`: a page on loopback that shows a program and its path, live.
//!
//! A thin shell around [`chordal_view`]. The page is built beforehand (`web/`, embedded from `page/`) and never
//! reads a program: it gets the results of the library. One file per concern: `guard` refuses requests that do not come
//! from the page, `page` has the files, `page_connection` is the one connection of a page and `outbox` sends to it, `session` has
//! the threads that answer and work, `idle_timeout` closes idle connections, `file` is the program on disk.
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

/// Why there is no server.
#[derive(Debug, thiserror::Error)]
pub enum PageServerError {
    /// The port is taken, or may not be used.
    #[error("cannot listen on 127.0.0.1:{port}: {error}")]
    Listen {
        /// The requested port.
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
pub struct PageServer {
    listener: TcpListener,
    address: SocketAddr,
    token: AccessToken,
    idle: Duration,
}

/// A connection that receives nothing for so long is closed. A page gets pings in between, which its browser
/// answers without the page.
const IDLE_LIMIT: Duration = Duration::from_secs(120);

impl PageServer {
    /// Listens on loopback; port 0 takes any that is free. The token is 192 random bits.
    ///
    /// # Errors
    /// A port that is taken.
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

    /// Sets after how long an idle connection is closed; two minutes by default.
    #[must_use]
    pub fn closing_after(self, idle: Duration) -> PageServer {
        PageServer { idle, ..self }
    }

    /// Answers until the process ends.
    ///
    /// # Errors
    /// When the socket breaks.
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
