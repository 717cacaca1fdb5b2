//! Compares the f32 shader in a browser with lavapipe and Rust. The browser is headless Chromium, with the compiler
//! Tint and the driver SwiftShader.
//!
//! The script `web/drive.js` operates the page as a user would, and posts each result to the server of this test.
//! `tests/run --browser` installs Chromium. Without Chromium the test is shown as ignored. If the variable `SCREENSHOT`
//! has the path of a file, relative to the project's folder, the test writes a picture of the page there.

#[path = "common/documented.rs"]
mod documented;

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::net::{SocketAddr, TcpListener};
use std::path::Path;
use std::process::ExitCode;
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;

use cpu::{Config, Scene};
use gpu_check::conformance::{browser, probes, report::Run};
use gpu_check::kernels::KERNELS;
use gpu_check::scenes::repository;
use gpu_check::web::chromium::{self, Browser};
use gpu_check::web::{Posted, Server, data};
use gpu_check::{Float, Gpu, check};
use libtest_mimic::{Arguments, Failed, Trial};
use shaders::Library;
use test_support::folder::Folder;

/// Time limit for the next result of the page.
const PATIENCE: Duration = Duration::from_secs(120);

const SCENE: &str = "matte: grey .5 .5 .5\nmetal: mirror .9 .9 .9 0\nrefractive: glass 1.5\n\
    sphere: 0 -100 0 99 grey\nsphere: 0 0 0 1 glass\ncylinder: 2 0 0 .5 0 2 0 mirror\n";

fn main() -> ExitCode {
    let chromium = chromium::find();
    let required = std::env::var_os("BROWSER_REQUIRED").is_some();
    let ignored = chromium.is_none() && !required;
    if ignored {
        println!("there is no Chromium, so nothing is compared with it; tests/run --browser installs it");
    }
    let test = |name: &str, run: fn(&Path) -> Result<(), Failed>| {
        let chromium = chromium.clone();
        let run = move || run(&chromium.ok_or("there is no Chromium")?);
        Trial::test(name, run).with_ignored_flag(ignored)
    };
    let trials = vec![
        test("tint_agrees_and_the_page_renders_edits_and_reports", drive),
        test("the_verdicts_in_the_browser_are_the_documented_ones", conformance),
    ];
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}

/// Checks the verdicts on the browser's compiler and driver against the table in docs/gpu.md.
fn conformance(chromium: &Path) -> Result<(), Failed> {
    let probes = probes::all();
    let (driver, outcomes) = browser::run(chromium, &probes)?;
    println!("{driver}");
    let verdicts = Run { driver, outcomes }.verdicts(&probes);
    let failures = documented::check(&probes, &verdicts, 3);
    println!("{} probes, {failures} failures", probes.len());
    Ok(())
}

/// Starts the browser, and returns all results that the page posts until it is finished, by name.
fn results(chromium: &Path, server: Server) -> Result<BTreeMap<String, Vec<u8>>, Failed> {
    let profile = Folder::new();
    let address = server.address()?;
    let browser = Browser::open(chromium, profile.path(), &[], &format!("http://{address}/?drive"))?;
    let (sender, receiver) = mpsc::channel();
    // The thread runs until the process ends. Results after the last one are ignored.
    std::thread::spawn(move || server.serve(move |posted| drop(sender.send(posted))));
    let mut results = BTreeMap::new();
    loop {
        let posted = receiver.recv_timeout(PATIENCE);
        let posted = posted.map_err(|_| format!("the page fell silent after {:?}", results.keys()))?;
        match posted.name.as_str() {
            "failed" => return Err(String::from_utf8_lossy(&posted.body).into_owned().into()),
            "done" => break,
            _ => results.insert(posted.name, posted.body),
        };
    }
    drop(browser);
    if let Ok(picture) = std::env::var("SCREENSHOT") {
        photograph(chromium, address, &receiver, &picture)?;
    }
    Ok(results)
}

/// Starts the browser once more, and writes a picture of the finished page. The browser takes the picture when
/// everything is loaded, but the page counts as loaded before it has calculated anything. So the page is in a frame
/// beside an image, and this test sends the image only after `posted` tells that the page is finished.
fn photograph(chromium: &Path, address: SocketAddr, posted: &Receiver<Posted>, picture: &str) -> Result<(), Failed> {
    let frame = format!(
        "<!doctype html><style>body{{margin:0}}iframe{{border:0;width:100vw;height:100vh}}img{{display:none}}</style>\
         <iframe src=\"http://{address}/?drive\"></iframe><img src=\"done\">"
    );
    let listener = TcpListener::bind("127.0.0.1:0")?;
    let profile = Folder::new();
    let file = profile.file("page.png");
    let look = ["--window-size=1010,620", "--hide-scrollbars"].map(str::to_owned);
    let options = [&look[..], &[format!("--screenshot={}", file.display())]].concat();
    let mut browser =
        Browser::open(chromium, profile.path(), &options, &format!("http://{}/", listener.local_addr()?))?;
    loop {
        let (mut stream, _) = listener.accept()?;
        let mut request = String::new();
        BufReader::new(&stream).read_line(&mut request)?;
        let is_image = request.starts_with("GET /done");
        while is_image && posted.recv_timeout(PATIENCE)?.name != "done" {}
        let body = if is_image { "" } else { &frame };
        let head = "HTTP/1.1 200 OK\r\nContent-Type: text/html\r\nConnection: close\r\nContent-Length:";
        write!(stream, "{head} {}\r\n\r\n{body}", body.len())?;
        if is_image {
            break;
        }
    }
    browser.0.wait()?;
    std::fs::copy(file, repository(picture))?;
    Ok(())
}

fn drive(chromium: &Path) -> Result<(), Failed> {
    let gpu = Gpu::open()?;
    println!("native: {gpu}");
    let (config, scene) = match std::env::var_os("SCREENSHOT") {
        None => (Config { image_width: 64, ..Config::default() }, Scene::parse(SCENE.as_bytes())?),
        // A picture was asked for, so this is a scene that is worth looking at.
        Some(_) => {
            let config = Config::read(&repository("scenes/materials/config.txt"))?;
            (Config { image_width: 300, ..config }, Scene::read(&repository("scenes/materials/scene.txt"))?)
        }
    };
    let data = data::collect(&gpu, &config, &scene)?;
    let native = floats(&data["native"])?;
    let results = results(chromium, Server::new(0, data)?)?;
    println!("browser: {}", String::from_utf8_lossy(&results["adapter"]));
    formulas(&gpu, &results)?;
    page(&native, &results)
}

fn floats(bytes: &[u8]) -> Result<Vec<f32>, Failed> {
    if bytes.is_empty() || !bytes.len().is_multiple_of(4) {
        return Err(format!("{} bytes are no row of numbers", bytes.len()).into());
    }
    Ok(bytemuck::pod_collect_to_vec(bytes))
}

/// Checks the results of every kernel compiled by Tint. Each row must be equal to Rust's f32 and to lavapipe, or to f32
/// without subnormal numbers, which WGSL allows.
fn formulas(gpu: &Gpu, results: &BTreeMap<String, Vec<u8>>) -> Result<(), Failed> {
    let (mut compared, mut flushed) = (0, 0);
    let mut faults = Vec::new();
    for kernel in &KERNELS {
        let cases = data::cases(kernel);
        let by_tint = floats(results.get(kernel.module).ok_or_else(|| format!("{} is missing", kernel.module))?)?;
        let pipeline = check::compile::<f32>(gpu, &Library::standard(), kernel)?;
        let native = check::results::<f32>(gpu, &pipeline, kernel, &cases)?;
        let expected = data::expected(kernel, &cases);
        if (by_tint.len(), native.len()) != (expected.len(), expected.len()) {
            return Err(format!("{}: {} and {} numbers", kernel.module, by_tint.len(), native.len()).into());
        }
        let outputs = kernel.outputs.len();
        let rows = by_tint.chunks(outputs).zip(native.chunks(outputs).zip(expected.chunks(outputs)));
        let (mut without_subnormals, mut neither) = (0, Vec::new());
        for (case, (by_tint, (native, expected))) in cases.chunks(kernel.inputs).zip(rows) {
            let same = |row: &[f32]| by_tint.iter().zip(row).all(|(tint, number)| tint.same(*number));
            if same(native) && same(expected) {
                continue;
            }
            let flushed = kernel.flushed(case);
            if same(&flushed) {
                without_subnormals += 1;
            } else {
                neither.push(format!("{case:?}\n  by Tint {by_tint:?}\n  f32 {expected:?}\n  flushed {flushed:?}"));
            }
        }
        println!(
            "{}: {} numbers in {} cases; {without_subnormals} cases as in f32 without subnormal numbers, {} otherwise",
            kernel.module,
            by_tint.len(),
            by_tint.len() / outputs,
            neither.len()
        );
        if !neither.is_empty() {
            let shown = neither[..neither.len().min(3)].join("\n");
            faults.push(format!("{}: {} cases, as {shown}", kernel.module, neither.len()));
        }
        compared += by_tint.len();
        flushed += without_subnormals;
    }
    println!("{compared} numbers by Tint compared with Rust's f32 and the native driver's; {flushed} cases flushed");
    if compared < 1_000_000 {
        return Err(format!("{compared} numbers are too few").into());
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n").into()) }
}

/// Checks three things of the page: its picture has the bits of the native picture, an edit changes the picture, and an
/// error leaves the last good picture.
fn page(native: &[f32], results: &BTreeMap<String, Vec<u8>>) -> Result<(), Failed> {
    let differing = |name: &str| -> Result<usize, Failed> {
        let here = floats(&results[name])?;
        assert_eq!(here.len(), native.len(), "{name} is a whole picture");
        Ok(here.iter().zip(native).filter(|(here, native)| !here.same(**native)).count())
    };
    let (first, edited, healed) = (differing("picture")?, differing("edited")?, differing("healed")?);
    println!("picture: {first} of {} numbers differ; {edited} after an edit", native.len());
    assert_eq!((first, healed), (0, 0), "the browser's picture is the native one");
    assert!(edited > native.len() / 10, "an edited background changes the picture: {edited}");
    assert!(results["shown"].chunks(4).any(|pixel| pixel[..3] != [0; 3]), "the canvas shows something");
    let error = String::from_utf8_lossy(&results["error"]);
    println!("{error}");
    // The columns of the page's table: formula, number of cases, of those equal to f32, of those equal to flushed f32,
    // and of all others.
    let table = String::from_utf8_lossy(&results["table"]);
    let rows: Vec<Vec<String>> = table
        .trim_matches(['[', ']', '"'])
        .split("\"],[\"")
        .map(|row| row.split("\",\"").map(str::to_owned).collect())
        .collect();
    assert_eq!(rows.len(), KERNELS.len(), "{table}");
    for row in &rows {
        println!("page: {row:?}");
        let numbers: Vec<usize> = row[1..].iter().map(|text| text.parse().expect("a count")).collect();
        assert_eq!((numbers[0], numbers[3]), (numbers[1] + numbers[2], 0), "{row:?}");
    }
    let width = String::from_utf8_lossy(&results["width"]);
    let (needed, shown) = width.split_once(' ').ok_or("two widths are posted")?;
    println!("the page is {needed} pixels wide in a window of {shown}");
    assert!(needed.parse::<u32>()? <= shown.parse::<u32>()?, "a phone shows all of its width");
    assert!(shown.parse::<u32>()? <= 390, "the window is as narrow as a phone");
    let icon = String::from_utf8_lossy(&results["icon"]);
    println!("the icon is {icon} pixels wide");
    assert!(icon.parse::<u32>()? > 0, "the page has an icon");
    assert!(error.starts_with("shaders/wgsl/background.wgsl:11:") && error.ends_with('^'), "{error}");
    assert!(error.contains("direktion") && results["kept"] == b"true", "the last good picture stays beside the error");
    Ok(())
}
