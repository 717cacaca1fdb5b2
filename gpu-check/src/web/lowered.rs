//! The jobs of the page that runs f64 by integers: operations, and pictures in deterministic mode.

use std::collections::BTreeMap;

use shaders::lower::Arithmetic;
use shaders::{Composition, Library, Precision};

use crate::head::{Part, head};
use crate::lowered::operands::Operands;
use crate::lowered::operations::Operation;
use crate::packed::buffer;
use crate::scenes::Case;
use crate::{Error, Picture, features_of};

/// The data that the page requests: the list of jobs, their shaders and their buffers.
#[derive(Debug)]
pub struct Jobs {
    data: BTreeMap<String, Vec<u8>>,
    list: Vec<String>,
}

impl Jobs {
    /// Returns jobs that calculate each of `operations` for all `cases`. Their names are `operation/` and an index.
    ///
    /// # Errors
    /// The errors of lowering.
    pub fn of_operations<'a>(
        operations: impl Iterator<Item = &'a Operation>,
        cases: &[Operands],
    ) -> Result<Self, Error> {
        let packed: Vec<_> = cases.iter().map(Operands::packed).collect();
        let bytes = bytemuck::cast_slice(&packed).to_vec();
        let mut jobs = Self { data: BTreeMap::from([("cases".to_owned(), bytes)]), list: Vec::new() };
        for (index, operation) in operations.enumerate() {
            let text = crate::lowered::kernel(operation);
            let composition = Composition::of_file(operation.wgsl, text, Precision::F64);
            let code = composition.lowered(&Arithmetic::standard())?;
            let contents = format!("[\"cases\", {}]", cases.len() * operation.outcome.size());
            let name = format!("operation/{index}");
            jobs.add(&name, &code, "operation", &[false, true], "{}", &contents, [1, cases.len()]);
        }
        Ok(jobs)
    }

    /// Adds jobs that render the scenes `cases`. Their names are `picture/` and an index.
    ///
    /// # Errors
    /// The errors of lowering, and of [`Picture::new`].
    pub fn add_pictures(&mut self, cases: &[Case]) -> Result<(), Error> {
        let library = Library::standard().lowered(Arithmetic::standard());
        let code = library.compose("kernels/image", Precision::F64)?;
        for (index, case) in cases.iter().enumerate() {
            let picture = Picture::<f64>::new(&case.config, &case.scene)?;
            // A shader without what the scene does not need is compiled sooner.
            let constants = features_of(&case.config, &case.scene)?.constants();
            let constants: Vec<_> = constants.iter().map(|(name, value)| format!("{name:?}: {value}")).collect();
            let constants = format!("{{{}}}", constants.join(", "));
            let pixels = picture.size.pixels();
            let mut keys = Vec::new();
            for (part, bytes) in [
                ("head", head(&picture, &Part::Pixels { first: 0, count: pixels as u32 }, &(0..picture.max_depth))),
                ("spheres", buffer(&picture.spheres)),
                ("cylinders", buffer(&picture.cylinders)),
                ("materials", buffer(&picture.materials)),
            ] {
                let key = format!("picture/{index}/{part}");
                keys.push(format!("{key:?}"));
                self.data.insert(key, bytes);
            }
            // Sizes as in renderer.rs: the materials that attenuate each path, the colours, and the states of paths.
            let sizes = [pixels * picture.max_depth as usize * 4, pixels * 24, pixels * 56];
            let contents = format!("[{}, {}, {}, {}]", keys.join(", "), sizes[0], sizes[1], sizes[2]);
            let written = [false, false, false, false, true, true, true];
            let name = format!("picture/{index}");
            self.add(&name, &code, "image", &written, &constants, &contents, [5, pixels]);
        }
        Ok(())
    }

    /// Returns the data by the names that the page requests.
    #[must_use]
    pub fn into_data(mut self) -> BTreeMap<String, Vec<u8>> {
        self.data.insert("jobs".to_owned(), format!("[{}]", self.list.join(",\n")).into_bytes());
        self.data
    }

    /// Adds a job. `last` has the number of the binding that is the result, and the number of invocations.
    #[expect(clippy::too_many_arguments, reason = "each is a member of the job")]
    fn add(
        &mut self,
        name: &str,
        code: &Composition,
        entry: &str,
        written: &[bool],
        constants: &str,
        contents: &str,
        last: [usize; 2],
    ) {
        let wgsl = format!("wgsl/{name}");
        self.list.push(format!(
            "{{\"name\": {name:?}, \"wgsl\": {wgsl:?}, \"entry\": {entry:?}, \"written\": {written:?}, \
             \"constants\": {constants}, \"contents\": {contents}, \"output\": {}, \"invocations\": {}}}",
            last[0], last[1]
        ));
        self.data.insert(wgsl, code.source().as_bytes().to_vec());
    }
}
