//! The reasons for which a command ends early, with their messages and exit statuses.

/// The reason for which a command ended early.
#[derive(Debug)]
pub enum Failure {
    /// Two pictures differ more than the course accepts.
    Rejected,
    /// An error of the renderer or of its input files.
    Renderer(cpu::Error),
    /// Another error, in words.
    Other(String),
    /// A signal stopped the command, and nothing was kept.
    Interrupted,
    /// A signal stopped the command, and finished work was kept. The text says how to go on.
    Paused(String),
    /// The command line is not understood. Its message has been written already.
    CommandLine,
    /// The help was printed. This is a success, with exit status 0.
    Help,
}

impl Failure {
    /// Returns the exit status, as of `diff` and shells: 1 for a difference, 2 for an error, 130 for an interruption.
    #[must_use]
    pub const fn status(&self) -> u8 {
        match self {
            Self::Rejected => 1,
            Self::Help => 0,
            Self::Renderer(_) | Self::Other(_) | Self::CommandLine => 2,
            Self::Interrupted | Self::Paused(_) => 130,
        }
    }

    /// Returns the message to print, with control characters escaped; `None` if the output has said it already.
    #[must_use]
    pub fn message(&self) -> Option<String> {
        match self {
            Self::Rejected | Self::CommandLine | Self::Help => None,
            Self::Renderer(error) => Some(String::from_utf8_lossy(&error.message_for_terminal()).into_owned()),
            Self::Other(text) | Self::Paused(text) => Some(text.clone()),
            Self::Interrupted => Some("interrupted; nothing was written".to_owned()),
        }
    }
}

impl From<cpu::Error> for Failure {
    fn from(error: cpu::Error) -> Self {
        Self::Renderer(error)
    }
}

impl From<output::Error> for Failure {
    fn from(error: output::Error) -> Self {
        let message = error.message(|text| cpu::internals::input::text::escape(text).into_bytes());
        Self::Other(String::from_utf8_lossy(&message).into_owned())
    }
}

impl From<String> for Failure {
    fn from(text: String) -> Self {
        Self::Other(text)
    }
}

impl From<&str> for Failure {
    fn from(text: &str) -> Self {
        Self::Other(text.to_owned())
    }
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self::Other(error.to_string())
    }
}
