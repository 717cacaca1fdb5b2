//! Tests that need other tools, which are looked for at run time: the literal program needs g++, losses of power and
//! careless programs need strace, and the pictures of other systems need compilers, emulators and browsers.
//!
//! A test whose tools are missing is shown as ignored, with what it needs.

#[cfg(target_os = "linux")]
#[path = "tools/careless.rs"]
mod careless;
#[path = "tools/literal.rs"]
mod literal;
#[path = "platforms/trials.rs"]
mod platforms;
#[cfg(target_os = "linux")]
#[path = "tools/power_loss.rs"]
mod power_loss;

use libtest_mimic::Arguments;

fn main() {
    #[cfg(target_os = "linux")]
    power_loss::write_if_asked();
    let arguments = Arguments::from_args();
    let mut trials = literal::trials();
    trials.extend(platforms::trials());
    #[cfg(target_os = "linux")]
    trials.extend(careless::trials().into_iter().chain(power_loss::trials()));
    libtest_mimic::run(&arguments, trials).exit();
}
