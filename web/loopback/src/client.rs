//! The client of one connection: its time limits, and whether it is still there.

use std::io::{self, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// The client of a connection whose request has been read.
#[derive(Debug)]
pub struct Client<'a>(&'a TcpStream);

impl<'a> Client<'a> {
    /// Returns the client of this connection, whose request has been read.
    #[must_use]
    pub const fn new(stream: &'a TcpStream) -> Self {
        Self(stream)
    }

    /// Whether the client has closed its connection, or has sent more than its one request. In both cases the answer
    /// is not needed, so long work for it should stop.
    #[must_use]
    pub fn is_gone(&self) -> bool {
        let peek = || {
            self.0.set_nonblocking(true)?;
            let seen = self.0.peek(&mut [0]);
            self.0.set_nonblocking(false)?;
            seen
        };
        !matches!(peek(), Err(error) if error.kind() == io::ErrorKind::WouldBlock)
    }
}

/// A stream that fails after a point in time. If only each read and write had a limit, a slow client could keep its
/// connection forever.
#[derive(Debug)]
pub struct Timed<'a> {
    stream: &'a TcpStream,
    end: Instant,
}

impl<'a> Timed<'a> {
    /// Returns the stream, which fails after `time`.
    pub fn new(stream: &'a TcpStream, time: Duration) -> Self {
        Self { stream, end: Instant::now() + time }
    }

    /// Returns the time that is left, which is never zero.
    fn left(&self) -> io::Result<Duration> {
        let left = self.end.saturating_duration_since(Instant::now());
        if left.is_zero() { Err(io::ErrorKind::TimedOut.into()) } else { Ok(left) }
    }
}

impl Read for Timed<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.stream.set_read_timeout(Some(self.left()?))?;
        self.stream.read(buffer)
    }
}

impl Write for Timed<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // The system returns from one call only when it has taken all bytes, or at the end of the time.
        self.stream.set_write_timeout(Some(self.left()?))?;
        self.stream.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
