//! All errors of the programs, with their exact messages (specification, sections 3.4 and 4.3).

use std::fmt;

/// The error of a program that ends without a picture.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// The program was called with this number of arguments, which is not three.
    ArgumentCount(usize),
    /// The stack cannot grow as far as rendering needs.
    Stack {
        /// Size in bytes of the part that is left.
        room: usize,
        /// Size in bytes that is needed.
        needed: usize,
    },
    /// The configuration, the scene or the picture is wrong.
    Renderer(cpu::Error),
    /// The picture's file cannot be written. The error has the reason.
    Output(output::Error),
}

impl Error {
    /// Returns the message, byte for byte, without `Error: ` before it and without a line end.
    #[must_use]
    pub fn message(&self) -> Vec<u8> {
        match self {
            Self::ArgumentCount(count) => format!("Invalid number of arguments: {count}").into_bytes(),
            Self::Stack { room, needed } => {
                let [room, needed] = [room, needed].map(|bytes| bytes >> 10);
                format!(
                    "The stack is too small: {room} KiB are left, and {needed} KiB are needed; raise its limit, for \
                     example with: ulimit -s 8192"
                )
                .into_bytes()
            }
            Self::Renderer(error) => error.message(),
            Self::Output(error) => error.message(<[u8]>::to_vec),
        }
    }

    /// Returns the message for a terminal: control characters in names and in text of files are escaped.
    #[must_use]
    pub(crate) fn message_for_terminal(&self) -> Vec<u8> {
        match self {
            Self::ArgumentCount(_) | Self::Stack { .. } => self.message(),
            Self::Renderer(error) => error.message_for_terminal(),
            Self::Output(error) => error.message(|text| cpu::escape(text).into_bytes()),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&String::from_utf8_lossy(&self.message()))
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::ArgumentCount(_) | Self::Stack { .. } => None,
            Self::Renderer(error) => Some(error),
            Self::Output(error) => Some(error),
        }
    }
}

impl From<cpu::Error> for Error {
    fn from(error: cpu::Error) -> Self {
        Self::Renderer(error)
    }
}

impl From<output::Error> for Error {
    fn from(error: output::Error) -> Self {
        Self::Output(error)
    }
}
