//! Parses a Markdown page into the parts that the checks need.

use std::collections::BTreeSet;
use std::ops::Range;

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

/// A link or an image in a page, with its line and its target.
#[derive(Debug, PartialEq, Eq)]
pub struct Link {
    pub line: usize,
    pub to: String,
    /// The code spans in the text of the link, joined.
    pub code: String,
}

/// The parts of a page. Each number is the number of a line, from 1.
#[derive(Debug, Default)]
pub struct Page {
    /// The headings as they are written.
    pub titles: Vec<String>,
    /// The headings in the form that links use, such as `some-heading`.
    pub headings: Vec<String>,
    pub links: Vec<Link>,
    /// The code spans, and the lines of code blocks.
    pub code: Vec<(usize, String)>,
    /// The cells of all tables: a list for each row.
    pub rows: Vec<Vec<String>>,
    /// The lines outside of tables, code blocks and HTML, except empty lines and lines with only a link.
    pub prose: Vec<(usize, String)>,
}

impl Page {
    /// Parses the text of a page.
    pub fn parse(text: &str) -> Self {
        let mut page = Self::default();
        let line = |offset: usize| text[..offset].matches('\n').count() + 1;
        let mut not_prose = BTreeSet::new();
        let mut heading = None::<String>;
        let (mut in_code, mut in_table, mut in_link) = (false, false, false);
        for (event, Range { start, end }) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
            match event {
                Event::Start(tag @ (Tag::Table(_) | Tag::CodeBlock(_) | Tag::HtmlBlock)) => {
                    (in_table, in_code) = (matches!(tag, Tag::Table(_)), matches!(tag, Tag::CodeBlock(_)));
                    not_prose.extend(line(start)..=line(end.saturating_sub(1)));
                }
                Event::End(TagEnd::Table | TagEnd::CodeBlock) => (in_table, in_code) = (false, false),
                Event::Start(Tag::TableRow | Tag::TableHead) => page.rows.push(Vec::new()),
                Event::Start(Tag::TableCell) => page.rows.last_mut().expect("a row").push(String::new()),
                Event::End(TagEnd::Link | TagEnd::Image) => in_link = false,
                Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                    in_link = true;
                    page.links.push(Link { line: line(start), to: dest_url.to_string(), code: String::new() });
                }
                Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
                Event::End(TagEnd::Heading(_)) => {
                    let title = heading.take().expect("a heading ends where one has begun");
                    page.headings.push(anchor(&title, &page.titles));
                    page.titles.push(title);
                }
                Event::Text(words) if in_code => {
                    page.code.extend(words.lines().enumerate().map(|(index, it)| (line(start) + index, it.to_owned())));
                }
                Event::Text(ref words) | Event::Code(ref words) => {
                    heading.iter_mut().for_each(|title| title.push_str(words));
                    if let Some(cell) = page.rows.last_mut().and_then(|row| row.last_mut()).filter(|_| in_table) {
                        cell.push_str(words);
                    }
                    if matches!(event, Event::Code(_)) {
                        page.code.push((line(start), words.to_string()));
                        page.links
                            .iter_mut()
                            .rev()
                            .take(usize::from(in_link))
                            .for_each(|link| link.code.push_str(words));
                    }
                }
                _ => {}
            }
        }
        let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.to_owned()));
        let lines = lines.filter(|(_, line)| !line.is_empty() && !is_link_alone(line));
        page.prose = lines.filter(|(number, _)| !not_prose.contains(number)).collect();
        page
    }
}

/// Returns the form of a heading that links use: letters, digits, `-` and `_`, in lower case. If `before` has equal
/// headings, their number is added.
fn anchor(title: &str, before: &[String]) -> String {
    let plain = |title: &str| -> String {
        let letters = title.to_lowercase().replace(' ', "-");
        letters.chars().filter(|letter| letter.is_alphanumeric() || "-_".contains(*letter)).collect()
    };
    let (name, times) = (plain(title), before.iter().filter(|other| plain(other) == plain(title)).count());
    if times == 0 { name } else { format!("{name}-{times}") }
}

/// Whether a line contains only a link or an image, so that it cannot be broken.
fn is_link_alone(line: &str) -> bool {
    let line = line.trim_start_matches(['-', '*', ' ', '!', '(']).trim_end_matches(['.', ',', ':', ';', ')', ' ']);
    line.starts_with("http") && !line.contains(' ')
        || line.starts_with('[')
            && line.matches("](").count() == 1
            && line.rsplit("](").next().is_some_and(|to| !to.contains(' '))
}
