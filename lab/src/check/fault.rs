//! What can be wrong with a program, in English and Spanish, and the rules of the specification that it breaks.

use format::Words;
use serde::Serialize;

/// A fault of a program in one case.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// What is wrong.
    pub kind: Kind,
    /// The section of the specification with the rule that is broken, or `None` for a limit of the check.
    pub section: Option<&'static str>,
    /// What was expected, if there is something to say.
    pub expected: String,
    /// What was found.
    pub found: String,
}

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// A signal ended the program.
    Crash,
    /// It took too long and was ended.
    TimeOut,
    /// It needed too much memory and was ended.
    OverMemory,
    /// The exit status is wrong.
    WrongStatus,
    /// What it says on standard error is wrong.
    WrongMessage,
    /// OUT is not as it was before an error.
    OutputChanged,
    /// It succeeded and wrote no picture.
    NoPicture,
    /// The file is no P3.
    UnreadablePicture,
    /// The picture has another width or height.
    WrongSize,
    /// The course does not accept the picture.
    WrongPicture,
}

impl Kind {
    /// Returns the name of the fault, and the section of the rule that it breaks. A limit of the check is no rule, and
    /// the rules on messages depend on the case.
    const fn about(self) -> (Words, Option<&'static str>) {
        match self {
            Self::Crash => (["crash", "el programa aborta"], Some("1.4")),
            Self::TimeOut => (["over the limit of time", "supera el límite de tiempo"], None),
            Self::OverMemory => (["over the limit of memory", "supera el límite de memoria"], None),
            Self::WrongStatus => (["wrong exit status", "código de salida incorrecto"], Some("1.4")),
            Self::WrongMessage => (["wrong message", "mensaje incorrecto"], None),
            Self::OutputChanged => (["an error changed OUT", "un error ha cambiado OUT"], Some("1.4")),
            Self::NoPicture => (["no picture", "no hay imagen"], Some("1.1")),
            Self::UnreadablePicture => (["unreadable picture", "imagen ilegible"], Some("5.3")),
            Self::WrongSize => (["picture of a wrong size", "imagen de otro tamaño"], Some("3.2")),
            Self::WrongPicture => (["wrong picture", "imagen incorrecta"], Some("12")),
        }
    }

    /// Returns the name of the fault.
    pub const fn words(self) -> Words {
        self.about().0
    }

    /// Returns the fault of a case. A wrong message breaks the rule in the section `message` of the specification.
    pub fn fault(self, message: &'static str, expected: impl Into<String>, found: impl Into<String>) -> Fault {
        let section = if self == Self::WrongMessage { Some(message) } else { self.about().1 };
        Fault { kind: self, section, expected: expected.into(), found: found.into() }
    }
}

/// The sections of docs/specification.md that a fault can break, with their titles.
pub const RULES: [(&str, Words); 7] = [
    ("1.1", ["Command line", "Línea de órdenes"]),
    ("1.4", ["Errors", "Errores"]),
    ("3.2", ["Height of the picture", "Altura de la imagen"]),
    ("3.4", ["Messages", "Mensajes de la configuración"]),
    ("4.3", ["Messages", "Mensajes de la escena"]),
    ("5.3", ["P3 file", "Archivo P3"]),
    ("12", ["Acceptance of a picture", "Aceptación de una imagen"]),
];

#[cfg(test)]
mod tests {
    #[test]
    fn every_rule_is_a_section_of_the_specification() {
        let page = include_str!("../../../docs/specification.md");
        for (number, [title, _]) in super::RULES {
            let lines = [format!("\n### {number} {title}\n"), format!("\n## {number}. {title}\n")];
            assert!(lines.iter().any(|line| page.contains(line)), "{number}");
        }
    }
}
