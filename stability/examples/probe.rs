//! probe
use cpu::{Aos, Config, Layout, Scatter, Scene};
use std::path::Path;
fn main() {
    let dir = std::env::args().nth(1).unwrap();
    for case in std::env::args().skip(2) {
        let config = Config::read(Path::new(&format!("{dir}/config{case}.txt"))).unwrap();
        let scene = Scene::read(Path::new(&format!("{dir}/scene{case}.txt"))).unwrap();
        let mut c = config.clone();
        if std::env::var("FULL").is_err() { c.samples_per_pixel = c.samples_per_pixel.min(4); c.image_width /= 2; }
        let image: <Aos as Layout>::Image = cpu::reference::render_with::<_, stability::observed::Observed>(&c, &scene, Scatter::Statement).unwrap();
        drop(image);
        for (k, n) in ["sphere","cylinder"].iter().zip(stability::observed::take_counts()) {
            println!("case {case} {k}: tests {} doubt {:.5}% of hits {:.4}% hits {} same {:.4}% other {}", n.tests, 100.*n.doubtful as f64/n.tests as f64, 100.*n.doubtful as f64/n.hits as f64, n.hits, 100.0*n.same_bits as f64/n.hits as f64, n.other_decision);
        }
    }
}
