//! The features that a scene needs, as values of the pipeline-overridable constants in `features.wgsl`.

/// The features with which a pipeline is compiled. A feature that is off costs no time. A feature that is on but not
/// needed costs a comparison that is always false.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Features {
    /// Whether any object is a sphere.
    pub has_spheres: bool,
    /// Whether any object is a cylinder.
    pub has_cylinders: bool,
    /// Whether any object has a matte material.
    pub has_matte: bool,
    /// Whether any object has a metal material.
    pub has_metal: bool,
    /// Whether any object has a refractive material.
    pub has_refraction: bool,
    /// The maximum depth: the number of rays that a sample may send, the camera ray included. If the last of them
    /// hits an object, the sample is black.
    pub max_depth: u32,
}

impl Features {
    /// Returns all features switched on, for a pipeline that can render any scene.
    #[must_use]
    pub const fn all(max_depth: u32) -> Self {
        Self {
            has_spheres: true,
            has_cylinders: true,
            has_matte: true,
            has_metal: true,
            has_refraction: true,
            max_depth,
        }
    }

    /// Returns the name and the value of every constant, in the form that wgpu and naga need. A true value is 1.
    #[must_use]
    pub fn constants(&self) -> [(&'static str, f64); 6] {
        let number = |on: bool| if on { 1.0 } else { 0.0 };
        [
            ("has_spheres", number(self.has_spheres)),
            ("has_cylinders", number(self.has_cylinders)),
            ("has_matte", number(self.has_matte)),
            ("has_metal", number(self.has_metal)),
            ("has_refraction", number(self.has_refraction)),
            ("max_depth", f64::from(self.max_depth)),
        ]
    }
}
