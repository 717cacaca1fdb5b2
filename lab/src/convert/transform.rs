//! Affine transforms, in the order in which pbrt and Mitsuba compose them.

use cpu::Vec3;

/// An affine transform. `a.then_inner(b)` applies `b` first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Images of the three unit vectors.
    pub columns: [Vec3; 3],
    /// Image of the origin.
    pub origin: Vec3,
    /// Position, target and north of the camera, if the transform was given by them alone. A camera read from them has
    /// exactly the numbers of the file.
    pub view: Option<[Vec3; 3]>,
}

impl Transform {
    /// The transform that changes nothing.
    pub const IDENTITY: Self = Self::scale([1.0, 1.0, 1.0]);

    const fn new(columns: [Vec3; 3], origin: Vec3) -> Self {
        Self { columns, origin, view: None }
    }

    /// Returns the move by `offset`.
    pub const fn translate(offset: Vec3) -> Self {
        Self { origin: offset, ..Self::IDENTITY }
    }

    /// Returns the scale by a factor for each axis.
    pub const fn scale([x, y, z]: [f64; 3]) -> Self {
        Self::new([Vec3::new(x, 0.0, 0.0), Vec3::new(0.0, y, 0.0), Vec3::new(0.0, 0.0, z)], Vec3::ZERO)
    }

    /// Returns the rotation about `axis` by an angle in degrees.
    pub fn rotate(axis: Vec3, degrees: f64) -> Self {
        let turn = |vector| turned(vector, axis.unit(), degrees.to_radians());
        Self::new(Self::IDENTITY.columns.map(turn), Vec3::ZERO)
    }

    /// Returns the transform of a 4 x 4 matrix, column by column, or `None` if the last row is not 0 0 0 1.
    pub fn matrix(m: [f64; 16]) -> Option<Self> {
        let column = |at: usize| Vec3::new(m[4 * at], m[4 * at + 1], m[4 * at + 2]);
        let is_affine = [m[3], m[7], m[11], m[15]] == [0.0, 0.0, 0.0, 1.0];
        is_affine.then(|| Self::new([column(0), column(1), column(2)], column(3)))
    }

    /// Returns the transform from camera to world for a position, a target and a north: the camera looks along its +z
    /// towards the target, with +x along north × z. pbrt shows +x at the right, Mitsuba at the left.
    pub fn look_at(view: [Vec3; 3]) -> Self {
        let [position, target, north] = view;
        let forward = (target - position).unit();
        let x = north.unit().cross(forward).unit();
        Self { view: Some(view), ..Self::new([x, forward.cross(x), forward], position) }
    }

    /// Returns a transform that takes the z axis from -0.5 to 0.5 to the axis of a cylinder, and x and y to unit
    /// vectors that are perpendicular to it.
    pub fn along(axis: Vec3, center: Vec3) -> Self {
        let unit = axis.unit_and_length().0;
        let other = if unit.x.abs() < 0.6 { Vec3::new(1.0, 0.0, 0.0) } else { Vec3::new(0.0, 1.0, 0.0) };
        let x = other.cross(unit).unit();
        Self::new([x, unit.cross(x), axis], center)
    }

    /// Returns the image of a direction.
    pub fn vector(&self, v: Vec3) -> Vec3 {
        let [x, y, z] = self.columns;
        x * v.x + y * v.y + z * v.z
    }

    /// Returns the image of a point.
    pub fn point(&self, p: Vec3) -> Vec3 {
        self.vector(p) + self.origin
    }

    /// Returns the transform that applies `inner` first, and then this one.
    pub fn then_inner(&self, inner: &Self) -> Self {
        Self::new(inner.columns.map(|column| self.vector(column)), self.point(inner.origin))
    }

    /// Returns the determinant of the linear part. It is negative if the transform mirrors.
    pub fn determinant(&self) -> f64 {
        let [x, y, z] = self.columns;
        x.dot(y.cross(z))
    }

    /// Returns the inverse. Its numbers are not finite if there is none.
    pub fn inverse(&self) -> Self {
        let [x, y, z] = self.columns;
        let rows = [y.cross(z), z.cross(x), x.cross(y)].map(|row| row / self.determinant());
        let column = |of: fn(Vec3) -> f64| Vec3::from(rows.map(of));
        let linear = Self::new([column(|r| r.x), column(|r| r.y), column(|r| r.z)], Vec3::ZERO);
        Self { origin: -linear.vector(self.origin), ..linear }
    }

    /// Returns the factor by which the transform scales the first `axes` axes, two or three. Returns also whether it
    /// scales them equally and keeps all axes perpendicular, as far as `f32` can tell.
    ///
    /// A factor within 10^-12 of 1 counts as 1: the matrix of a rotation in decimals has such errors.
    pub fn scale_of(&self, axes: usize) -> (f64, bool) {
        const ERROR: f64 = 1e-5;
        let lengths = self.columns.map(|column| column.unit_and_length().1);
        let units = self.columns.map(|column| column.unit_and_length().0);
        let product: f64 = lengths[..axes].iter().product();
        let is_same = lengths[..axes].iter().all(|&length| length == lengths[0]);
        let mean = match (is_same, axes) {
            (true, _) => lengths[0],
            (false, 3) => product.cbrt(),
            (false, _) => product.sqrt(),
        };
        let is_equal = lengths[..axes].iter().all(|length| (length / mean - 1.0).abs() < ERROR);
        let cosines = [units[0].dot(units[1]), units[1].dot(units[2]), units[2].dot(units[0])];
        let is_square = cosines.iter().all(|cosine| cosine.abs() < ERROR);
        (if (mean - 1.0).abs() < 1e-12 { 1.0 } else { mean }, is_equal && is_square)
    }
}

/// Returns `vector`, turned by `angle` in radians about `axis`, which has length one (Rodrigues' formula).
pub fn turned(vector: Vec3, axis: Vec3, angle: f64) -> Vec3 {
    let (sine, cosine) = angle.sin_cos();
    vector * cosine + axis.cross(vector) * sine + axis * (axis.dot(vector) * (1.0 - cosine))
}
