//! The reasons why a command ends early, with their messages and exit statuses.

/// The reason why a command ended early.
#[derive(Debug)]
pub enum Failure {
    /// Two pictures differ more than the course accepts, or `check` found a fault.
    Rejected,
    /// An error, with its message.
    Other(String),
    /// Another program cannot be started, or has failed. One program may not end the grading of all.
    Program(String),
    /// A signal stopped the command, and no results were kept.
    Interrupted,
    /// The picture or the animation is not finished, and a checkpoint or a folder has what is needed to go on.
    Kept {
        /// The file or folder, the rows or frames that it has, and how to go on.
        message: String,
        /// Whether a signal stopped the command, and not one of its options.
        interrupted: bool,
    },
    /// The message about the command line or the help has been printed already. The exit status follows.
    Printed(u8),
}

impl Failure {
    /// Returns the exit status, with the numbers that `diff` and shells use: 1 for a difference, 2 for an error, 130
    /// for an interruption. A picture that an option left unfinished has 3, and the help has 0.
    pub const fn status(&self) -> u8 {
        match self {
            Self::Rejected => 1,
            Self::Printed(status) => *status,
            Self::Other(_) | Self::Program(_) => 2,
            Self::Kept { interrupted: false, .. } => 3,
            Self::Interrupted | Self::Kept { .. } => 130,
        }
    }

    /// Returns the failure with the name of what failed before its message.
    pub fn about(self, name: &str) -> Self {
        match self {
            Self::Other(text) => Self::Other(format!("{name}: {text}")),
            Self::Program(text) => Self::Program(format!("{name}: {text}")),
            other => other,
        }
    }

    /// Returns the value, or the message if another program has failed.
    ///
    /// # Errors
    /// Every other failure.
    pub fn of_program<T>(result: Result<T, Self>) -> Result<Result<T, String>, Self> {
        match result {
            Ok(value) => Ok(Ok(value)),
            Err(Self::Program(message)) => Ok(Err(message)),
            Err(other) => Err(other),
        }
    }

    /// Returns the message to print, with control characters escaped; `None` if the message has been printed already.
    pub fn message(&self) -> Option<String> {
        match self {
            Self::Rejected | Self::Printed(_) => None,
            Self::Other(message) | Self::Program(message) | Self::Kept { message, .. } => Some(message.clone()),
            Self::Interrupted => Some("interrupted; nothing was written".to_owned()),
        }
    }
}

impl From<cpu::Error> for Failure {
    fn from(error: cpu::Error) -> Self {
        Self::Other(String::from_utf8_lossy(&error.message_for_terminal()).into_owned())
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
