//! The two layouts of pixels and objects in memory, with the traits that both implement.
//!
//! Only the storage differs. Every formula works on the records that [`Objects`] returns. The compiler makes a copy of
//! the renderer for each layout, so no call is dispatched at run time.
//!
//! Uses [`geometry`](crate::geometry), [`image`](crate::image) and [`input`](crate::input). Begin with [`aos`].

pub mod aos;
mod huge_pages;
pub mod prefetch;
pub mod soa;

use crate::{
    geometry::cylinder::CylinderRecord, geometry::sphere::SphereRecord, image::Image, input::error,
    input::error::Error, input::scene::Cylinder, input::scene::MaterialId, input::scene::Object, input::scene::Scene,
    input::scene::Shape, input::scene::Sphere, math::vec3::Vec3,
};

/// A layout in memory, which the renderer takes as a type parameter. Its associated types are the containers that store
/// the pixels and the objects. Two marker types implement it, [`Aos`](aos::Aos) and [`Soa`](soa::Soa).
pub trait Layout {
    /// The type that stores the pixels of a picture.
    type Image: Image;
    /// The type that stores the objects of a scene.
    type Objects: Objects;
}

/// A sphere or a cylinder with its place in the scene file and its material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed<R> {
    /// The shape, in the form that the formulas use.
    pub record: R,
    /// The object's place among all objects of the scene file, from 0.
    pub file_index: u32,
    /// The object's material, an index into [`Scene::materials`].
    pub material: MaterialId,
}

/// The objects of a scene. Spheres and cylinders are stored separately. [`build`](Self::build) stores each kind in the
/// order of the scene file, and [`reorder`](Self::reorder) changes this order.
pub trait Objects: Sized {
    /// Returns the objects of `scene`.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short, or if there are more objects than `u32` counts.
    fn build(scene: &Scene) -> Result<Self, Error>;
    /// Returns the number of spheres.
    fn sphere_count(&self) -> usize;
    /// Returns the number of cylinders.
    fn cylinder_count(&self) -> usize;
    /// Returns the sphere at `index` among the spheres.
    ///
    /// # Panics
    /// If there is no such sphere.
    fn sphere(&self, index: usize) -> Placed<SphereRecord>;
    /// Prefetches the sphere at `index` among the spheres: the processor loads it into its nearest cache, and the
    /// program does not wait. If there is no such sphere, nothing happens.
    fn prefetch_sphere(&self, index: usize);
    /// Returns the cylinder at `index` among the cylinders.
    ///
    /// # Panics
    /// If there is no such cylinder.
    fn cylinder(&self, index: usize) -> Placed<CylinderRecord>;
    /// Returns the axis of the cylinder at `index`, with the numbers of the scene file. The axis of the record is
    /// rounded, because it has length one.
    ///
    /// # Panics
    /// If there is no such cylinder.
    fn file_axis(&self, index: usize) -> Vec3;
    /// Moves the sphere at `spheres[i]` to the index `i`, for each `i`, and the cylinders in the same way. Each list
    /// must have every index once. Afterwards the lists have no meaning.
    fn reorder(&mut self, spheres: &mut [u32], cylinders: &mut [u32]);
}

/// Moves the item at `sources[i]` to the index `i`, for each `i`, by calls of `swap` with two indices. `sources` must
/// have every index once. Sets each `sources[i]` to `i`.
fn reorder(sources: &mut [u32], mut swap: impl FnMut(usize, usize)) {
    for first in 0..sources.len() {
        let mut at = first;
        // This follows a cycle of moves. Each swap brings one item to its place, and the last swap brings two.
        loop {
            let from = std::mem::replace(&mut sources[at], at as u32) as usize;
            if from == first {
                break;
            }
            debug_assert_ne!(from, at, "an index is twice in the list");
            swap(at, from);
            at = from;
        }
    }
}

/// Returns the objects of `scene` in the order of the scene file, each with its place.
fn in_file_order(scene: &Scene) -> impl Iterator<Item = (&Object, u32)> {
    scene.objects.iter().zip(0..)
}

/// Returns the spheres of `scene` in the order of the scene file.
fn spheres(scene: &Scene) -> impl Iterator<Item = Placed<SphereRecord>> {
    in_file_order(scene).filter_map(|(object, file_index)| {
        let Shape::Sphere(Sphere { center, radius }) = object.shape else { return None };
        Some(Placed { record: SphereRecord::new(center, radius), file_index, material: object.material })
    })
}

/// Returns the cylinders of `scene` in the order of the scene file, each with its axis as in the file.
fn cylinders(scene: &Scene) -> impl Iterator<Item = (Placed<CylinderRecord>, Vec3)> {
    in_file_order(scene).filter_map(|(object, file_index)| {
        let Shape::Cylinder(Cylinder { center, radius, axis }) = object.shape else { return None };
        let record = CylinderRecord::new(center, radius, axis);
        Some((Placed { record, file_index, material: object.material }, axis))
    })
}

/// Returns the number of spheres and the number of cylinders in `scene`.
///
/// # Errors
/// [`Error::OutOfMemory`] if there are more objects than `u32` counts.
fn count_kinds(scene: &Scene) -> Result<(usize, usize), Error> {
    u32::try_from(scene.objects.len()).map_err(|_| Error::OutOfMemory { what: OBJECTS })?;
    let spheres = scene.objects.iter().filter(|object| matches!(object.shape, Shape::Sphere(_))).count();
    Ok((spheres, scene.objects.len() - spheres))
}

/// The words for the objects in the message of [`Error::OutOfMemory`].
pub(crate) const OBJECTS: &str = "the objects";

/// Returns an empty list with room for `count` items, for a list that grows with the number of objects. A large list is
/// in huge pages if the system has them.
///
/// # Errors
/// [`Error::OutOfMemory`] with the words `what` if memory is short.
pub(crate) fn with_room<T>(count: usize, what: &'static str) -> Result<Vec<T>, Error> {
    let mut list = error::with_room(count, what)?;
    huge_pages::ask(&mut list);
    Ok(list)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::Rgb;
    use crate::input::size::Size;

    const SCENE: &str = "matte: a 1 1 1\nmatte: b 0 0 0\nsphere: 1 2 3 4 a\ncylinder: 5 6 7 8 0 2 0 b\n\
        sphere: 0 0 0 1 b\ncylinder: 0 0 0 1 3 0 0 a\nsphere: 9 9 9 2 a\n";

    fn objects<L: Layout>(scene: &str) -> L::Objects {
        let scene = Scene::parse(scene.as_bytes()).expect("the scene is valid");
        L::Objects::build(&scene).expect("five objects fit")
    }

    fn black<L: Layout>() -> L::Image {
        L::Image::black(Size::new(3, 2).expect("six pixels are few")).expect("six pixels fit")
    }

    #[test]
    fn room_is_made_for_as_many_as_there_are() {
        let scene = Scene::parse(SCENE.as_bytes()).expect("the scene is valid");
        assert!(matches!(count_kinds(&scene), Ok((3, 2))));
        assert!(with_room::<u64>(5, OBJECTS).is_ok_and(|list| list.is_empty() && list.capacity() >= 5));
        assert!(matches!(with_room::<u64>(usize::MAX / 8, "a name"), Err(Error::OutOfMemory { what: "a name" })));
    }

    #[test]
    fn items_are_moved_to_the_order_of_a_list() {
        for multiplier in [1, 2, 3, 5, 10] {
            let order = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10].map(|index| (index * multiplier + 4) % 11);
            let mut items = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10];
            let mut done = order;
            reorder(&mut done, |left, right| items.swap(left, right));
            assert_eq!((items, done), (order, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]));
        }
    }

    /// Defines the tests of the layout `$layout` in a module with its name. `tests/utest.sh` finds them by that name.
    macro_rules! tests_of {
        ($name:ident, $layout:ty) => {
            mod $name {
                use super::*;

                type L = $layout;

                #[test]
                fn objects_of_each_kind_are_counted() {
                    let counts = |scene| {
                        let objects = objects::<L>(scene);
                        (objects.sphere_count(), objects.cylinder_count())
                    };
                    assert_eq!((counts(SCENE), counts("")), ((3, 2), (0, 0)));
                }

                #[test]
                fn a_sphere_has_its_record_place_and_material() {
                    let record = SphereRecord::new([1.0, 2.0, 3.0].into(), 4.0);
                    let objects = objects::<L>(SCENE);
                    assert_eq!(objects.sphere(0), Placed { record, file_index: 0, material: 0 });
                    assert_eq!((objects.sphere(1).file_index, objects.sphere(1).material), (2, 1));
                }

                #[test]
                fn a_cylinder_has_its_record_place_and_material() {
                    let record = CylinderRecord::new([5.0, 6.0, 7.0].into(), 8.0, [0.0, 2.0, 0.0].into());
                    let objects = objects::<L>(SCENE);
                    assert_eq!(objects.cylinder(0), Placed { record, file_index: 1, material: 1 });
                    assert_eq!((objects.cylinder(1).file_index, objects.cylinder(1).material), (3, 0));
                }

                #[test]
                fn an_axis_is_that_of_the_file() {
                    let objects = objects::<L>(SCENE);
                    assert_eq!(
                        [0, 1].map(|at| objects.file_axis(at)),
                        [Vec3::new(0.0, 2.0, 0.0), Vec3::new(3.0, 0.0, 0.0)]
                    );
                }

                #[test]
                fn objects_are_moved_with_all_that_belongs_to_them() {
                    let (before, mut after) = (objects::<L>(SCENE), objects::<L>(SCENE));
                    after.reorder(&mut [2, 0, 1], &mut [1, 0]);
                    assert_eq!([0, 1, 2].map(|at| after.sphere(at)), [2, 0, 1].map(|at| before.sphere(at)));
                    assert_eq!([0, 1].map(|at| after.cylinder(at)), [1, 0].map(|at| before.cylinder(at)));
                    assert_eq!([0, 1].map(|at| after.file_axis(at)), [1, 0].map(|at| before.file_axis(at)));
                }

                #[test]
                fn a_sphere_is_prefetched_if_it_exists() {
                    for at in [0, 2, 3, usize::MAX] {
                        objects::<L>(SCENE).prefetch_sphere(at);
                    }
                }

                #[test]
                #[should_panic(expected = "out of bounds")]
                fn there_is_no_sphere_beyond_the_last() {
                    objects::<L>(SCENE).sphere(3);
                }

                #[test]
                #[should_panic(expected = "out of bounds")]
                fn there_is_no_cylinder_beyond_the_last() {
                    objects::<L>(SCENE).cylinder(2);
                }

                #[test]
                #[should_panic(expected = "out of bounds")]
                fn there_is_no_axis_beyond_the_last() {
                    let _ = objects::<L>(SCENE).file_axis(2);
                }

                #[test]
                #[should_panic(expected = "out of bounds")]
                fn there_is_no_object_in_an_empty_scene() {
                    objects::<L>("").sphere(0);
                }

                #[test]
                fn a_new_image_is_black_and_has_its_size() {
                    let image = black::<L>();
                    assert_eq!((image.size().width(), image.size().height()), (3, 2));
                    assert_eq!([0, 1, 2, 3, 4, 5].map(|at| image.pixel(at)), [Rgb::default(); 6]);
                }

                #[test]
                fn a_pixel_is_stored_and_its_neighbours_stay() {
                    let (mut image, color) = (black::<L>(), Rgb { red: 1, green: 2, blue: 3 });
                    image.set_pixel(4, color);
                    assert_eq!([3, 4, 5].map(|at| image.pixel(at)), [Rgb::default(), color, Rgb::default()]);
                }

                #[test]
                #[should_panic(expected = "out of bounds")]
                fn no_pixel_is_read_beyond_the_last() {
                    black::<L>().pixel(6);
                }

                #[test]
                #[should_panic(expected = "out of bounds")]
                fn no_pixel_is_written_beyond_the_last() {
                    black::<L>().set_pixel(6, Rgb::default());
                }
            }
        };
    }

    tests_of!(aos, crate::layout::aos::Aos);
    tests_of!(soa, crate::layout::soa::Soa);
}
