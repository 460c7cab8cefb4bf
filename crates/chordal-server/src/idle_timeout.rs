//! Closes idle connections, which would otherwise occupy one of the limited places forever.

use std::io::{self, ErrorKind};
use std::net::SocketAddr;
use std::pin::Pin;
use std::task::{Context, Poll};
use std::time::Duration;

use axum::serve::Listener;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::net::{TcpListener, TcpStream};
use tokio::time::{Instant, Sleep, sleep};

/// Accepts connections that end when they receive nothing for the time `after`.
pub struct IdleListener {
    pub listener: TcpListener,
    pub after: Duration,
}

impl Listener for IdleListener {
    type Io = IdleConnection;
    type Addr = SocketAddr;

    async fn accept(&mut self) -> (IdleConnection, SocketAddr) {
        let (stream, address) = Listener::accept(&mut self.listener).await;
        let (after, end) = (self.after, Box::pin(sleep(self.after)));
        (IdleConnection { stream, after, end }, address)
    }

    fn local_addr(&self) -> io::Result<SocketAddr> {
        self.listener.local_addr()
    }
}

/// A connection that ends when it is idle for too long.
pub struct IdleConnection {
    stream: TcpStream,
    after: Duration,
    end: Pin<Box<Sleep>>,
}

impl IdleConnection {
    /// Returns the result of an operation, or a timeout error when the connection is idle for too long.
    fn watched<T>(
        &mut self,
        context: &mut Context<'_>,
        done: Poll<io::Result<T>>,
    ) -> Poll<io::Result<T>> {
        if done.is_ready() {
            return done;
        }
        match self.end.as_mut().poll(context) {
            Poll::Ready(()) => Poll::Ready(Err(ErrorKind::TimedOut.into())),
            Poll::Pending => Poll::Pending,
        }
    }
}

impl AsyncRead for IdleConnection {
    fn poll_read(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        into: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        let done = Pin::new(&mut self.stream).poll_read(context, into);
        if done.is_ready() {
            // Only received bytes postpone the end, because written bytes may never be read.
            let end = Instant::now() + self.after;
            self.end.as_mut().reset(end);
        }
        self.watched(context, done)
    }
}

impl AsyncWrite for IdleConnection {
    fn poll_write(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        bytes: &[u8],
    ) -> Poll<io::Result<usize>> {
        let done = Pin::new(&mut self.stream).poll_write(context, bytes);
        self.watched(context, done)
    }

    fn poll_flush(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_flush(context)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(context)
    }
}
