//! All errors of the programs, with their exact messages (specification, sections 3.4 and 4.3).

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
    /// Returns the message, byte for byte, without `Error: ` before it and without a line end. For a terminal, control
    /// characters in names and in text of files are escaped.
    #[must_use]
    pub fn message(&self, for_terminal: bool) -> Vec<u8> {
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
            Self::Renderer(error) if for_terminal => error.message_for_terminal(),
            Self::Renderer(error) => error.message(),
            Self::Output(error) if for_terminal => error.message(|text| cpu::escape(text).into_bytes()),
            Self::Output(error) => error.message(<[u8]>::to_vec),
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
