//! The jobs of the page that runs shaders in a browser and posts their results.

use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::{Value, json};
use shaders::{Features, Library};

use crate::head::{Part, head};
use crate::packed::buffer;
use crate::scenes::Case;
use crate::{Error, Float, Picture};

/// A job: one shader, its buffers, and what to run. The page gets it as JSON.
#[derive(Clone, Debug, Serialize)]
pub struct Job<'a> {
    /// The name of the result.
    pub name: &'a str,
    /// The name of the shader's text. Jobs with the same text and the same constants share a pipeline.
    #[serde(rename = "wgsl")]
    pub shader: &'a str,
    /// The name of the kernel.
    pub entry: &'a str,
    /// For each binding, whether the shader writes it.
    pub written: &'a [bool],
    /// The pipeline's constants.
    pub constants: BTreeMap<&'a str, f64>,
    /// For each binding, the name of its bytes, or the number of bytes that the shader writes.
    pub contents: Vec<Value>,
    /// The number of the binding that is the result.
    pub output: usize,
    /// How often the kernel runs: once for each case or pixel.
    pub invocations: usize,
}

/// The data that the page requests: the list of jobs, their shaders and their buffers.
#[derive(Debug, Default)]
pub struct Jobs {
    data: BTreeMap<String, Vec<u8>>,
    list: Vec<Value>,
}

impl Jobs {
    /// Adds bytes that jobs name: a shader's text or the contents of a buffer.
    pub fn add_bytes(&mut self, name: &str, bytes: Vec<u8>) {
        self.data.insert(name.to_owned(), bytes);
    }

    /// Adds a job to the list.
    pub fn add(&mut self, job: &Job) {
        self.list.push(json!(job));
    }

    /// Adds jobs that render the scenes `cases` in deterministic mode, by pipelines with these features. Their names
    /// are `picture/` and an index. A result has the linear colours of the pixels.
    ///
    /// # Errors
    /// The errors of [`Library::compose`] and of [`Picture::new`].
    pub fn add_pictures<T: Float>(&mut self, library: &Library, cases: &[(Case, Features)]) -> Result<(), Error> {
        let code = library.compose("kernels/image", T::PRECISION)?;
        self.add_bytes("wgsl/pictures", code.source().as_bytes().to_vec());
        for (index, (case, features)) in cases.iter().enumerate() {
            let picture = Picture::<T>::new(&case.config, &case.scene)?;
            let pixels = picture.size.pixels();
            let mut contents = Vec::new();
            for (part, bytes) in [
                ("head", head(&picture, &Part::Pixels { first: 0, count: pixels as u32 }, &(0..picture.max_depth))),
                ("spheres", buffer(&picture.spheres)),
                ("cylinders", buffer(&picture.cylinders)),
                ("materials", buffer(&picture.materials)),
            ] {
                let name = format!("picture/{index}/{part}");
                self.add_bytes(&name, bytes);
                contents.push(json!(name));
            }
            // Sizes as in renderer.rs: the materials that attenuate each path, the colours, and the states of paths.
            let number = size_of::<T>();
            let sizes = [pixels * features.max_depth as usize * 4, pixels * 3 * number, pixels * (6 * number + 8)];
            contents.extend(sizes.map(Value::from));
            self.add(&Job {
                name: &format!("picture/{index}"),
                shader: "wgsl/pictures",
                entry: "image",
                written: &[false, false, false, false, true, true, true],
                constants: features.constants().into(),
                contents,
                output: 5,
                invocations: pixels,
            });
        }
        Ok(())
    }

    /// Returns the data by the names that the page requests.
    #[must_use]
    pub fn into_data(mut self) -> BTreeMap<String, Vec<u8>> {
        self.data.insert("jobs".to_owned(), Value::from(self.list).to_string().into_bytes());
        self.data
    }
}
