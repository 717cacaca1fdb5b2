//! The scenes whose pictures tell the deviations apart. Each shows a stage of the statement that those before it do not
//! need, so a deviation of an early stage is found without the others.

use cpu::{Config, Error, Scene};

/// A scene with its configuration.
#[derive(Clone, Debug)]
pub struct Case {
    /// What it shows.
    pub name: &'static str,
    /// The texts of configuration and scene.
    pub files: [&'static str; 2],
    /// The configuration.
    pub config: Config,
    /// The scene.
    pub scene: Scene,
}

/// Returns the cases, in the order of the stages. In the text of all cases a line `= NAME` begins a case, and a line
/// `-` its scene.
///
/// # Errors
/// An error of a text, which is damaged then.
pub fn cases() -> Result<Vec<Case>, Error> {
    let case = |text: &'static str| {
        let (name, files) = text.split_once('\n').unwrap_or_default();
        let (config, scene) = files.split_once("-\n").unwrap_or_default();
        let [of_config, of_scene] = [config, scene].map(str::as_bytes);
        Ok(Case { name, files: [config, scene], config: Config::parse(of_config)?, scene: Scene::parse(of_scene)? })
    };
    include_str!("cases.txt").split("= ").skip(1).map(case).collect()
}
