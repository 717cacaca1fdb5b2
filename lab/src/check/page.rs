//! Shows what a program did with all cases: as text, and as one HTML page. Each cause is shown once, with examples.

use super::cases::Group;
use super::fault::{Fault, Kind};
use super::{Checked, Report, Verdict};
use crate::format::Words;
use crate::format::hint::Language;
use crate::picture::data_uri;
use crate::report::html;
use crate::{supervise, terminal};

/// Names of the pictures in the folder of a case with a wrong picture: the expected one, the program's, the difference.
pub const PICTURES: [&str; 3] = ["expected.png", "found.png", "difference.png"];

/// Most examples of a cause.
const EXAMPLES: usize = 3;
/// Most bytes of a picture in a page.
const PICTURE_BYTES: u64 = 1 << 24;

const CAPTIONS: [Words; 3] = [["expected", "esperada"], ["found", "obtenida"], ["difference", "diferencia"]];
const GROUPS: [(Group, Words); 5] = [
    (Group::Arguments, ["arguments", "argumentos"]),
    (Group::Messages, ["messages", "mensajes"]),
    (Group::Inputs, ["input files", "archivos de entrada"]),
    (Group::Pictures, ["pictures", "imágenes"]),
    (Group::Course, ["large pictures", "imágenes grandes"]),
];
const NEAR: Words = [
    "Of {} pictures, {} have the same bytes as the literal program's, {} are accepted, and {} are other pictures; \
     scatter vectors of {}",
    "De {} imágenes, {} tienen los mismos bytes que las del programa literal, {} se aceptan y {} son otras; vectores \
     de dispersión {}",
];
const CONVENTIONS: [Words; 2] = [
    ["the statement (section 3.5.1)", "del enunciado (sección 3.5.1)"],
    ["the published pictures, which are unit vectors", "de las imágenes publicadas, que son unitarios"],
];
const NO_COURSE: Words = [
    "The course's four cases were left out: RENDER_REFERENCE_DIR names no folder",
    "No se han comprobado los cuatro casos de la asignatura: RENDER_REFERENCE_DIR no indica ninguna carpeta",
];
const RULES_ARE: Words = ["Sections are those of the statement", "Las secciones son las del enunciado"];
const SIGNS: Words = [
    "In messages, · is a blank, → a tab, and ∅ a missing line end",
    "En los mensajes, · es un blanco, → un tabulador y ∅ un fin de línea que falta",
];

/// Returns the faults or the remarks of a case.
type Pick = fn(&Checked) -> &Vec<Fault>;

/// A cause: a kind of fault or remark that breaks one rule, with all cases that have it.
type Cause<'a> = (&'a Fault, Vec<(&'a Checked, &'a Fault)>);

impl Report {
    /// Returns the number of passed cases of each group, in words.
    fn summary(&self, language: Language) -> Vec<Vec<String>> {
        let row = |(group, words): &(Group, Words)| {
            let counts = self.passed(*group);
            (counts[1] > 0).then(|| vec![language.say(*words, &[]), html::verdict(counts, language)])
        };
        GROUPS.iter().filter_map(row).collect()
    }

    /// Returns sentences about the pictures.
    fn notes(&self, language: Language) -> Vec<String> {
        let verdicts: Vec<_> = self.cases.iter().filter_map(|checked| checked.verdict).collect();
        let count = |verdict| verdicts.iter().filter(|&&other| other == verdict).count().to_string();
        let [same, near, other] = [Verdict::SameBytes, Verdict::Accepted, Verdict::AnotherPicture].map(count);
        let convention = language.say(CONVENTIONS[self.convention], &[]);
        let near = language.say(NEAR, &[&verdicts.len().to_string(), &same, &near, &other, &convention]);
        let left_out = (self.passed(Group::Course)[1] == 0).then(|| language.say(NO_COURSE, &[]));
        let rules = (!self.is_passed()).then(|| language.say(RULES_ARE, &[]));
        let has_message =
            self.causes(|checked| &checked.faults).iter().any(|(fault, _)| fault.kind == Kind::WrongMessage);
        let signs = has_message.then(|| language.say(SIGNS, &[]));
        std::iter::once(near).chain(left_out).chain(rules).chain(signs).collect()
    }

    /// Returns the causes of all faults or remarks, in the order of their first cases.
    fn causes(&self, of: Pick) -> Vec<Cause<'_>> {
        let mut causes: Vec<Cause<'_>> = Vec::new();
        for checked in &self.cases {
            for fault in of(checked) {
                let is_known =
                    |(other, _): &&mut Cause<'_>| (other.kind, &other.section) == (fault.kind, &fault.section);
                match causes.iter_mut().find(is_known) {
                    Some((_, all)) => all.push((checked, fault)),
                    None => causes.push((fault, vec![(checked, fault)])),
                }
            }
        }
        causes
    }

    /// Returns the most frequent fault of the cases in `groups`, in words, or `None` if there is none.
    pub fn main_fault(&self, groups: &[Group], language: Language) -> Option<String> {
        let cases = self.cases.iter().filter(|checked| groups.contains(&checked.group));
        let faults: Vec<_> = cases.flat_map(|checked| &checked.faults).collect();
        let count = |kind: Kind| faults.iter().filter(|fault| fault.kind == kind).count();
        let main = faults.iter().rev().max_by_key(|fault| count(fault.kind))?;
        Some(
            format!("{} ({}), {}", language.pick(main.kind.words()), count(main.kind), main.found)
                .trim_end_matches([' ', ','])
                .to_owned(),
        )
    }

    /// Returns the report as lines of text.
    pub fn text(&self, language: Language) -> String {
        let mut text = format!("{}\n\n", terminal::table(&self.summary(language)));
        for note in self.notes(language) {
            text += &format!("{note}.\n");
        }
        for (words, of) in SECTIONS {
            for cause in self.causes(of) {
                let kind = language.pick(words);
                text += &format!("\n{kind}: {} ({})\n", title(cause.0, language), names(&cause));
                lines(&cause, language)
                    .iter()
                    .for_each(|line| text += &format!("  {}\n", line.replace('\n', "\n      ")));
            }
        }
        text.trim_end().to_owned()
    }

    /// Returns the report as an HTML page that needs no other file.
    ///
    /// # Errors
    /// An error of the page's template.
    pub fn page(&self, language: Language) -> Result<String, String> {
        let title = language.say(["Check of {}", "Comprobación de {}"], &[&self.program]);
        html::document(language, &title, &self.body(language, ""))
    }

    /// Returns the report as a part of a page. Its headings begin with `start`.
    pub fn body(&self, language: Language, start: &str) -> String {
        let heading = |words: Words| format!("{start}{}", language.pick(words));
        let notes = self.notes(language).into_iter().map(|note| html::paragraph(&format!("{note}.")));
        let mut body = html::table(&heading(["Summary", "Resumen"]), &["", ""], self.summary(language).into_iter());
        body.extend(notes);
        for (words, of) in SECTIONS {
            let row = |cause: &Cause<'_>| {
                let head = format!("{}\n{}", title(cause.0, language), names(cause));
                vec![head, lines(cause, language).join("\n")]
            };
            body += &html::table(&heading(words), &["", ""], self.causes(of).iter().map(row));
        }
        let is_wrong = |checked: &&Checked| checked.verdict == Some(Verdict::AnotherPicture);
        for checked in self.cases.iter().filter(is_wrong).take(EXAMPLES) {
            let pictures = PICTURES.iter().zip(CAPTIONS).filter_map(|(name, caption)| {
                let png = supervise::content(&checked.folder.join(name), PICTURE_BYTES)?;
                Some((format!("{}: {}", checked.case, language.pick(caption)), data_uri(&png)))
            });
            body += &html::pictures("", pictures);
        }
        body
    }
}

/// The two lists of a report, with the faults of a case that belong to them.
const SECTIONS: [(Words, Pick); 2] = [
    (["Fault", "Fallo"], |checked| &checked.faults),
    (["Remark, without loss of points", "Nota, sin pérdida de puntos"], |checked| &checked.remarks),
];

/// Returns the name of a fault, and the rule that it breaks.
fn title(fault: &Fault, language: Language) -> String {
    let rule = match &fault.section {
        Some(number) => language.say(["section {}", "sección {}"], &[number]),
        None => language.say(["a limit of this check", "un límite de esta comprobación"], &[]),
    };
    format!("{}, {rule}", language.say(fault.kind.words(), &[]))
}

fn names(cause: &Cause<'_>) -> String {
    cause.1.iter().map(|(checked, _)| checked.case.as_str()).collect::<Vec<_>>().join(", ")
}

/// Returns the examples of a cause: the line that the case is about, what was expected and found, and the command that
/// repeats the case.
fn lines(cause: &Cause<'_>, language: Language) -> Vec<String> {
    let mut lines = Vec::new();
    for (checked, fault) in cause.1.iter().take(EXAMPLES) {
        let nothing = language.say(["nothing", "nada"], &[]);
        let found = if fault.found.is_empty() && !fault.expected.is_empty() { &nothing } else { &fault.found };
        let details = [
            (["{}, for the line: {}", "{}, para la línea: {}"], &checked.line),
            (["{}, expected: {}", "{}, esperado: {}"], &fault.expected),
            (["{}, found: {}", "{}, obtenido: {}"], found),
            (["{}, repeat: {}", "{}, repetir: {}"], &checked.command),
        ];
        let details = details.into_iter().filter(|(_, text)| !text.is_empty());
        lines.extend(details.map(|(words, text)| language.say(words, &[&checked.case, text])));
    }
    lines
}
