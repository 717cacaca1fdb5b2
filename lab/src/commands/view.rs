//! `render-lab view`: serves the page of `web/site` on this machine, with two input files that it loads and saves.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use clap::Args;
use loopback::Server;
use output::Options;

use crate::view::{Input, PRIVATE, Site, View};
use crate::{Failure, terminal};

/// Options of `view`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/view.txt").trim_ascii_end())]
pub struct Arguments {
    /// Configuration file
    config: PathBuf,
    /// Scene file
    scene: PathBuf,
    /// Folder of the page [default: out/site of the checkout of this program, or else the page installed with it]
    #[arg(long, value_name = "FOLDER")]
    site: Option<PathBuf>,
    /// Port of the address 127.0.0.1; 0 takes any free port, but a browser keeps texts for each port
    #[arg(long, default_value_t = 8020)]
    port: u16,
    /// Open the page in the browser
    #[arg(long)]
    open: bool,
}

impl Arguments {
    /// Serves the page until the process is stopped. Prints the page's address. `how` tells how a text is saved.
    ///
    /// # Errors
    /// A file that cannot be read, an error of the page's folder, or a port that is in use. A fault in a text is none,
    /// because the page shows it.
    pub fn run(&self, how: Options) -> Result<(), Failure> {
        let inputs = [Input::new(&self.config)?, Input::new(&self.scene)?];
        let own = || own_site(&std::env::current_exe().ok()?);
        let site = self.site.clone().or_else(own).ok_or("the program does not know where it is; use --site")?;
        let site = Site::read(&site)?;
        let server = Server::new(self.port).map_err(|error| {
            format!("cannot listen at 127.0.0.1:{}: {error}; choose another port with --port", self.port)
        })?;
        let server = server.with_secret(PRIVATE).map_err(|error| format!("no secret for the page: {error}"))?;
        let url = server.url()?;
        terminal::print(&url)?;
        if self.open {
            open(&url).unwrap_or_else(|error| no_browser(&error.to_string()));
        }
        let view = View::new(site, inputs, how);
        // The result is an error or never comes.
        server.serve(move |request| view.answer(&request)).map(|_| ()).map_err(Failure::from)
    }
}

/// Returns the folder of the page that belongs to the program at `own`: that of the checkout in which the program was
/// built, or the one that was installed with it. The current folder does not count: it may be one that a stranger has
/// made, whose page would get the secret.
fn own_site(own: &Path) -> Option<PathBuf> {
    let folder = own.parent()?;
    let is_target = |folder: &&Path| folder.file_name().is_some_and(|name| name == "target");
    let built = folder.ancestors().find(is_target).and_then(|target| Some(target.parent()?.join("out/site")));
    built.or_else(|| Some(folder.parent()?.join("share/exact-renderer/site")))
}

/// Says that the browser was not opened.
fn no_browser(reason: &str) {
    terminal::note(&format!("cannot open the browser: {reason}; open the address yourself"));
}

/// Opens the page in the user's browser.
///
/// All users of a machine can see the arguments of a program, so the address with the secret must not be one. It is in
/// a file that only this user can read, and the browser opens that file. The file is removed after a minute, when the
/// browser has read it. If Ctrl+C ends the program earlier, the file stays.
fn open(url: &str) -> io::Result<()> {
    let mut file = tempfile::Builder::new().prefix("render-view-").suffix(".html").tempfile()?;
    // The address has no character with a meaning in HTML.
    write!(file, "<!doctype html><meta charset=\"utf-8\"><meta http-equiv=\"refresh\" content=\"0; url={url}\">")?;
    let mut command = Command::new("xdg-open");
    command.arg(file.path()).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    let mut opening = command.spawn()?;
    std::thread::spawn(move || match opening.wait() {
        Ok(status) if status.success() => {}
        Ok(status) => no_browser(&format!("xdg-open ended with {status}")),
        Err(error) => no_browser(&error.to_string()),
    });
    std::thread::spawn(move || {
        std::thread::sleep(Duration::from_secs(60));
        drop(file);
    });
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_is_that_of_the_checkout_or_the_one_installed_with_the_program() {
        for (program, site) in [
            ("/home/a/render/target/release/render-lab", "/home/a/render/out/site"),
            ("/home/a/render/target/x86_64-unknown-linux-musl/release/render-lab", "/home/a/render/out/site"),
            ("/usr/bin/render-lab", "/usr/share/exact-renderer/site"),
            ("/home/a/targets/bin/render-lab", "/home/a/targets/share/exact-renderer/site"),
        ] {
            assert_eq!(own_site(Path::new(program)), Some(site.into()), "{program}");
        }
        assert_eq!(own_site(Path::new("/render-lab")), None);
    }
}
