//! A progress bar for long renderings.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Returns a bar on standard error for work of `parts` parts. Its text begins with `words`, and it vanishes when it is
/// dropped. It shows nothing if standard error is not a terminal.
#[must_use]
pub fn bar(words: &'static str, parts: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg}: {percent} %, about {eta} left");
    ProgressBar::with_draw_target(Some(parts as u64), ProgressDrawTarget::stderr())
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        .with_message(words)
}
