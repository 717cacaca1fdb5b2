//! Shows what a program did with all cases: as text, and as one HTML page.

use std::fs;
use std::path::Path;

use super::cases::Group;
use super::fault::{Fault, Kind, RULES};
use super::{Checked, Report};
use crate::format::Words;
use crate::format::hint::Language;
use crate::picture::data_uri;
use crate::report::html;
use crate::terminal;

/// Names of the pictures in the folder of a case with a wrong picture: the expected one, the program's, the difference.
pub const PICTURES: [&str; 3] = ["expected.png", "found.png", "difference.png"];

const CAPTIONS: [Words; 3] = [["expected", "esperada"], ["found", "obtenida"], ["difference", "diferencia"]];
const GROUPS: [(Group, Words); 4] = [
    (Group::Arguments, ["arguments", "argumentos"]),
    (Group::Messages, ["messages", "mensajes"]),
    (Group::Pictures, ["pictures", "imágenes"]),
    (Group::Course, ["the course's pictures", "imágenes de la asignatura"]),
];
const EQUAL: Words = [
    "{} of {} pictures have the bytes of the specification, with the scatter vectors of {}",
    "{} de {} imágenes tienen los bytes de la especificación, con los vectores de dispersión {}",
];
const CONVENTIONS: [Words; 2] = [
    ["the statement (section 11.1)", "del enunciado (sección 11.1)"],
    ["the published pictures (section 11.2)", "de las imágenes publicadas (sección 11.2)"],
];
const NO_COURSE: Words = [
    "The course's four cases were left out: RENDER_REFERENCE_DIR names no folder",
    "No se han comprobado los cuatro casos de la asignatura: RENDER_REFERENCE_DIR no indica ninguna carpeta",
];
const RULES_ARE: Words =
    ["Rules are sections of docs/specification.md", "Las reglas son secciones de docs/specification.md"];

impl Report {
    /// Returns the number of passed cases of each group, in words.
    fn summary(&self, language: Language) -> Vec<Vec<String>> {
        let row = |(group, words): &(Group, Words)| {
            let [passed, all] = self.passed(*group).map(|count| count.to_string());
            (all != "0")
                .then(|| vec![language.say(*words, &[]), language.say(["{} of {}", "{} de {}"], &[&passed, &all])])
        };
        GROUPS.iter().filter_map(row).collect()
    }

    /// Returns sentences about the pictures.
    fn notes(&self, language: Language) -> Vec<String> {
        let is_picture = |checked: &&Checked| matches!(checked.group, Group::Pictures | Group::Course);
        let pictures = || self.cases.iter().filter(is_picture);
        let [equal, all] = [pictures().filter(|checked| checked.equal).count(), pictures().count()];
        let convention = language.say(CONVENTIONS[self.convention], &[]);
        let equal = language.say(EQUAL, &[&equal.to_string(), &all.to_string(), &convention]);
        let left_out = (self.passed(Group::Course)[1] == 0).then(|| language.say(NO_COURSE, &[]));
        let rules = (!self.is_passed()).then(|| language.say(RULES_ARE, &[]));
        std::iter::once(equal).chain(left_out).chain(rules).collect()
    }

    fn failed(&self) -> impl Iterator<Item = &Checked> {
        self.cases.iter().filter(|checked| !checked.faults.is_empty())
    }

    /// Returns the report as lines of text.
    pub fn text(&self, language: Language) -> String {
        let mut text = format!("{}\n\n", terminal::table(&self.summary(language)));
        for note in self.notes(language) {
            text += &format!("{note}.\n");
        }
        for checked in self.failed() {
            text += &format!("\n{}\n", checked.case);
            lines(checked, language).iter().for_each(|line| text += &format!("  {}\n", line.replace('\n', "\n    ")));
        }
        text.trim_end().to_owned()
    }

    /// Returns the report as an HTML page that needs no other file. `folder` has the files of the cases.
    ///
    /// # Errors
    /// An error of the page's template.
    pub fn page(&self, language: Language, folder: &Path) -> Result<String, String> {
        let title = language.say(["Check of {}", "Comprobación de {}"], &[&self.program]);
        html::document(language, &title, &self.body(language, "", folder))
    }

    /// Returns the report as a part of a page. Its headings begin with `start`.
    pub fn body(&self, language: Language, start: &str, folder: &Path) -> String {
        let title = |words: Words| format!("{start}{}", language.pick(words));
        let notes = self.notes(language).into_iter().map(|note| html::paragraph(&format!("{note}.")));
        let failed = self.failed().map(|checked| vec![checked.case.clone(), lines(checked, language).join("\n")]);
        let is_wrong = |checked: &&Checked| checked.faults.iter().any(|fault| fault.kind == Kind::WrongPicture);
        let wrong = self.failed().filter(is_wrong).map(|checked| {
            let pictures = PICTURES.iter().zip(CAPTIONS).filter_map(|(name, caption)| {
                let png = fs::read(folder.join(&checked.case).join(name)).ok()?;
                Some((format!("{}: {}", checked.case, language.pick(caption)), data_uri(&png)))
            });
            html::pictures("", pictures)
        });
        let wrong: String = wrong.collect();
        [
            html::table(&title(["Summary", "Resumen"]), &["", ""], self.summary(language).into_iter()),
            notes.collect(),
            html::table(&title(["What failed", "Qué ha fallado"]), &["", ""], failed),
            if wrong.is_empty() {
                wrong
            } else {
                html::heading(&title(["Wrong pictures", "Imágenes incorrectas"])) + &wrong
            },
        ]
        .concat()
    }
}

/// Returns the rule that a fault breaks, in words.
fn rule(fault: &Fault, language: Language) -> String {
    let Some((number, title)) = RULES.iter().find(|(number, _)| Some(*number) == fault.section) else {
        return language.say(["a limit of this check", "un límite de esta comprobación"], &[]);
    };
    language.say(["rule {}", "regla {}"], &[&format!("{number} {}", language.say(*title, &[]))])
}

/// Returns the faults of a case, what was expected and found, and the command that repeats it.
fn lines(checked: &Checked, language: Language) -> Vec<String> {
    let mut lines = Vec::new();
    for fault in &checked.faults {
        lines.push(format!("{} ({})", language.say(fault.kind.words(), &[]), rule(fault, language)));
        let nothing = language.say(["nothing", "nada"], &[]);
        let found = if fault.found.is_empty() && !fault.expected.is_empty() { &nothing } else { &fault.found };
        let details = [(["expected: {}", "esperado: {}"], &fault.expected), (["found: {}", "obtenido: {}"], found)]
            .into_iter()
            .filter(|(_, text)| !text.is_empty());
        lines.extend(details.map(|(words, text)| format!("\u{2003}{}", language.say(words, &[text]))));
    }
    lines.push(language.say(["repeat: {}", "repetir: {}"], &[&checked.command]));
    lines
}
