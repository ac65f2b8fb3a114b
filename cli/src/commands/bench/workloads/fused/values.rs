//! Nodes as functions of values: each calls the node's own body, which rustc inlines.

use glam::Vec3A;
use phenomenon_compiler::emit::{
    Body, Color, Emit, One, Sink, Vector, Words, read_color, read_vector,
};
use phenomenon_compiler::nodes::ports;
use phenomenon_compiler::nodes::{arithmetic, color, logic, vector};

/// The value of an input, word by word. Positions are constants once all is inlined, so nothing of this
/// is left in the code.
pub trait Given<E: Emit>: Copy {
    /// Words it takes.
    const WIDTH: usize;

    /// Word `at` as a number.
    #[inline(always)]
    fn real(self, at: usize) -> E::Real {
        unreachable!("word {at} is no number")
    }

    /// Word `at` as an integer.
    #[inline(always)]
    fn int(self, at: usize) -> E::Int {
        unreachable!("word {at} is no integer")
    }

    /// Word `at` as a truth value.
    #[inline(always)]
    fn mask(self, at: usize) -> E::Mask {
        unreachable!("word {at} is no truth value")
    }
}

/// An integer.
#[derive(Clone, Copy)]
pub struct Whole<I>(pub I);

/// A truth value.
#[derive(Clone, Copy)]
pub struct Truth<M>(pub M);

impl<E: Emit> Given<E> for One<E::Real> {
    const WIDTH: usize = 1;
    #[inline(always)]
    fn real(self, _: usize) -> E::Real {
        self.x
    }
}

impl<E: Emit> Given<E> for Vector<E::Real> {
    const WIDTH: usize = 3;
    #[inline(always)]
    fn real(self, at: usize) -> E::Real {
        match at {
            0 => self.x,
            1 => self.y,
            _ => self.z,
        }
    }
}

impl<E: Emit> Given<E> for Color<E::Real> {
    const WIDTH: usize = 4;
    #[inline(always)]
    fn real(self, at: usize) -> E::Real {
        match at {
            0 => self.r,
            1 => self.g,
            2 => self.b,
            _ => self.a,
        }
    }
}

impl<E: Emit> Given<E> for Whole<E::Int> {
    const WIDTH: usize = 1;
    #[inline(always)]
    fn int(self, _: usize) -> E::Int {
        self.0
    }
}

impl<E: Emit> Given<E> for Truth<E::Mask> {
    const WIDTH: usize = 1;
    #[inline(always)]
    fn mask(self, _: usize) -> E::Mask {
        self.0
    }
}

/// One input and those after it.
impl<E: Emit, A: Given<E>, B: Given<E>> Given<E> for (A, B) {
    const WIDTH: usize = A::WIDTH + B::WIDTH;
    #[inline(always)]
    fn real(self, at: usize) -> E::Real {
        if at < A::WIDTH { self.0.real(at) } else { self.1.real(at - A::WIDTH) }
    }
    #[inline(always)]
    fn int(self, at: usize) -> E::Int {
        if at < A::WIDTH { self.0.int(at) } else { self.1.int(at - A::WIDTH) }
    }
    #[inline(always)]
    fn mask(self, at: usize) -> E::Mask {
        if at < A::WIDTH { self.0.mask(at) } else { self.1.mask(at - A::WIDTH) }
    }
}

/// The words of all inputs.
struct Inputs<T>(T);

impl<E: Emit, T: Given<E>> Words<E> for Inputs<T> {
    #[inline(always)]
    fn real(&self, index: usize) -> E::Real {
        self.0.real(index)
    }
    #[inline(always)]
    fn int(&self, index: usize) -> E::Int {
        self.0.int(index)
    }
    #[inline(always)]
    fn mask(&self, index: usize) -> E::Mask {
        self.0.mask(index)
    }
    fn fixed(&self, index: usize) -> i32 {
        unreachable!("word {index} of a node of a workload is not known before shading")
    }
}

/// What a body writes.
struct Outputs<E: Emit> {
    reals: [E::Real; 4],
    mask: E::Mask,
}

impl<E: Emit> Sink<E> for Outputs<E> {
    #[inline(always)]
    fn real(&mut self, index: usize, value: E::Real) {
        self.reals[index] = value;
    }
    fn int(&mut self, index: usize, _: E::Int) {
        unreachable!("no node of a workload yields an integer, as word {index}")
    }
    #[inline(always)]
    fn mask(&mut self, _: usize, value: E::Mask) {
        self.mask = value;
    }
}

/// A value a generic node takes and yields.
pub trait Shape<E: Emit>: Given<E> {
    /// As headers of nodes name it.
    type Port: ports::Shape;

    /// From the words of an output.
    fn taken(reals: [E::Real; 4]) -> Self;
}

impl<E: Emit> Shape<E> for One<E::Real> {
    type Port = ports::scalar;
    #[inline(always)]
    fn taken([x, ..]: [E::Real; 4]) -> Self {
        Self { x }
    }
}

impl<E: Emit> Shape<E> for Vector<E::Real> {
    type Port = ports::vector;
    #[inline(always)]
    fn taken([x, y, z, _]: [E::Real; 4]) -> Self {
        Self { x, y, z }
    }
}

impl<E: Emit> Shape<E> for Color<E::Real> {
    type Port = ports::color;
    #[inline(always)]
    fn taken([r, g, b, a]: [E::Real; 4]) -> Self {
        Self { r, g, b, a }
    }
}

/// The nodes over a back end.
#[derive(Clone, Copy)]
pub struct Nodes<E>(pub E);

impl<E: Emit> Nodes<E> {
    #[inline(always)]
    fn run<B: Body>(self, given: impl Given<E>) -> Outputs<E> {
        let mut outputs = Outputs { reals: [self.0.real(0.0); 4], mask: self.0.mask(false) };
        B::run(self.0, &Inputs(given), &mut outputs);
        outputs
    }

    /// A literal.
    #[inline(always)]
    pub fn number(self, value: f32) -> One<E::Real> {
        One { x: self.0.real(f64::from(value)) }
    }

    /// A literal of three numbers.
    #[inline(always)]
    pub fn vector(self, literal: Vec3A) -> Vector<E::Real> {
        let [x, y, z] = literal.to_array();
        Vector { x: self.number(x).x, y: self.number(y).x, z: self.number(z).x }
    }

    /// A literal of three numbers, opaque.
    #[inline(always)]
    pub fn color(self, literal: Vec3A) -> Color<E::Real> {
        let Vector { x: r, y: g, z: b } = self.vector(literal);
        Color { r, g, b, a: self.0.real(1.0) }
    }

    /// The one output of `less`.
    #[inline(always)]
    pub fn less(self, a: One<E::Real>, b: One<E::Real>) -> Truth<E::Mask> {
        Truth(self.run::<logic::less::NodeBody<ports::scalar>>((a, b)).mask)
    }

    /// The output `y` of `split_vector`.
    #[inline(always)]
    pub fn split_vector_y(self, vector: Vector<E::Real>) -> One<E::Real> {
        One { x: self.run::<vector::split_vector::NodeBody<ports::scalar>>(vector).reals[1] }
    }
}

/// Nodes of one output: in the order of their inputs, each with its type.
macro_rules! nodes {
    ($($group:ident::$node:ident($first:ident: $first_type:ty $(, $input:ident: $type:ty)*) -> $result:ty;)+) => {
        impl<E: Emit> Nodes<E> {
            $(#[doc = concat!("The node `", stringify!($node), "`.")]
            #[inline(always)]
            pub fn $node(self, $first: $first_type $(, $input: $type)*) -> $result {
                let given = nodes!(@list $first $($input)*);
                <$result as Shape<E>>::taken(self.run::<$group::$node::NodeBody<ports::scalar>>(given).reals)
            })+
        }
    };
    (generic $($group:ident::$node:ident($first:ident: $first_type:ty $(, $input:ident: $type:ty)*);)+) => {
        impl<E: Emit> Nodes<E> {
            $(#[doc = concat!("The node `", stringify!($node), "`.")]
            #[inline(always)]
            pub fn $node<T: Shape<E>>(self, $first: $first_type $(, $input: $type)*) -> T {
                T::taken(self.run::<$group::$node::NodeBody<T::Port>>(nodes!(@list $first $($input)*)).reals)
            })+
        }
    };
    (@list $last:ident) => { $last };
    (@list $first:ident $($rest:ident)+) => { ($first, nodes!(@list $($rest)+)) };
}

nodes! {
    vector::normalize(input: Vector<E::Real>) -> Vector<E::Real>;
    vector::length(input: Vector<E::Real>) -> One<E::Real>;
    vector::dot(a: Vector<E::Real>, b: Vector<E::Real>) -> One<E::Real>;
    color::screen(base: Color<E::Real>, layer: Color<E::Real>) -> Color<E::Real>;
    color::overlay(base: Color<E::Real>, layer: Color<E::Real>) -> Color<E::Real>;
    color::hsv_to_rgb(hue: One<E::Real>, saturation: One<E::Real>, value: One<E::Real>) -> Color<E::Real>;
    color::combine_color(r: One<E::Real>, g: One<E::Real>, b: One<E::Real>, a: One<E::Real>) -> Color<E::Real>;
}

nodes! { generic
    arithmetic::absolute(input: T);
    arithmetic::add(a: T, b: T);
    arithmetic::divide(a: T, b: T);
    arithmetic::exponential(input: T);
    arithmetic::fraction(input: T);
    arithmetic::maximum(a: T, b: T);
    arithmetic::minimum(a: T, b: T);
    arithmetic::multiply(a: T, b: T);
    arithmetic::one_minus(input: T);
    arithmetic::power(base: T, exponent: One<E::Real>);
    arithmetic::scale(input: T, factor: One<E::Real>);
    arithmetic::sine(input: T);
    arithmetic::smooth_step(input: T, low: One<E::Real>, high: One<E::Real>);
    arithmetic::subtract(a: T, b: T);
    color::mix(weight: One<E::Real>, a: T, b: T);
    logic::select(condition: Truth<E::Mask>, if_true: T, if_false: T);
    logic::switch(index: Whole<E::Int>, case_0: T, case_1: T, case_2: T, case_3: T);
}

/// The fields of the state a body reads, one after another.
pub struct Fields<'w, W> {
    words: &'w W,
    at: usize,
}

impl<'w, W> Fields<'w, W> {
    /// From the first word on.
    pub fn new(words: &'w W) -> Self {
        Self { words, at: 0 }
    }

    #[inline(always)]
    fn advance(&mut self, width: usize) -> usize {
        self.at += width;
        self.at - width
    }

    /// The next field.
    #[inline(always)]
    pub fn number<E: Emit>(&mut self) -> One<E::Real>
    where
        W: Words<E>,
    {
        let at = self.advance(1);
        One { x: self.words.real(at) }
    }

    /// The next field.
    #[inline(always)]
    pub fn whole<E: Emit>(&mut self) -> Whole<E::Int>
    where
        W: Words<E>,
    {
        let at = self.advance(1);
        Whole(self.words.int(at))
    }

    /// The next field.
    #[inline(always)]
    pub fn truth<E: Emit>(&mut self) -> Truth<E::Mask>
    where
        W: Words<E>,
    {
        let at = self.advance(1);
        Truth(self.words.mask(at))
    }

    /// The next field.
    #[inline(always)]
    pub fn vector<E: Emit>(&mut self) -> Vector<E::Real>
    where
        W: Words<E>,
    {
        let at = self.advance(3);
        read_vector::<E>(self.words, at)
    }

    /// The next field.
    #[inline(always)]
    pub fn color<E: Emit>(&mut self) -> Color<E::Real>
    where
        W: Words<E>,
    {
        let at = self.advance(4);
        read_color::<E>(self.words, at)
    }
}
