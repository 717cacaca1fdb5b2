//! Runs probes in a browser. The page `web/conformance.html` runs the same programs and inputs as [`super::native`].

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

use output::stop;
use serde_json::json;

use super::probe::Probe;
use super::report::Driver;
use super::verdict::Outcome;
use crate::web::chromium::{Browser, version};
use crate::web::{Posted, Server};

/// Time limit for the next result of the page.
const PATIENCE: Duration = Duration::from_secs(120);

/// Time between two looks at whether the user has interrupted the program.
const INTERVAL: Duration = Duration::from_millis(100);

/// Returns the data that the page loads. Probes that need f64 are left out, because no browser has it.
#[must_use]
pub fn data(probes: &[Probe]) -> BTreeMap<String, Vec<u8>> {
    let for_page = || probes.iter().filter(|probe| !probe.needs_f64());
    let facts = |probe: &Probe| {
        json!({
            "name": probe.name, "text": probe.text(), "cases": probe.cases.len(), "size": probe.output_size(),
        })
    };
    let list: Vec<_> = for_page().map(facts).collect();
    let mut data = BTreeMap::from([("probes".to_owned(), json!(list).to_string().into_bytes())]);
    data.extend(for_page().map(|probe| (format!("input/{}", probe.name), probe.input_bytes())));
    data
}

/// Runs the probes in a headless browser. Returns its description, and the outcome of each probe.
///
/// # Errors
/// A message for the user: the browser does not start, has no WebGPU, or stops answering.
pub fn run(chromium: &Path, probes: &[Probe]) -> Result<(Driver, Vec<Outcome>), String> {
    let broken = |error: std::io::Error| format!("{}: {error}", chromium.display());
    let version = version(chromium).map_err(broken)?;
    let server = Server::new(0, data(probes)).map_err(broken)?;
    let url = format!("http://{}/conformance", server.address().map_err(broken)?);
    let profile = tempfile::tempdir().map_err(broken)?;
    let (sender, receiver) = mpsc::channel();
    // The thread runs until the process ends. Results after the last one are ignored.
    std::thread::spawn(move || server.serve(move |posted| drop(sender.send(posted))));
    let browser = Browser::open(chromium, profile.path(), &url).map_err(broken)?;
    let results = collect(&receiver, PATIENCE);
    drop(browser);
    let results = results?;
    let adapter = results.get("adapter").map(|text| String::from_utf8_lossy(text).into_owned()).unwrap_or_default();
    let name = adapter.lines().next().unwrap_or_default().to_owned();
    let driver = Driver { adapter: name, driver: "WebGPU of the browser".to_owned(), compiler: version };
    Ok((driver, probes.iter().map(|probe| outcome(probe, &results)).collect()))
}

/// Receives the results of the page by name, until the page is done.
///
/// # Errors
/// A message for the user: the page failed, no result came within `patience`, or the user interrupted the program.
pub fn collect(receiver: &Receiver<Posted>, patience: Duration) -> Result<BTreeMap<String, Vec<u8>>, String> {
    let mut results = BTreeMap::new();
    let mut latest = Instant::now();
    loop {
        match receiver.recv_timeout(INTERVAL) {
            Ok(Posted { name, .. }) if name == "done" => return Ok(results),
            Ok(Posted { name, body }) if name == "failed" => {
                return Err(format!("the page failed: {}", String::from_utf8_lossy(&body)));
            }
            Ok(Posted { name, body }) => {
                latest = Instant::now();
                results.insert(name, body);
            }
            Err(RecvTimeoutError::Timeout) if stop::requested() => return Err("interrupted".to_owned()),
            Err(RecvTimeoutError::Timeout) if latest.elapsed() < patience => {}
            Err(_) => return Err(format!("the browser stopped answering after {} results", results.len())),
        }
    }
}

/// Returns what the page posted about a probe.
fn outcome(probe: &Probe, results: &BTreeMap<String, Vec<u8>>) -> Outcome {
    if probe.needs_f64() {
        return Outcome::NotAvailable("f64");
    }
    let posted = |kind: &str| results.get(&format!("{kind}/{}", probe.name));
    match (posted("result"), posted("refused")) {
        (Some(bytes), _) => Outcome::Results(probe.output.of_bytes(bytes)),
        (None, Some(message)) => Outcome::Refused(String::from_utf8_lossy(message).into_owned()),
        (None, None) => Outcome::Unwritten(probe.cases.len()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conformance::probes;

    #[test]
    fn the_page_gets_every_probe_without_f64_with_its_inputs() {
        let probes = probes::all();
        let data = data(&probes);
        let list: Vec<serde_json::Value> = serde_json::from_slice(&data["probes"]).expect("it is JSON");
        assert_eq!(list.len(), probes.iter().filter(|probe| !probe.needs_f64()).count());
        for entry in &list {
            let name = entry["name"].as_str().expect("it is text");
            let probe = probes.iter().find(|probe| probe.name == name).expect("it is in the list");
            assert_eq!(data[&format!("input/{name}")], probe.input_bytes());
            assert_eq!(entry["text"], probe.text());
        }
    }

    #[test]
    fn a_page_that_fails_or_falls_silent_is_an_error() {
        let (sender, receiver) = mpsc::channel();
        let post = |name: &str, body: &str| {
            let posted = Posted { name: name.to_owned(), body: body.into() };
            sender.send(posted).expect("the receiver exists");
        };
        post("result/fma", "1234");
        post("done", "");
        assert_eq!(collect(&receiver, PATIENCE).map(|results| results.len()), Ok(1));
        post("failed", "no adapter");
        assert_eq!(collect(&receiver, PATIENCE), Err("the page failed: no adapter".to_owned()));
        let message = collect(&receiver, Duration::ZERO).expect_err("nothing is posted");
        assert_eq!(message, "the browser stopped answering after 0 results");
    }
}
