//! What a rendering took: time, memory and rays.

use serde::Serialize;

/// The time, the memory and the rays of one rendering.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Taken {
    pub width: usize,
    pub height: usize,
    /// `None` for a quantity that needs no samples.
    pub samples_per_pixel: Option<u64>,
    /// Number of camera rays in the rows that were rendered.
    pub primary_rays: u64,
    /// Elapsed time in seconds, including the time to write the file.
    pub seconds: f64,
    pub user_seconds: f64,
    /// `None` without such rays.
    pub nanoseconds_per_primary_ray: Option<f64>,
    pub peak_memory_bytes: u64,
    /// Number of all rays; `None` without `--count`.
    pub rays: Option<u64>,
    pub hits: Option<u64>,
    /// `None` if not all rays of the picture were traced in these seconds.
    pub nanoseconds_per_ray: Option<f64>,
}

/// The least nanoseconds that are shown; with one decimal, less would be 0.0.
const SHOWN: f64 = 0.05;

impl std::fmt::Display for Taken {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (seconds, memory) = (self.user_seconds, self.peak_memory_bytes as f64 / 1e6);
        write!(out, "{} x {} pixels", self.width, self.height)?;
        self.samples_per_pixel.map_or(Ok(()), |samples| write!(out, ", {samples} samples each"))?;
        write!(out, ": {:.3} s, {seconds:.3} s of user time, ", self.seconds)?;
        // The system's clock of user time may be too coarse for a tiny picture, and then counts nothing.
        let time = self.nanoseconds_per_primary_ray.filter(|&time| time >= SHOWN);
        time.map_or(Ok(()), |time| write!(out, "{time:.1} ns a primary ray, "))?;
        write!(out, "peak memory {memory:.1} MB")?;
        if let (Some(rays), Some(hits)) = (self.rays, self.hits) {
            write!(out, "; {rays} rays, {hits} hits")?;
        }
        let time = self.nanoseconds_per_ray.filter(|&time| time >= SHOWN);
        time.map_or(Ok(()), |time| write!(out, ", {time:.1} ns a ray"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_that_was_not_counted_is_not_shown() {
        let taken = |nanoseconds| Taken {
            nanoseconds_per_primary_ray: Some(nanoseconds),
            nanoseconds_per_ray: Some(nanoseconds),
            ..Taken::default()
        };
        let [none, some] = [0.0, 2.0].map(|nanoseconds| taken(nanoseconds).to_string());
        assert!(!none.contains(" ns "), "{none}");
        assert!(some.contains("2.0 ns a primary ray") && some.ends_with("2.0 ns a ray"), "{some}");
    }
}
