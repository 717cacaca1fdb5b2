//! All errors of the programs, with their exact messages (specification, sections 3.4 and 4.3).

use std::fmt;

/// Why a program ends without a picture.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// The program was called with this number of arguments instead of three.
    ArgumentCount(usize),
    /// The configuration, the scene or the picture is wrong.
    Renderer(cpu::Error),
    /// The picture cannot be written.
    Output(output::Error),
}

impl Error {
    /// The message, byte for byte, without the leading `Error: ` and without a closing line end.
    #[must_use]
    pub fn message(&self) -> Vec<u8> {
        match self {
            Self::ArgumentCount(count) => format!("Invalid number of arguments: {count}").into_bytes(),
            Self::Renderer(error) => error.message(),
            Self::Output(error) => error.message(<[u8]>::to_vec),
        }
    }

    /// The message for a terminal, with control characters of files and names escaped.
    #[must_use]
    pub fn message_for_terminal(&self) -> Vec<u8> {
        match self {
            Self::ArgumentCount(_) => self.message(),
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
            Self::ArgumentCount(_) => None,
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
