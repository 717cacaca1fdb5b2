//! Runs `shader-lab --samples`: pictures with random numbers.

use super::*;

/// The configuration of these tests, in the place of the one that [`command`] writes.
const CONFIG: &str = "image_width: 48\nmax_depth: 8\nsamples_per_pixel: 3\n";

fn sampled(folder: &Folder, arguments: &str) -> Output {
    folder.write("uniform.wgsl", standard("uniform"));
    let mut command = command(folder, &format!("uniform.wgsl {arguments} --check --samples"));
    folder.write("config.txt", CONFIG);
    command.output().expect("the program starts")
}

#[test]
fn a_picture_with_random_numbers_differs_in_no_bit_in_either_convention() {
    common::gpu();
    let folder = Folder::new();
    let mut pictures = Vec::new();
    for convention in ["statement", "published"] {
        let output = sampled(&folder, &format!("--scatter {convention}"));
        let text = words(&output);
        assert_eq!(output.status.code(), Some(0), "{text}");
        assert!(text.contains("uniform.wgsl stands in for [uniform]\n"), "{text}");
        assert!(text.contains("from the CPU in f64: 0 of 1296 pixels differ, RMSE 0.0e0"), "{text}");
        let counts = format!(
            "3 samples for each pixel, scatter convention [{convention}]; 0 of 3888 paths take another number of words\n"
        );
        assert!(text.contains(&counts), "{text}");
        pictures.push(folder.read("out.png"));
    }
    assert!(pictures[0] != pictures[1], "the conventions give different pictures");
}

#[test]
fn an_f32_picture_with_random_numbers_has_an_rmse_from_f64_and_with_the_arithmetic_of_ieee_is_its_twin() {
    let accuracy = common::accuracy(&common::gpu());
    let output = sampled(&Folder::new(), "--f32");
    let text = words(&output);
    if accuracy == Accuracy::Ieee {
        assert_eq!(output.status.code(), Some(0), "{text}");
        assert!(text.contains("from the CPU in f32: 0 of 1296 pixels differ, RMSE 0.0e0"), "{text}");
    }
    let (_, rmse) = text.split_once("from the CPU in f64: ").expect("there is a second comparison");
    let (_, rmse) = rmse.split_once("RMSE ").expect("it has an error");
    let rmse: f64 = rmse.split(',').next().expect("a number").parse().expect("it is one");
    assert!(rmse > 1e-9 && rmse < 0.05, "{text}");
}
