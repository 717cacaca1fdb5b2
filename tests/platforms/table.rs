//! The systems on which pictures are rendered.

use std::path::Path;
use std::sync::Arc;

use super::build::{Build, COMPILER, Need, SOURCES, compiler_is_too_old};
use super::host::Host;

/// The variable that asks for the slow trials. With `RENDER_ALL=1` those that take many minutes are run too.
pub const VARIABLE: &str = "RENDER_PLATFORMS";

const ARM_LIBRARY: Need = ("/usr/lib/rustlib/aarch64-unknown-linux-gnu/lib", "libstd-rust-web-dev:arm64");
const ARM_LINKER: Need = ("/usr/bin/aarch64-linux-gnu-gcc", "gcc-aarch64-linux-gnu");
const ARM_C: Need = ("/usr/aarch64-linux-gnu/lib/ld-linux-aarch64.so.1", "libc6-dev-arm64-cross");
const MUSL_LINKER: Need = ("/usr/bin/musl-gcc", "musl-tools");
const S390X_LINKER: Need = ("/usr/bin/s390x-linux-gnu-gcc", "gcc-s390x-linux-gnu");
const S390X_C: Need = ("/usr/s390x-linux-gnu/lib/ld64.so.1", "libc6-dev-s390x-cross");

/// A system on which the pictures are rendered.
#[derive(Debug)]
pub struct Platform {
    pub name: &'static str,
    pub build: Arc<Build>,
    pub host: Host,
    /// The instruction sets that the renderer is forced to take.
    pub sets: &'static [&'static str],
    /// Whether the digests are compared only if [`VARIABLE`] is set.
    pub is_slow: bool,
}

/// Returns all platforms.
pub fn platforms() -> Vec<Platform> {
    let with_lanes = Arc::new(Build::wasm("wasm32-simd128", "-C strip=symbols -C target-feature=+simd128"));
    let without = Arc::new(Build::wasm("wasm32", "-C strip=symbols"));
    let arm = &[COMPILER, ARM_LIBRARY, ARM_LINKER, ARM_C];
    let arm = Build::programs("aarch64", "aarch64-unknown-linux-gnu", ARM_LINKER.0, arm);
    let s390x = &[COMPILER, SOURCES, S390X_LINKER, S390X_C];
    let s390x = Build::programs("s390x", "s390x-unknown-linux-gnu", S390X_LINKER.0, s390x);
    let musl = &[COMPILER, SOURCES, MUSL_LINKER];
    // Rust has its own start files and library of C for musl. Debian's compiler lacks them, so `musl-gcc` adds those of
    // Debian.
    let musl = Build::programs("musl", "x86_64-unknown-linux-musl", MUSL_LINKER.0, musl)
        .with_flags("-C link-self-contained=no -L native=tests/platforms/musl");
    let emulator = |file, libraries| Host::Emulator { qemu: (file, "qemu-user"), libraries };
    let slow =
        |name, build: &Arc<Build>, host, sets| Platform { name, build: Arc::clone(build), host, sets, is_slow: true };
    let node = slow("wasm32-simd128", &with_lanes, Host::Node, &["simd128", "portable"]);
    vec![
        Platform { is_slow: false, ..node },
        slow("wasm32", &without, Host::Node, &["portable"]),
        slow(
            "aarch64",
            &Arc::new(arm),
            emulator("/usr/bin/qemu-aarch64", "/usr/aarch64-linux-gnu"),
            &["neon", "portable"],
        ),
        slow("x86-64 musl", &Arc::new(musl), Host::Native, &["avx2", "portable"]),
        // The bytes of a number are in the opposite order there.
        slow("s390x", &Arc::new(s390x), emulator("/usr/bin/qemu-s390x", "/usr/s390x-linux-gnu"), &["portable"]),
    ]
}

impl Platform {
    /// Returns which packages the platform needs that are not installed, or `None` if all are.
    pub fn missing(&self) -> Option<String> {
        let files = self.build.needs.iter().filter(|(file, _)| !Path::new(file).exists());
        let missing: Vec<_> = files.map(|(_, package)| *package).chain(self.host.missing()).collect();
        if missing.is_empty() { compiler_is_too_old() } else { Some(format!("needs {}", missing.join(", "))) }
    }
}
