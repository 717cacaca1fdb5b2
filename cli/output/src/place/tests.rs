//! Tests of what happens if another user changes the links of an output while they are followed.

use super::*;

#[test]
fn only_a_missing_file_counts_as_removed() {
    let folder = std::env::temp_dir().join(format!("render-place-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("the temporary folder is writable");
    let [file, link, endless, missing] = ["file", "link", "endless", "missing"].map(|name| folder.join(name));
    fs::write(&file, "").expect("the folder is writable");
    std::os::unix::fs::symlink("file", &link).expect("links are allowed");
    std::os::unix::fs::symlink("endless", &endless).expect("links are allowed");
    let found = [
        has_name(&link, &file).ok(),
        has_name(&link, &missing).ok(),
        has_name(&missing, &file).ok(),
        // The system refuses to follow this link, as it refuses a forbidden one.
        has_name(&endless, &file).ok(),
    ];
    fs::remove_dir_all(&folder).expect("it is ours");
    assert_eq!(found, [Some(true), Some(false), Some(true), None]);
}
