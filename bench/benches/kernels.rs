//! Measures the time of each kernel, and of one unit of its work: `cargo bench -p bench --bench kernels [NAME]`.

use std::time::{Duration, Instant};

use bench::kernels;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

fn all(criterion: &mut Criterion) {
    let _ = bench::instruction_set();
    let mut group = criterion.benchmark_group("kernel");
    for kernel in kernels::all() {
        let mut work = (kernel.new)();
        group.throughput(Throughput::Elements(work.units()));
        group.bench_function(kernel.name, |bencher| {
            bencher.iter_custom(|turns| {
                let mut total = Duration::ZERO;
                for _ in 0..turns {
                    work.prepare();
                    let start = Instant::now();
                    work.turn();
                    total += start.elapsed();
                }
                total
            });
        });
    }
    group.finish();
}

criterion_group! {
    name = kernels_of_the_renderer;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(800));
    targets = all
}
criterion_main!(kernels_of_the_renderer);
