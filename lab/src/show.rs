//! Computes quantities of each pixel other than its colour: what the ray through its middle hits, and what its samples
//! cost.

mod draw;

use std::cell::Cell;
use std::ops::ControlFlow;

use clap::ValueEnum;
use cpu::internals::accel::closest_hit::ClosestHit;
use cpu::internals::accel::object::{NO_OBJECT, ObjectId, ObjectRef, file_index_of};
use cpu::internals::accel::stack::Stack;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::ray::front_and_normal;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::layout::{Objects, Placed};
use cpu::internals::math::vec3::Vec3;
use cpu::internals::render::surface_hit::SurfaceHit;
use cpu::internals::sampling::scatter_stream::ScatterSamples;
use cpu::internals::sampling::uniform::Uniform;
use cpu::internals::simd::portable::Portable;
use cpu::internals::{InstructionSet, Prepared};
use cpu::{Error, Layout, Ray, Scatter, Scene};

use crate::picture::floats::Floats;

/// A quantity of each pixel. What the ray through the middle hits is not a number (NaN) where it hits no object. The
/// variance of one sample is NaN too.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Quantity {
    /// Distance from the camera to what the ray through the middle hits, in scene units
    Depth,
    /// Distance to the same hit in lengths of the ray's direction, as the renderer compares it
    Lambda,
    /// Normal of the surface, of length one, on the camera's side
    Normal,
    /// Index of the object in the scene file, from 0
    Object,
    /// Index of the material in the scene file, from 0
    Material,
    /// Part of the object: 0 sphere, 1 side, 2 top, 3 bottom of a cylinder
    Part,
    /// Number of samples
    Samples,
    /// Variance of the linear colours of the samples, for each channel
    Variance,
    /// Rays, hits, and objects with which rays are intersected, of all samples together
    Cost,
}

impl Quantity {
    /// Returns the number of channels of the quantity.
    const fn channels(self) -> usize {
        if matches!(self, Self::Normal | Self::Variance | Self::Cost) { 3 } else { 1 }
    }

    /// Returns whether the samples of each pixel are traced for the quantity.
    pub const fn takes_samples(self) -> bool {
        matches!(self, Self::Variance | Self::Cost)
    }

    /// Returns the number of camera rays of each pixel that are traced for the quantity of a picture with `samples`.
    pub const fn primary_rays(self, samples: u64) -> u64 {
        match self {
            Self::Samples => 0,
            _ if self.takes_samples() => samples,
            _ => 1,
        }
    }
}

/// Computes `quantity` for all pixels. Calls `after_row` with the number of finished rows. Returns `None` if it stopped
/// the computation.
///
/// # Errors
/// An error if memory is short.
pub fn show<L: Layout>(
    quantity: Quantity,
    prepared: &Prepared<L>,
    mut after_row: impl FnMut(usize) -> ControlFlow<()>,
) -> Result<Option<Floats>, String> {
    let (width, height) = (prepared.size.width(), prepared.size.height());
    let mut floats = Floats::zeros(width, height, quantity.channels())?;
    let mut tracer = Tracer::new(prepared);
    for (row, values) in floats.values.chunks_exact_mut(width * quantity.channels()).enumerate() {
        for (column, pixel) in values.chunks_exact_mut(quantity.channels()).enumerate() {
            let values = match quantity {
                Quantity::Samples => [prepared.samples as f64; 3],
                Quantity::Variance | Quantity::Cost => {
                    let (variance, cost) = tracer.pixel(row, column).map_err(|error| error.to_string())?;
                    if quantity == Quantity::Cost { cost } else { variance.to_array() }
                }
                _ => tracer.first_hit(quantity, row, column),
            };
            pixel.iter_mut().zip(values).for_each(|(number, value)| *number = value as f32);
        }
        if after_row(row + 1).is_break() {
            return Ok(None);
        }
    }
    Ok(Some(floats))
}

/// Traces rays one at a time, with the acceleration structure and the exact intersections of the renderer, but without
/// its shortcuts for many rays. A pixel has the same colour by both.
struct Tracer<'a, L: Layout> {
    prepared: &'a Prepared<L>,
    objects: Counted<'a, L::Objects>,
    stack: Stack,
    jitter: Uniform,
    scatter_samples: ScatterSamples,
    reflectances: Vec<Vec3>,
    rays: u64,
    hits: u64,
}

impl<'a, L: Layout> Tracer<'a, L> {
    fn new(prepared: &'a Prepared<L>) -> Self {
        let set = InstructionSet::chosen();
        Self {
            prepared,
            objects: Counted { objects: &prepared.objects, reads: Cell::default() },
            stack: Stack::EMPTY,
            jitter: Uniform::new(prepared.ray_seed),
            scatter_samples: ScatterSamples::new(prepared.scatter_stream, prepared.material_seed, set),
            reflectances: Vec::new(),
            rays: 0,
            hits: 0,
        }
    }

    fn closest_hit(&mut self, ray: &Ray, start: ObjectId) -> ClosestHit {
        self.prepared.accel.closest_hit::<Portable, _>(&self.objects, ray, start, &mut self.stack)
    }

    /// Returns a quantity of the hit of the ray through the middle of the pixel.
    fn first_hit(&mut self, quantity: Quantity, row: usize, column: usize) -> [f64; 3] {
        let ray = self.prepared.camera.ray(row as f64, column as f64, [0.0; 2]);
        let hit = self.closest_hit(&ray, NO_OBJECT);
        if !hit.is_hit() {
            return [f64::NAN; 3];
        }
        let objects = &self.prepared.objects;
        let surface = SurfaceHit::new(objects, &ray, &hit);
        match quantity {
            Quantity::Depth => [hit.lambda * ray.direction.length(); 3],
            Quantity::Normal => front_and_normal(ray.direction, surface.outward.unit()).1.to_array(),
            Quantity::Object => [f64::from(file_index_of(objects, hit.object)); 3],
            Quantity::Material => [f64::from(surface.material); 3],
            Quantity::Part => match (ObjectRef::of(objects, hit.object), hit.part) {
                (ObjectRef::Sphere(_), _) => [0.0; 3],
                (_, CylinderPart::Side) => [1.0; 3],
                (_, CylinderPart::Top) => [2.0; 3],
                (_, CylinderPart::Bottom) => [3.0; 3],
            },
            _ => [hit.lambda; 3],
        }
    }

    /// Traces the samples of a pixel. Returns the variance of their colours, which is NaN for one sample, and their
    /// cost: rays, hits, and objects with which rays were intersected. Call it for all pixels in their order, because
    /// they share the random numbers.
    fn pixel(&mut self, row: usize, column: usize) -> Result<(Vec3, [f64; 3]), Error> {
        let (rays, hits, reads) = (self.rays, self.hits, self.objects.reads.get());
        let (mut mean, mut squares, mut count) = (Vec3::ZERO, Vec3::ZERO, 0.0);
        for _ in 0..self.prepared.samples {
            let mut offset = [0.0; 2];
            if self.prepared.scatter != Scatter::Deterministic {
                offset = offset.map(|_| self.jitter.draw(-0.5, 0.5));
            }
            let color = self.color(self.prepared.camera.ray(row as f64, column as f64, offset))?;
            // Welford's recurrence, which has no cancellation.
            count += 1.0;
            let before = color - mean;
            mean = mean + before / count;
            squares = squares + before.attenuate(color - mean);
        }
        let cost = [self.rays - rays, self.hits - hits, self.objects.reads.get() - reads].map(|count| count as f64);
        Ok((squares / (count - 1.0), cost))
    }

    /// Returns the linear colour of a path that begins with `ray`.
    fn color(&mut self, mut ray: Ray) -> Result<Vec3, Error> {
        let (mut start, mut color) = (NO_OBJECT, Vec3::ZERO);
        self.reflectances.clear();
        for _ in 0..self.prepared.max_depth {
            self.rays += 1;
            let hit = self.closest_hit(&ray, start);
            if !hit.is_hit() {
                color = self.prepared.background.color(ray.direction);
                break;
            }
            self.hits += 1;
            let surface = SurfaceHit::new(&self.prepared.objects, &ray, &hit);
            let material = &self.prepared.materials[surface.material as usize];
            let mut direction = material.unperturbed_direction(ray.direction, surface.outward);
            if material.takes_scatter_sample() {
                self.scatter_samples.prepare();
                direction = material.scatter_params.scatter_around(direction, self.scatter_samples.next());
                cpu::internals::input::error::push(&mut self.reflectances, material.reflectance, "a path")?;
            }
            (ray, start) = (Ray { origin: surface.point, direction }, hit.object);
        }
        Ok(self.reflectances.iter().rev().fold(color, |color, &reflectance| color.attenuate(reflectance)))
    }
}

/// Objects that count how often one of them is read to intersect it with a ray.
struct Counted<'a, O> {
    /// The objects.
    objects: &'a O,
    /// How often one of them was read.
    reads: Cell<u64>,
}

impl<O> Counted<'_, O> {
    fn count(&self) {
        self.reads.set(self.reads.get() + 1);
    }
}

impl<O: Objects> Objects for Counted<'_, O> {
    fn build(_: &Scene) -> Result<Self, Error> {
        Err(Error::OutOfMemory { what: "objects that are borrowed" })
    }

    fn sphere_count(&self) -> usize {
        self.objects.sphere_count()
    }

    fn cylinder_count(&self) -> usize {
        self.objects.cylinder_count()
    }

    fn sphere(&self, index: usize) -> Placed<SphereRecord> {
        self.count();
        self.objects.sphere(index)
    }

    fn prefetch_sphere(&self, index: usize) {
        self.objects.prefetch_sphere(index);
    }

    fn cylinder(&self, index: usize) -> Placed<CylinderRecord> {
        self.count();
        self.objects.cylinder(index)
    }

    fn file_axis(&self, index: usize) -> Vec3 {
        self.objects.file_axis(index)
    }

    fn reorder(&mut self, _: &mut [u32], _: &mut [u32]) {}
}

#[cfg(test)]
mod tests;
