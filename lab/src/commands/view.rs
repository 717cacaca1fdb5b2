//! `render-lab view`: serves the page of `web/site` on this machine, with the native renderer behind it.

use std::path::PathBuf;
use std::process::{Command, Stdio};

use clap::Args;
use loopback::Server;
use output::Options;

use crate::view::{Site, View};
use crate::{Failure, sources, terminal};

/// Options of `view`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  web/build
  render-lab view scenes/materials/config.txt scenes/materials/scene.txt --open
  render-lab view config.txt scene.txt --port 9000 --site /srv/page

The page shows the two files, and loads them again when they change. It writes only a camera into the configuration,
when you press its button. Only this machine can reach it. Ctrl+C ends it.")]
pub struct Arguments {
    /// Configuration file
    config: PathBuf,
    /// Scene file
    scene: PathBuf,
    /// Folder of the page, which web/build makes
    #[arg(long, value_name = "FOLDER", default_value = "out/site")]
    site: PathBuf,
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
        // The files are read once before the page exists, so that their errors are shown with their places.
        sources::config(&self.config, &[])?.check_picture().map_err(|error| error.in_file(&self.config))?;
        sources::scene(&self.scene)?;
        let site = Site::read(&self.site)?;
        let server = Server::new(self.port).map_err(|error| {
            format!("cannot listen at 127.0.0.1:{}: {error}; choose another port with --port", self.port)
        })?;
        let address = format!("http://{}/", server.address()?);
        terminal::print(&address)?;
        if self.open {
            open(&address);
        }
        let view = View::new(site, self.config.clone(), self.scene.clone(), how);
        // The result is an error or never comes.
        server.serve(move |request| view.answer(&request)).map(|_| ()).map_err(Failure::from)
    }
}

/// Opens the page in the user's browser.
fn open(address: &str) {
    let mut command = Command::new("xdg-open");
    command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    if let Err(error) = command.spawn() {
        terminal::note(&format!("cannot run xdg-open: {error}; open {address} in a browser"));
    }
}
