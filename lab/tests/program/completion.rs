//! The script of `render-lab completions` for bash, run by bash.

use test_support::folder::Folder;

use crate::bash;

#[test]
fn bash_completes_commands_options_and_values_at_every_level() {
    let complete = |words: &[&str]| {
        let (last, before) = (words[words.len() - 1], words[words.len() - 2]);
        let line = format!(
            "source <($lab completions bash); IFS=$' \\t\\n'; COMP_WORDS=({}); COMP_CWORD={}; \
             _render__lab render-lab '{last}' '{before}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"",
            words.join(" "),
            words.len() - 1
        );
        let output = bash(&Folder::new(), &line);
        assert!(output.status.success(), "{output:?}");
        String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(complete(&["render-lab", "rend"]), ["render"]);
    assert_eq!(complete(&["render-lab", "render", "--sc"]), ["--scatter"]);
    assert_eq!(complete(&["render-lab", "render", "--layout", "s"]), ["soa"]);
    assert_eq!(complete(&["render-lab", "render", "--set", "samples"]), ["samples_per_pixel="]);
    assert_eq!(complete(&["render-lab", "bench", "sc"]), ["scale"]);
    assert_eq!(complete(&["render-lab", "bench", "scale", "--rep"]), ["--repeats"]);
    let topics = complete(&["render-lab", "help", "''"]);
    assert!(["render", "config", "scene"].iter().all(|topic| topics.iter().any(|own| own == topic)), "{topics:?}");
    assert_eq!(complete(&["render-lab", "help", "con"]), ["config", "convert"]);
}
