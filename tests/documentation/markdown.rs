//! What a page in Markdown consists of.

use std::collections::BTreeSet;
use std::ops::Range;

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use crate::words;

/// A page, taken apart. Numbers are those of lines, from 1.
#[derive(Debug, Default)]
pub struct Page {
    /// Its headings as they are written.
    pub titles: Vec<String>,
    /// Its headings as links name them.
    pub headings: Vec<String>,
    /// Where its links and images lead.
    pub links: Vec<(usize, String)>,
    /// What is set as code: spans, and the lines of blocks.
    pub code: Vec<(usize, String)>,
    /// Its sentences outside of tables and code. A span of code is the word `code`.
    pub sentences: Vec<(usize, String)>,
    /// Its lines outside of tables, blocks of code and HTML, but for empty ones and those that hold a link alone.
    pub prose: Vec<(usize, String)>,
}

impl Page {
    /// Takes a page apart.
    pub fn parse(text: &str) -> Self {
        let mut page = Self::default();
        let line = |offset: usize| text[..offset].matches('\n').count() + 1;
        let mut not_prose = BTreeSet::new();
        let mut paragraph = Paragraph::default();
        let (mut heading, mut in_code, mut in_table, mut in_image) = (None::<String>, false, false, false);
        for (event, Range { start, end }) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
            match event {
                Event::Start(Tag::Table(_)) => {
                    in_table = true;
                    not_prose.extend(line(start)..=line(end.saturating_sub(1)));
                }
                Event::End(TagEnd::Table) => in_table = false,
                Event::Start(Tag::CodeBlock(_)) => {
                    in_code = true;
                    not_prose.extend(line(start)..=line(end.saturating_sub(1)));
                }
                Event::End(TagEnd::CodeBlock) => in_code = false,
                Event::Start(Tag::HtmlBlock) => not_prose.extend(line(start)..=line(end.saturating_sub(1))),
                Event::Start(Tag::Link { dest_url, .. }) => page.links.push((line(start), dest_url.to_string())),
                Event::Start(Tag::Image { dest_url, .. }) => {
                    in_image = true;
                    page.links.push((line(start), dest_url.to_string()));
                }
                Event::End(TagEnd::Image) => in_image = false,
                Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
                Event::End(TagEnd::Heading(_)) => {
                    let title = heading.take().expect("a heading ends where one has begun");
                    page.headings.push(anchor(&title, &page.titles));
                    page.titles.push(title);
                    paragraph.end(&mut page.sentences);
                }
                Event::Start(Tag::Paragraph | Tag::Item | Tag::List(_))
                | Event::End(TagEnd::Paragraph | TagEnd::Item | TagEnd::List(_)) => paragraph.end(&mut page.sentences),
                Event::Text(words) if in_code => {
                    page.code.extend(words.lines().enumerate().map(|(index, it)| (line(start) + index, it.to_owned())));
                }
                Event::Text(words) => {
                    heading.iter_mut().for_each(|title| title.push_str(&words));
                    if !in_table && !in_image {
                        paragraph.add(line(start), &words);
                    }
                }
                Event::Code(words) => {
                    heading.iter_mut().for_each(|title| title.push_str(&words));
                    page.code.push((line(start), words.to_string()));
                    if !in_table && !in_image {
                        paragraph.add(line(start), "code");
                    }
                }
                Event::SoftBreak | Event::HardBreak => paragraph.add(line(start), " "),
                _ => {}
            }
        }
        paragraph.end(&mut page.sentences);
        let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.to_owned()));
        let lines = lines.filter(|(_, line)| !line.is_empty() && !is_link_alone(line));
        page.prose = lines.filter(|(number, _)| !not_prose.contains(number)).collect();
        page
    }
}

/// A paragraph as it is read.
#[derive(Debug, Default)]
struct Paragraph {
    line: usize,
    text: String,
}

impl Paragraph {
    fn add(&mut self, line: usize, text: &str) {
        if self.text.is_empty() {
            self.line = line;
        }
        self.text.push_str(text);
    }

    fn end(&mut self, sentences: &mut Vec<(usize, String)>) {
        let text = std::mem::take(&mut self.text);
        sentences.extend(words::sentences(&text).into_iter().map(|sentence| (self.line, sentence)));
    }
}

/// How a link names a heading: letters, digits, `-` and `_`, in lower case, with a number where it was there before.
fn anchor(title: &str, before: &[String]) -> String {
    let plain = |title: &str| -> String {
        let letters = title.to_lowercase().replace(' ', "-");
        letters.chars().filter(|letter| letter.is_alphanumeric() || "-_".contains(*letter)).collect()
    };
    let (name, times) = (plain(title), before.iter().filter(|other| plain(other) == plain(title)).count());
    if times == 0 { name } else { format!("{name}-{times}") }
}

/// Whether a line holds a link or an image and nothing else, so that it cannot be broken.
fn is_link_alone(line: &str) -> bool {
    let line = line.trim_start_matches(['-', '*', ' ', '!', '(']).trim_end_matches(['.', ',', ':', ';', ')', ' ']);
    line.starts_with("http") && !line.contains(' ')
        || line.starts_with('[')
            && line.matches("](").count() == 1
            && line.rsplit("](").next().is_some_and(|to| !to.contains(' '))
}
