//! Chooses the GPU adapter: lavapipe, unless an environment variable names another one.
//!
//! The default is a fixed driver and not the fastest one, because results depend on the driver. The variable
//! `WGPU_ADAPTER_NAME` takes any part of another adapter's name. The variable `WGPU_BACKEND` takes the interface to
//! search, such as `vulkan`.

use wgpu::{Adapter, Backends, Instance, InstanceDescriptor};

use crate::Error;

/// A part of the name that lavapipe reports.
const LAVAPIPE: &str = "llvmpipe";

/// Returns the adapter that the environment names, or lavapipe if it names none.
///
/// # Errors
/// [`Error::NoAdapter`] if no adapter has the wanted name. The error lists the names of the existing adapters.
pub fn choose() -> Result<Adapter, Error> {
    let wanted = std::env::var("WGPU_ADAPTER_NAME").ok();
    let mut adapters = existing();
    let names: Vec<_> = adapters.iter().map(|adapter| adapter.get_info().name).collect();
    let index = pick(&names, wanted.as_deref()).ok_or_else(|| no_adapter(&names, wanted.as_deref()))?;
    Ok(adapters.swap_remove(index))
}

/// Returns all adapters of the interface that the environment names, or of Vulkan if it names none.
fn existing() -> Vec<Adapter> {
    let backends = Backends::from_env().unwrap_or(Backends::VULKAN);
    let instance = Instance::new(InstanceDescriptor { backends, ..InstanceDescriptor::new_without_display_handle() });
    pollster::block_on(instance.enumerate_adapters(backends))
}

/// Whether `name` contains `wanted`. The case of letters is ignored.
fn has_name(name: &str, wanted: &str) -> bool {
    name.to_lowercase().contains(&wanted.to_lowercase())
}

/// Returns the index of the first of `names` that contains `wanted`, or that contains lavapipe's name if `wanted` is
/// `None`. The case of letters is ignored.
fn pick(names: &[String], wanted: Option<&str>) -> Option<usize> {
    names.iter().position(|name| has_name(name, wanted.unwrap_or(LAVAPIPE)))
}

fn no_adapter(names: &[String], wanted: Option<&str>) -> Error {
    let wanted = match wanted {
        Some(name) => format!("has [{name}] in its name (WGPU_ADAPTER_NAME)"),
        None => "is lavapipe".to_owned(),
    };
    let found = if names.is_empty() { ": there is none at all".to_owned() } else { format!(": there is {names:?}") };
    Error::NoAdapter { wanted, found }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lavapipe_is_the_default_even_beside_a_faster_one_and_a_name_in_the_environment_replaces_it() {
        let names = ["NVIDIA H200", "llvmpipe (LLVM 15.0.6, 256 bits)"].map(str::to_owned);
        assert_eq!([None, Some("nvidia"), Some("radeon")].map(|name| pick(&names, name)), [Some(1), Some(0), None]);
        let message = no_adapter(&names, Some("radeon")).to_string();
        assert!(message.contains("has [radeon] in its name (WGPU_ADAPTER_NAME): there is [\"NVIDIA H200\", "));
    }
}
