//! Runs probes in a browser. The page `web/conformance.html` runs the same programs and inputs as [`super::native`].

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

use output::stop;
use serde_json::json;

use super::outcome::Outcome;
use super::probe::Probe;
use super::report::Run;
use crate::web::chromium::{Browser, INTERVAL, version};
use crate::web::{Posted, Server};

/// Time limit for the next result of the page.
const PATIENCE: Duration = Duration::from_secs(120);

/// Time limit for the browser to print its version.
const VERSION_PATIENCE: Duration = Duration::from_secs(30);

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

/// Runs the probes in a headless browser.
///
/// # Errors
/// A message for the user: the browser does not start, has no WebGPU, or stops answering.
pub fn run(chromium: &Path, probes: &[Probe]) -> Result<Run, String> {
    let broken = |error: std::io::Error| format!("{}: {error}", chromium.display());
    let version = version(chromium, VERSION_PATIENCE).map_err(broken)?;
    let server = Server::new(0, data(probes)).map_err(broken)?;
    let url = format!("http://{}/conformance", server.address().map_err(broken)?);
    let profile = tempfile::tempdir().map_err(broken)?;
    let (sender, receiver) = mpsc::channel();
    // The thread runs until the process ends. Results after the last one are ignored.
    std::thread::spawn(move || server.serve(move |posted| drop(sender.send(posted))));
    let mut browser = Browser::open(chromium, profile.path(), &url).map_err(broken)?;
    let results = collect(&receiver, &mut browser, PATIENCE);
    drop(browser);
    let results = results?;
    let adapter = results.get("adapter").map(|text| String::from_utf8_lossy(text).into_owned()).unwrap_or_default();
    let name = adapter.lines().next().unwrap_or_default();
    let driver = format!("{name}; WebGPU of the browser; {version}");
    Ok(Run { driver, outcomes: probes.iter().map(|probe| outcome(probe, &results)).collect() })
}

/// Receives the results of the page by name, until the page is done.
///
/// # Errors
/// A message for the user: the page failed, the browser ended, no result came within `patience`, or the user
/// interrupted the program.
pub fn collect(
    receiver: &Receiver<Posted>,
    browser: &mut Browser,
    patience: Duration,
) -> Result<BTreeMap<String, Vec<u8>>, String> {
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
            Err(error) => {
                let count = results.len();
                let ended = browser.ended().map_err(|error| format!("the browser: {error}"))?;
                let what = match ended {
                    Some(status) => format!("ended by {status}"),
                    None if error == RecvTimeoutError::Disconnected || latest.elapsed() >= patience => {
                        "stopped answering, so it was ended".to_owned()
                    }
                    None => continue,
                };
                return Err(format!(
                    "after {count} results the browser {what}; start it by hand to see why, or name another in CHROMIUM"
                ));
            }
        }
    }
}

/// Returns what the page posted about a probe.
fn outcome(probe: &Probe, results: &BTreeMap<String, Vec<u8>>) -> Outcome {
    if probe.needs_f64() {
        return Outcome::NotAvailable;
    }
    let posted = |kind: &str| results.get(&format!("{kind}/{}", probe.name));
    let text = |kind| posted(kind).map(|message| String::from_utf8_lossy(message).into_owned());
    posted("result")
        .map(|bytes| Outcome::Results(probe.output.of_bytes(bytes)))
        .or_else(|| text("refused").map(Outcome::Refused))
        .or_else(|| text("ended").map(Outcome::Ended))
        .unwrap_or(Outcome::Unwritten(probe.cases.len()))
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

    #[cfg(unix)]
    #[test]
    fn a_page_that_fails_or_falls_silent_and_a_browser_that_ends_are_errors() {
        use std::process::Command;
        let start = |arguments: &[&str]| Browser::start(Command::new("sh").arg("-c").args(arguments));
        let mut browser = start(&["sleep 1000"]).expect("every Unix has a shell");
        let (sender, receiver) = mpsc::channel();
        let post = |name: &str, body: &str| {
            let posted = Posted { name: name.to_owned(), body: body.into() };
            sender.send(posted).expect("the receiver exists");
        };
        post("result/fma", "1234");
        post("done", "");
        assert_eq!(collect(&receiver, &mut browser, PATIENCE).map(|results| results.len()), Ok(1));
        post("failed", "no adapter");
        assert_eq!(collect(&receiver, &mut browser, PATIENCE), Err("the page failed: no adapter".to_owned()));
        let message = collect(&receiver, &mut browser, Duration::ZERO).expect_err("nothing is posted");
        assert!(message.starts_with("after 0 results the browser stopped answering, so it was ended; "), "{message}");
        let mut browser = start(&["exit 3"]).expect("every Unix has a shell");
        // The sender is still there, so that only the end of the browser can end the wait before an hour is over.
        let message = collect(&receiver, &mut browser, Duration::from_secs(3600)).expect_err("nothing is posted");
        assert!(message.starts_with("after 0 results the browser ended by exit status: 3; start it "), "{message}");
    }
}
