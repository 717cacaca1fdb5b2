//! Renders pictures for the page, one at a time. A new picture stops the one before it, and so does a client that has
//! closed its connection.

use std::io::{self, Write};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use cpu::internals::image::Image;
use cpu::internals::{Ended, InstructionSet, Limits, Prepared, render_from};
use cpu::{Aos, Config, Layout, Scatter, Scene};
use loopback::Answer;
use loopback::budget::{Budget, Share};
use loopback::client::Client;
use serde::Deserialize;

use super::input::MAX_TEXT;
use super::{full, invalid, wrong};

/// Largest number of pixels of a picture for the page: 2^25.
const MAX_PIXELS: usize = 1 << 25;

/// Largest number of bytes of a pixel: three in the picture, and twelve in its file.
const PIXEL_BYTES: usize = 15;

/// Largest number of surfaces that the paths of a span may hit. The renderer colours these surfaces in one step, which
/// cannot be cancelled and takes about 10 ms.
const MAX_SURFACES: usize = 1 << 23;

/// Bytes of the paths of a picture. A list of surfaces of 8 bytes each is copied when it grows to double its length.
const PATH_BYTES: usize = 12 * MAX_SURFACES;

/// Time between two looks at whether the client is still there.
const PAUSE: Duration = Duration::from_millis(20);

/// The renderer behind the page.
#[derive(Debug)]
pub struct Native {
    /// The number of the picture that was requested last, and the request to stop it.
    current: Mutex<(u32, Arc<AtomicBool>)>,
    /// The number of finished rows, and of all rows.
    rows: [AtomicUsize; 2],
    /// Held while a picture is rendered.
    busy: Mutex<()>,
    /// The bytes of pictures, paths and answers.
    budget: Budget,
}

/// The body of a request for a picture.
#[derive(Deserialize)]
struct Texts {
    config: String,
    scene: String,
}

/// The file of a picture in memory. Writing fails when the picture is to stop.
struct File<'a> {
    bytes: &'a mut Vec<u8>,
    limits: &'a Limits,
}

impl Write for File<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.limits.is_stopped() {
            return Err(io::ErrorKind::ConnectionAborted.into());
        }
        self.bytes.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn too_large(message: String) -> Answer {
    Answer::refused("413 Content Too Large", message)
}

fn cancelled() -> Answer {
    Answer::refused("409 Conflict", "the picture was cancelled")
}

impl Native {
    /// Returns a renderer whose bytes are counted in `budget`.
    pub fn new(budget: Budget) -> Self {
        let rows = [0, 0].map(AtomicUsize::new);
        Self { current: Mutex::default(), rows, busy: Mutex::default(), budget }
    }

    /// Renders picture number `number`, whose texts are in `body`, and returns the PPM file as an answer. Stops when
    /// the client has gone.
    pub fn render(&self, number: u32, body: &[u8], client: &Client) -> Answer {
        let stop = Arc::<AtomicBool>::default();
        let (_, before) = std::mem::replace(&mut *self.current(), (number, Arc::clone(&stop)));
        before.store(true, Ordering::SeqCst);
        let (sender, receiver) = mpsc::channel::<()>();
        std::thread::scope(|scope| {
            let stop_of_picture = Arc::clone(&stop);
            let work = move || {
                let result = self.ppm(&stop_of_picture, body);
                drop(sender);
                result
            };
            let Ok(thread) = std::thread::Builder::new().name("picture".to_owned()).spawn_scoped(scope, work) else {
                return Answer::refused("503 Service Unavailable", "no thread can be started");
            };
            // The channel closes when the picture is finished.
            while receiver.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout) {
                if client.is_gone() {
                    stop.store(true, Ordering::SeqCst);
                }
            }
            match thread.join() {
                Ok(Ok((ppm, share))) => Answer { share: Some(share), ..Answer::ok("image/x-portable-pixmap", ppm) },
                Ok(Err(refusal)) => refusal,
                Err(panic) => std::panic::resume_unwind(panic),
            }
        })
    }

    /// Stops picture number `number`. Other pictures continue.
    pub fn cancel(&self, number: u32) {
        let current = self.current();
        if current.0 == number {
            current.1.store(true, Ordering::SeqCst);
        }
    }

    /// Returns the number of finished rows and of all rows, with a blank between them.
    pub fn progress(&self) -> String {
        let [done, all] = self.rows.each_ref().map(|count| count.load(Ordering::SeqCst));
        format!("{done} {all}")
    }

    fn current(&self) -> MutexGuard<'_, (u32, Arc<AtomicBool>)> {
        self.current.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns the PPM file of the two texts in `body`, with its share of the budget.
    fn ppm(&self, stop: &Arc<AtomicBool>, body: &[u8]) -> Result<(Vec<u8>, Share), Answer> {
        let _busy = self.busy.lock().unwrap_or_else(PoisonError::into_inner);
        let check = || if stop.load(Ordering::SeqCst) { Err(cancelled()) } else { Ok(()) };
        check()?;
        // A text in JSON is at least as long as the text itself.
        let share_of_texts = self.budget.take(body.len()).map_err(full)?;
        let texts: Texts = serde_json::from_slice(body).map_err(|error| invalid(error.to_string()))?;
        for (name, text) in [("configuration", &texts.config), ("scene", &texts.scene)] {
            if text.len() as u64 > MAX_TEXT {
                let length = text.len();
                let text = format!("the {name} has {length} bytes, and the page renders at most {MAX_TEXT}");
                return Err(too_large(text));
            }
        }
        let config = Config::parse(texts.config.as_bytes()).map_err(wrong)?;
        let pixels = config.image_size().map_err(|error| wrong(error.into()))?.pixels();
        if pixels > MAX_PIXELS {
            return Err(too_large(format!(
                "the picture has {pixels} pixels, and the page shows at most {MAX_PIXELS}; render-lab render has no \
                 such limit"
            )));
        }
        let mut share = self.budget.take(pixels * PIXEL_BYTES + PATH_BYTES).map_err(full)?;
        let scene = Scene::parse(texts.scene.as_bytes()).map_err(wrong)?;
        drop((texts, share_of_texts));
        check()?;
        let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement).map_err(wrong)?;
        self.rows[0].store(0, Ordering::SeqCst);
        self.rows[1].store(prepared.size.height(), Ordering::SeqCst);
        let mut image = <Aos as Layout>::Image::black(prepared.size).map_err(wrong)?;
        let limits = Limits { stop: Arc::clone(stop), surfaces: MAX_SURFACES, ..Limits::prompt(scene.objects.len()) };
        drop(scene);
        let ended = render_from(&prepared, InstructionSet::chosen(), &limits, (0, &[]), &mut image, |rows, _, _| {
            self.rows[0].store(rows, Ordering::SeqCst);
            ControlFlow::Continue(())
        });
        match ended.map_err(wrong)? {
            None => {}
            Some(Ended::Stopped) => return Err(cancelled()),
            Some(Ended::TooManySurfaces) => {
                return Err(too_large(format!(
                    "the paths of a few pixels hit more than {MAX_SURFACES} surfaces, which is the limit of the page; \
                     choose a smaller max_depth, or use render-lab render"
                )));
            }
        }
        drop(prepared);
        let mut ppm = Vec::new();
        let no_memory = |_| invalid("Not enough memory for the file of the picture");
        // The header has less than a hundred bytes.
        ppm.try_reserve_exact(pixels * (PIXEL_BYTES - 3) + 100).map_err(no_memory)?;
        // The only reason for which this writer fails is the request to stop.
        cpu::write_ppm(&image, &mut File { bytes: &mut ppm, limits: &limits }).map_err(|_| cancelled())?;
        drop(image);
        share.shrink(ppm.len());
        Ok((ppm, share))
    }
}
