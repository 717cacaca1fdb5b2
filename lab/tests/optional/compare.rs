//! Tests the page of `render-lab compare` in Chromium, if that is there.

use std::path::Path;
use std::process::Command;

use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::trial;

/// What a user does with the page. The title then has the place and the scale of the picture after each step.
/// The steps begin when the page has placed the picture, however busy the machine is.
const STEPS: &str = "<script>
const waiting = setInterval(() => {
    const [frame, stage] = ['frame', 'stage'].map((id) => document.getElementById(id));
    if (stage.style.transform === '') return;
    clearInterval(waiting);
    const told = [stage.style.transform];
    const send = (event) => { frame.dispatchEvent(event); told.push(stage.style.transform); };
    send(new WheelEvent('wheel', { clientX: 100, clientY: 100, deltaY: -100, cancelable: true }));
    send(new PointerEvent('pointermove', { buttons: 1, movementX: 20, movementY: 10 }));
    document.getElementById('original').click();
    told.push(stage.style.transform);
    document.title = told.join('; ');
}, 20);
</script>";

/// Returns the test.
pub fn trials() -> Vec<Trial> {
    let chromium = super::site::chromium();
    let missing = (!chromium.is_file()).then_some("needs chromium");
    let name = "compare::the_page_fits_zooms_and_moves_two_named_pictures_and_marks_the_bound_that_failed";
    vec![trial(name, missing, move || page_works(&chromium))]
}

/// Returns the scale of the picture, and the place of its corner.
fn view(told: &str) -> Option<[f64; 3]> {
    let numbers = told.split(|c: char| !c.is_ascii_digit() && c != '.' && c != '-');
    let numbers: Vec<f64> = numbers.filter_map(|number| number.parse().ok()).collect();
    numbers.try_into().ok().map(|[x, y, scale]: [f64; 3]| [scale, x, y])
}

fn page_works(chromium: &Path) -> Result<(), Failed> {
    let folder = Folder::new();
    for (side, level) in [("2", "0"), ("100", "0"), ("2", "255"), ("100", "255")] {
        let pixels = format!("{level} {level} {level} ").repeat(side.parse::<usize>()?.pow(2));
        folder.write(&format!("{level}-{side}.ppm"), format!("P3 {side} {side} 255 {pixels}\n"));
    }
    for side in ["2", "100"] {
        let names = ["0", "255"].map(|level| folder.name(&format!("{level}-{side}.ppm")));
        let page = folder.name("page.html");
        let mut compare = Command::new(env!("CARGO_BIN_EXE_render-lab"));
        let status = compare.arg("compare").args(&names).args(["--accept-rmse", "300", "--html", &page]).status()?;
        assert_eq!(status.code(), Some(1), "the largest difference is not accepted");
        let text = String::from_utf8(folder.read("page.html"))?;
        let result = text.split_once("<pre>").map(|(_, result)| result.to_owned()).unwrap_or_default();
        assert!(result.starts_with("<mark>maximum ") && result.matches("<mark>").count() == 1, "{result}");
        assert!(!result.contains("--"), "an option is no part of a result: {result}");
        folder.write("page.html", text + STEPS);
        let mut browser = Command::new(chromium);
        browser.args(["--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=60000", "--dump-dom"]);
        let output = browser.arg(format!("file://{page}")).output()?;
        let shown = String::from_utf8_lossy(&output.stdout).into_owned();
        for (id, name) in ["one", "two"].iter().zip(&names) {
            assert!(shown.contains(&format!("id=\"{id}\">{name}</span>")), "{shown}");
        }
        let title =
            shown.split_once("<title>").and_then(|(_, rest)| rest.split_once("</title>")).map(|(title, _)| title);
        let steps: Vec<_> = title.unwrap_or_default().split("; ").filter_map(view).collect();
        let [fits, zoomed, moved, original] = steps[..] else { return Err(format!("{title:?}").into()) };
        assert!(fits[0] > 1.0 && fits[1].min(fits[2]).abs() < 1.0, "it fills the frame: {steps:?}");
        // The largest scale of a picture is 64, unless the frame is larger.
        assert!(if fits[0] < 50.0 { zoomed[0] > 1.2 * fits[0] } else { zoomed[0] >= fits[0] }, "{steps:?}");
        let drag = [zoomed[0], zoomed[1] + 20.0, zoomed[2] + 10.0];
        assert!(moved.iter().zip(drag).all(|(found, wanted)| (found - wanted).abs() < 0.01), "{steps:?}");
        assert!((original[0] - 1.0).abs() < 1e-9, "{steps:?}");
    }
    Ok(())
}
