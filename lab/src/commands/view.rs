//! `render-lab view`: serves the page of `web/site` on this machine, with the native renderer behind it.

use std::io::{self, Write as _};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Duration;

use clap::Args;
use loopback::Server;
use output::Options;

use crate::view::{Input, PRIVATE, Site, View};
use crate::{Failure, sources, terminal};

/// Options of `view`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/view.txt").trim_ascii_end())]
pub struct Arguments {
    /// Configuration file
    config: PathBuf,
    /// Scene file
    scene: PathBuf,
    /// Folder of the page [default: out/site, which web/build makes, or else the page installed with this program]
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
    /// Serves the page until the process is stopped. Prints the page's address. `how` tells how the configuration is
    /// written.
    ///
    /// # Errors
    /// An error of the two files or of the page's folder, or a port that is in use.
    pub fn run(&self, how: Options) -> Result<(), Failure> {
        let inputs = [Input::new(&self.config)?, Input::new(&self.scene)?];
        // The files are read once before the page exists, so that their errors are shown with their places.
        sources::config(&self.config, &[])?.check_picture().map_err(|error| error.in_file(&self.config))?;
        sources::scene(&self.scene)?;
        let site = Site::read(&self.site.clone().unwrap_or_else(default_site))?;
        let server = Server::new(self.port).map_err(|error| {
            format!("cannot listen at 127.0.0.1:{}: {error}; choose another port with --port", self.port)
        })?;
        let server = server.with_secret(PRIVATE).map_err(|error| format!("no secret for the page: {error}"))?;
        let url = server.url()?;
        terminal::print(&url)?;
        if self.open {
            open(&url).unwrap_or_else(|error| {
                terminal::note(&format!("cannot open the browser: {error}; open the address yourself"));
            });
        }
        let view = View::new(site, inputs, server.budget(), how);
        // The result is an error or never comes.
        server.serve(move |request, client| view.answer(&request, client)).map(|_| ()).map_err(Failure::from)
    }
}

/// Returns the folder of the page that was built here, or else of the one in the archive of this program.
fn default_site() -> PathBuf {
    let built = PathBuf::from("out/site");
    let own = std::env::current_exe().ok();
    let installed = own.and_then(|own| Some(own.parent()?.parent()?.join("share/exact-renderer/site")));
    installed.filter(|folder| !built.is_dir() && folder.is_dir()).unwrap_or(built)
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
    command.spawn()?;
    std::thread::spawn(move || {
        std::thread::sleep(Duration::from_secs(60));
        drop(file);
    });
    Ok(())
}
