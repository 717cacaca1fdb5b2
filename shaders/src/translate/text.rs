//! Calls naga's writers, with the options that make their results complete.

use naga::back::{glsl, hlsl, msl, spv};
use naga::proc::BoundsCheckPolicies;
use naga::valid::ModuleInfo;
use naga::{Module, ResourceBinding, ShaderStage};

use crate::validate::{Binding, bindings};

/// A valid module and the name of its entry point. The pipeline-overridable constants have their final values.
pub struct Input<'a> {
    pub module: &'a Module,
    pub info: &'a ModuleInfo,
    pub entry: &'a str,
}

impl Input<'_> {
    /// Returns every buffer of the module, with the identifier that naga's writers use for it.
    fn bindings(&self) -> impl Iterator<Item = (ResourceBinding, Binding)> {
        bindings(self.module).map(|binding| (ResourceBinding { group: 0, binding: binding.number }, binding))
    }

    pub fn spirv(&self) -> Result<Vec<u32>, String> {
        // Without this flag, naga writes names only in debug builds, and the goldens would depend on the build profile.
        let options = spv::Options { flags: spv::WriterFlags::DEBUG, ..spv::Options::default() };
        let entry = spv::PipelineOptions { shader_stage: ShaderStage::Compute, entry_point: self.entry.to_owned() };
        spv::write_vec(self.module, self.info, &options, Some(&entry)).map_err(|error| error.to_string())
    }

    pub fn msl(&self) -> Result<String, String> {
        let mut slots = msl::EntryPointResources::default();
        let mut last = 0;
        for (key, Binding { number, written, .. }) in self.bindings() {
            let slot = number as msl::Slot;
            last = last.max(slot);
            slots.resources.insert(key, msl::BindTarget { buffer: Some(slot), mutable: written, ..Default::default() });
        }
        // A Metal shader cannot find out the length of its buffers, so one more buffer holds their lengths.
        slots.sizes_buffer = Some(last + 1);
        let options = msl::Options {
            lang_version: (2, 0),
            per_entry_point_map: [(self.entry.to_owned(), slots)].into(),
            fake_missing_bindings: false,
            ..msl::Options::default()
        };
        msl::write_string(self.module, self.info, &options, &msl::PipelineOptions::default())
            .map(|(text, _)| text)
            .map_err(|error| error.to_string())
    }

    pub fn hlsl(&self) -> Result<String, String> {
        let binding_map = self
            .bindings()
            .map(|(key, binding)| (key, hlsl::BindTarget { register: binding.number, ..Default::default() }))
            .collect();
        let options = hlsl::Options { binding_map, fake_missing_bindings: false, ..hlsl::Options::default() };
        let entry = hlsl::PipelineOptions::default();
        let mut text = String::new();
        hlsl::Writer::new(&mut text, &options, &entry)
            .write(self.module, self.info, None)
            .map_err(|error| error.to_string())?;
        Ok(text)
    }

    pub fn glsl(&self, version: glsl::Version) -> Result<String, String> {
        let binding_map = self.bindings().map(|(key, binding)| (key, binding.number as u8)).collect();
        let options = glsl::Options { version, binding_map, ..glsl::Options::default() };
        let entry = glsl::PipelineOptions {
            shader_stage: ShaderStage::Compute,
            entry_point: self.entry.to_owned(),
            multiview: None,
        };
        let mut text = String::new();
        glsl::Writer::new(&mut text, self.module, self.info, &options, &entry, BoundsCheckPolicies::default())
            .and_then(|mut writer| writer.write())
            .map_err(|error| error.to_string())?;
        Ok(text)
    }
}
