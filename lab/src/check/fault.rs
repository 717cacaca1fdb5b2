//! What can be wrong with a program, in English and Spanish, and the rules of the statement that it breaks.

use format::Words;
use serde::{Deserialize, Serialize};

/// A fault of a program in one case, or a remark, which costs no points.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fault {
    /// What is wrong.
    pub kind: Kind,
    /// The section of the statement with the rule that is broken, or `None` for a limit of the check.
    pub section: Option<String>,
    /// What was expected, if there is something to say.
    pub expected: String,
    /// What was found.
    pub found: String,
}

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// A signal ended the program.
    Crash,
    /// It took too long and was ended.
    TimeOut,
    /// It was not run, because it had taken too long three times.
    LeftOut,
    /// It needed too much memory and was ended.
    OverMemory,
    /// It ended or stopped the process that watches it.
    Unwatched,
    /// The exit status is wrong.
    WrongStatus,
    /// What it says is wrong.
    WrongMessage,
    /// It wrote something into OUT before an error.
    OutputChanged,
    /// It succeeded and wrote no picture.
    NoPicture,
    /// The file is no P3.
    UnreadablePicture,
    /// The file is a P3, and not written as the statement says.
    WrongForm,
    /// The picture has another width or height.
    WrongSize,
    /// The picture is not near the expected one.
    WrongPicture,
    /// The values of pixels are rounded.
    Rounded,
    /// Two pairs of files that mean the same give different bytes.
    ReadsOtherwise,
    /// A value of the configuration changes nothing.
    Ignored,
    /// It has more than one thread.
    Threads,
    /// A remark: the message is on standard output.
    OnStdout,
    /// A remark: the message is right, but for its white space, its last line end, or what follows it.
    OtherSpace,
    /// A remark: it says nothing about a missing file.
    Silent,
    /// A remark: an error has removed or emptied OUT.
    OutLost,
    /// A remark: the values of pixels are scaled by a factor above 255.
    Scaled,
    /// A remark: the height is rounded up.
    OtherHeight,
}

impl Kind {
    /// Returns the name of the fault, and the section of the rule that it breaks. A limit of the check is no rule, and
    /// for an empty section the case names it.
    const fn about(self) -> (Words, Option<&'static str>) {
        match self {
            Self::Crash => (["crash", "el programa aborta"], Some("")),
            Self::TimeOut => (["over the limit of time", "supera el límite de tiempo"], None),
            Self::LeftOut => (
                ["left out after three runs over the limit of time", "omitido tras superar tres veces el tiempo"],
                None,
            ),
            Self::OverMemory => (["over the limit of memory", "supera el límite de memoria"], None),
            Self::Unwatched => {
                (["it ended or stopped the process that watches it", "ha parado el proceso que lo vigila"], None)
            }
            Self::WrongStatus => (["wrong exit status", "código de salida incorrecto"], Some("")),
            Self::WrongMessage => (["wrong message", "mensaje incorrecto"], Some("")),
            Self::OutputChanged => (["an error wrote into OUT", "un error ha escrito en OUT"], Some("")),
            Self::NoPicture => (["no picture", "no hay imagen"], Some("2.3.2")),
            Self::UnreadablePicture => (["unreadable picture", "imagen ilegible"], Some("2.3.2")),
            Self::WrongForm => (["the file is not written as stated", "el archivo no tiene el formato"], Some("2.3.2")),
            Self::WrongSize => (["picture of a wrong size", "imagen de otro tamaño"], Some("2.2")),
            Self::WrongPicture => (["another picture", "otra imagen"], Some("")),
            Self::Rounded => (["rounded instead of truncated", "redondeado en vez de truncado"], Some("3.2")),
            Self::ReadsOtherwise => (
                [
                    "two pairs of files that mean the same give different pictures",
                    "dos pares de archivos iguales dan imágenes distintas",
                ],
                Some(""),
            ),
            Self::Ignored => (["a value changes nothing", "un valor no cambia nada"], Some("")),
            Self::Threads => (["more than one thread", "más de un hilo"], Some("4.2.1")),
            Self::OnStdout => {
                (["the message is on standard output", "el mensaje sale por la salida estándar"], Some(""))
            }
            Self::OtherSpace => {
                (["other white space, or text behind the message", "otros blancos, o texto tras el mensaje"], Some(""))
            }
            Self::Silent => (["no message about a missing file", "sin mensaje sobre un archivo que falta"], Some("")),
            Self::OutLost => (["an error removed or emptied OUT", "un error ha borrado o vaciado OUT"], Some("")),
            Self::Scaled => (["scaled by more than 255", "escalado por más de 255"], Some("3.2")),
            Self::OtherHeight => (["the height is rounded up", "la altura se redondea hacia arriba"], Some("2.2")),
        }
    }

    /// Returns the name of the fault.
    pub const fn words(self) -> Words {
        self.about().0
    }

    /// Returns the fault of a case whose rule is in this section of the statement.
    pub fn fault(self, section: &str, expected: impl Into<String>, found: impl Into<String>) -> Fault {
        let own = self.about().1;
        let section = own.map(|own| if own.is_empty() { section } else { own }.to_owned());
        Fault { kind: self, section, expected: expected.into(), found: found.into() }
    }
}
