//! Renders pictures for the page, one at a time. A new picture stops the one before it.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use cpu::internals::image::Image;
use cpu::internals::{InstructionSet, Prepared, render_into};
use cpu::{Aos, Config, Error, Layout, Scatter, Scene};
use loopback::Answer;
use serde::Deserialize;

/// Largest number of pixels of a picture for the page. Its file has at most 12 bytes for each pixel.
const MAX_PIXELS: usize = 1 << 26;

/// The renderer behind the page.
#[derive(Debug, Default)]
pub struct Native {
    /// One more than the number of the picture that is wanted now, or 0 if none is wanted.
    wanted: AtomicU64,
    /// The number of finished rows, and of all rows.
    rows: [AtomicUsize; 2],
    /// Held while a picture is rendered.
    busy: Mutex<()>,
}

/// The body of a request for a picture.
#[derive(Deserialize)]
struct Texts {
    config: String,
    scene: String,
}

/// The reason why a request for a picture gets none.
enum Refusal {
    /// An error of the renderer, or a text that is no JSON.
    Message(String),
    TooLarge,
    /// Another picture is wanted, or none.
    Cancelled,
}

impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        Self::Message(String::from_utf8_lossy(&error.message()).into_owned())
    }
}

impl Native {
    /// Renders picture number `number`, whose texts are in `body`, and returns the PPM file as an answer.
    pub fn render(&self, number: u32, body: &[u8]) -> Answer {
        let number = u64::from(number) + 1;
        self.wanted.store(number, Ordering::SeqCst);
        let _busy = self.busy.lock().unwrap_or_else(PoisonError::into_inner);
        match self.ppm(number, body) {
            Ok(ppm) => Answer::ok("image/x-portable-pixmap", ppm),
            Err(Refusal::Message(message)) => Answer::refused("422 Unprocessable Content", message),
            Err(Refusal::TooLarge) => Answer::refused(
                "413 Content Too Large",
                format!("the page shows at most {MAX_PIXELS} pixels; render-lab render has no such limit"),
            ),
            Err(Refusal::Cancelled) => Answer::refused("409 Conflict", "the picture was cancelled"),
        }
    }

    /// Stops picture number `number`. Other pictures continue.
    pub fn cancel(&self, number: u32) {
        // The picture is not wanted any more if another one has been requested since, so nothing changes then.
        let _ = self.wanted.compare_exchange(u64::from(number) + 1, 0, Ordering::SeqCst, Ordering::SeqCst);
    }

    /// Returns the number of finished rows and of all rows, with a blank between them.
    pub fn progress(&self) -> String {
        let [done, all] = self.rows.each_ref().map(|count| count.load(Ordering::SeqCst));
        format!("{done} {all}")
    }

    fn ppm(&self, number: u64, body: &[u8]) -> Result<Vec<u8>, Refusal> {
        let is_wanted = || self.wanted.load(Ordering::SeqCst) == number;
        if !is_wanted() {
            return Err(Refusal::Cancelled);
        }
        let texts: Texts = serde_json::from_slice(body).map_err(|error| Refusal::Message(error.to_string()))?;
        let (config, scene) = (Config::parse(texts.config.as_bytes())?, Scene::parse(texts.scene.as_bytes())?);
        let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement)?;
        if prepared.size.pixels() > MAX_PIXELS {
            return Err(Refusal::TooLarge);
        }
        self.rows[0].store(0, Ordering::SeqCst);
        self.rows[1].store(prepared.size.height(), Ordering::SeqCst);
        let mut image = <Aos as Layout>::Image::black(prepared.size)?;
        let flow = render_into(&prepared, InstructionSet::chosen(), &mut image, |rows, _| {
            self.rows[0].store(rows, Ordering::SeqCst);
            if is_wanted() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        })?;
        if flow.is_break() {
            return Err(Refusal::Cancelled);
        }
        let mut ppm = Vec::new();
        cpu::write_ppm(&image, &mut ppm).map_err(|error| Refusal::Message(error.to_string()))?;
        Ok(ppm)
    }
}
