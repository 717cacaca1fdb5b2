//! Why a command ended early, and the exit status that says so.

/// The end of a command that did not simply succeed.
#[derive(Debug)]
pub enum Failure {
    /// Two pictures differ more than the course accepts.
    Rejected,
    /// The renderer, or a file of it, says no.
    Renderer(cpu::Error),
    /// Anything else that went wrong, in words.
    Other(String),
    /// Someone stopped it.
    Interrupted,
    /// Someone stopped it, and what was done is kept: how to go on.
    Paused(String),
    /// A command line that is not understood; a message has been written.
    CommandLine,
    /// Help was asked for and written: the end, and no failure.
    Help,
}

impl Failure {
    /// The exit status, as `diff` and shells have them: 1 for a difference, 2 for trouble, 130 for an interruption.
    #[must_use]
    pub const fn status(&self) -> u8 {
        match self {
            Self::Rejected => 1,
            Self::Help => 0,
            Self::Renderer(_) | Self::Other(_) | Self::CommandLine => 2,
            Self::Interrupted | Self::Paused(_) => 130,
        }
    }

    /// What to say about it; nothing where the output has said it already. Control characters are escaped.
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
