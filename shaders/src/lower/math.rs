//! Lowers the built-in functions of f64.
//!
//! A function that WGSL defines by others, such as `length`, becomes those others, in the order of their definition and
//! from the first component to the last. Each of them is rounded once.

use naga::common::wgsl::TryToWgsl;
use naga::{Expression, Handle, MathFunction};

use super::function::FunctionLowering;
use super::refusal::{Lowered, Refusal};

impl FunctionLowering<'_, '_> {
    /// Lowers a built-in function. Returns `None` if no argument is f64.
    pub fn math(
        &mut self,
        function: MathFunction,
        arguments: &[Handle<Expression>],
    ) -> Lowered<Option<Handle<Expression>>> {
        use MathFunction as F;
        if arguments.iter().all(|argument| self.shape(*argument).is_none()) {
            return Ok(None);
        }
        let by_component = match function {
            F::Abs => Some("f64_abs"),
            F::Min => Some("f64_min"),
            F::Max => Some("f64_max"),
            F::Clamp => Some("f64_clamp"),
            F::Floor => Some("f64_floor"),
            F::Ceil => Some("f64_ceil"),
            F::Trunc => Some("f64_trunc"),
            F::Round => Some("f64_round_even"),
            F::Fract => Some("f64_fract"),
            F::Sign => Some("f64_sign"),
            F::Sqrt => Some("f64_sqrt"),
            F::Fma => Some("f64_fma"),
            _ => None,
        };
        if let Some(name) = by_component {
            return self.each(name, arguments).map(Some);
        }
        let parts = arguments.iter().map(|argument| self.components(*argument)).collect::<Lowered<Vec<_>>>()?;
        let lowered = match (function, &parts[..]) {
            (F::Saturate, [a]) => {
                let [zero, one] = [self.number(0.0), self.number(1.0)];
                self.collect(a, |this, a| this.call("f64_clamp", &[a, zero, one]))?
            }
            (F::InverseSqrt, [a]) => {
                let one = self.number(1.0);
                self.collect(a, |this, a| {
                    let root = this.call("f64_sqrt", &[a])?;
                    this.call("f64_divide", &[one, root])
                })?
            }
            (F::Dot, [a, b]) => self.dot(a, b)?,
            (F::Length, [a]) => self.length(a)?,
            (F::Distance, [a, b]) => {
                let apart = self.pairs("f64_subtract", a, b)?;
                self.length(&apart)?
            }
            (F::Normalize, [a]) => {
                let length = self.length(a)?;
                self.collect(a, |this, a| this.call("f64_divide", &[a, length]))?
            }
            (F::Cross, [a, b]) => self.cross(a, b)?,
            (F::Reflect, [a, normal]) => {
                // a - 2 dot(normal, a) normal
                let [two, along] = [self.number(2.0), self.dot(normal, a)?];
                let twice = self.call("f64_multiply", &[two, along])?;
                let scaled = self.scaled(normal, twice)?;
                let reflected = self.pairs("f64_subtract", a, &scaled)?;
                self.vector(&reflected)
            }
            (F::FaceForward, [normal, a, b]) => {
                let [zero, along] = [self.number(0.0), self.dot(a, b)?];
                let condition = self.call("f64_less", &[along, zero])?;
                self.collect(normal, |this, accept| {
                    let reject = this.call("f64_negate", &[accept])?;
                    Ok(this.emit(Expression::Select { condition, accept, reject }))
                })?
            }
            (F::Mix, [a, b, t]) => self.mix(a, b, t)?,
            (F::Step, [edge, a]) => {
                let [zero, one] = [self.number(0.0), self.number(1.0)];
                let is_beyond = self.pairs("f64_less_equal", edge, a)?;
                self.collect(&is_beyond, |this, condition| {
                    Ok(this.emit(Expression::Select { condition, accept: one, reject: zero }))
                })?
            }
            (other, _) => {
                let name = other.try_to_wgsl().unwrap_or("this function");
                return Err(Refusal::new(self.span, format!("`{name}` of f64")));
            }
        };
        Ok(Some(lowered))
    }

    /// Returns the vector of what `each` returns for each component.
    fn collect(
        &mut self,
        components: &[Handle<Expression>],
        mut each: impl FnMut(&mut Self, Handle<Expression>) -> Lowered<Handle<Expression>>,
    ) -> Lowered<Handle<Expression>> {
        let results = components.iter().map(|part| each(self, *part)).collect::<Lowered<Vec<_>>>()?;
        Ok(self.vector(&results))
    }

    /// Calls the function `name` for each pair of components. A single component counts for all of the other side.
    fn pairs(
        &mut self,
        name: &str,
        a: &[Handle<Expression>],
        b: &[Handle<Expression>],
    ) -> Lowered<Vec<Handle<Expression>>> {
        let of = |parts: &[Handle<Expression>], index: usize| parts[index.min(parts.len() - 1)];
        (0..a.len().max(b.len())).map(|index| self.call(name, &[of(a, index), of(b, index)])).collect()
    }

    fn scaled(&mut self, a: &[Handle<Expression>], factor: Handle<Expression>) -> Lowered<Vec<Handle<Expression>>> {
        self.pairs("f64_multiply", a, &[factor])
    }

    fn dot(&mut self, a: &[Handle<Expression>], b: &[Handle<Expression>]) -> Lowered<Handle<Expression>> {
        let products = self.pairs("f64_multiply", a, b)?;
        let mut sum = products[0];
        for product in &products[1..] {
            sum = self.call("f64_add", &[sum, *product])?;
        }
        Ok(sum)
    }

    /// Returns the length of a vector, or the magnitude of a number.
    fn length(&mut self, a: &[Handle<Expression>]) -> Lowered<Handle<Expression>> {
        if let [number] = a {
            return self.call("f64_abs", &[*number]);
        }
        let square = self.dot(a, a)?;
        self.call("f64_sqrt", &[square])
    }

    fn cross(&mut self, a: &[Handle<Expression>], b: &[Handle<Expression>]) -> Lowered<Handle<Expression>> {
        let mut components = Vec::new();
        for (i, j) in [(1, 2), (2, 0), (0, 1)] {
            let products = [self.call("f64_multiply", &[a[i], b[j]])?, self.call("f64_multiply", &[a[j], b[i]])?];
            components.push(self.call("f64_subtract", &products)?);
        }
        Ok(self.vector(&components))
    }

    /// Returns a (1 - t) + b t.
    fn mix(
        &mut self,
        a: &[Handle<Expression>],
        b: &[Handle<Expression>],
        t: &[Handle<Expression>],
    ) -> Lowered<Handle<Expression>> {
        let one = self.number(1.0);
        let rest = self.pairs("f64_subtract", &[one], t)?;
        let (first, second) = (self.pairs("f64_multiply", a, &rest)?, self.pairs("f64_multiply", b, t)?);
        let sums = self.pairs("f64_add", &first, &second)?;
        Ok(self.vector(&sums))
    }
}
