//! The types of inputs and outputs as headers of nodes name them.
#![expect(non_camel_case_types, reason = "they are spelled as in headers and graph files")]

use crate::emit::{self, Color, Components, Emit, One, Select, Sink, Vector, Words};
use crate::values::Type;

/// The type of an input: what it is to a body, and how it lies in words. `T` is what `generic`
/// stands for.
pub trait Port: 'static {
    /// The type the checker sees.
    const TYPE: Type;
    /// Words it takes; see [`width`] for generic ones.
    const WIDTH: usize;
    /// Whether it is known before shading, and a plain number to the body.
    const FIXED: bool = false;
    /// The value a body works on.
    type Value<E: Emit, T: Copy>: Copy;
    /// Reads it from word `at` on.
    fn load<E: Emit, S: Form>(words: &impl Words<E>, at: usize) -> Self::Value<E, S::Of<E>>;
    /// The value as a body over one component has it: of a generic one the component `number`.
    fn component<E: Emit, S: Shape>(
        value: Self::Value<E, <S as Shape>::Of<E>>,
        number: usize,
    ) -> Self::Value<E, E::Real>;
}

/// The type of an output.
#[diagnostic::on_unimplemented(
    message = "no node computes a value of type `{Self}`",
    note = "counts, choices, strings, textures and lights are known before shading, and a shader is an output of \
            a node; outputs are scalar, integer, boolean, vector, color, transform or generic"
)]
pub trait Computed: Port {
    /// Writes it from word `at` on.
    fn store<E: Emit, S: Form>(sink: &mut impl Sink<E>, at: usize, value: Self::Value<E, S::Of<E>>);
}

/// What `generic` may stand for in a node that computes nothing, but chooses or compares: each
/// [`Shape`], and types that have no arithmetic of components.
pub trait Form: Computed {
    /// The value in a body.
    type Of<E: Emit>: Copy + Select<E::Mask>;
    /// Reads it from word `at` on.
    fn take<E: Emit>(words: &impl Words<E>, at: usize) -> Self::Of<E>;
    /// Writes it from word `at` on.
    fn put<E: Emit>(sink: &mut impl Sink<E>, at: usize, value: Self::Of<E>);
}

impl<S: Shape> Form for S {
    type Of<E: Emit> = <S as Shape>::Of<E>;
    #[inline(always)]
    fn take<E: Emit>(words: &impl Words<E>, at: usize) -> <S as Shape>::Of<E> {
        S::read(words, at)
    }
    #[inline(always)]
    fn put<E: Emit>(sink: &mut impl Sink<E>, at: usize, value: <S as Shape>::Of<E>) {
        S::write(sink, at, value);
    }
}

macro_rules! forms {
    ($($port:ident, $e:ident => $of:ty;)+) => {$(
        impl Form for $port {
            type Of<$e: Emit> = $of;
            #[inline(always)]
            fn take<$e: Emit>(words: &impl Words<$e>, at: usize) -> $of {
                <$port as Port>::load::<$e, $port>(words, at)
            }
            #[inline(always)]
            fn put<$e: Emit>(sink: &mut impl Sink<$e>, at: usize, value: $of) {
                <$port as Computed>::store::<$e, $port>(sink, at, value);
            }
        }
    )+};
}

forms! {
    integer, E => E::Int;
    boolean, E => E::Mask;
    transform, E => emit::Transform<E::Real>;
}

/// What `generic` stands for in a node that computes.
#[diagnostic::on_unimplemented(
    message = "`generic` does not stand for `{Self}`",
    note = "it stands for scalar, vector and color"
)]
pub trait Shape: Computed {
    /// Components that are computed: alpha is not.
    const COMPONENTS: usize;
    /// The value in a body over all components.
    type Of<E: Emit>: Components<E::Real>;
    /// Reads it from word `at` on.
    fn read<E: Emit>(words: &impl Words<E>, at: usize) -> Self::Of<E>;
    /// Writes it from word `at` on.
    fn write<E: Emit>(sink: &mut impl Sink<E>, at: usize, value: Self::Of<E>);
}

/// Words a port takes where `generic` stands for `S`.
pub const fn width<P: Port, S: Form>() -> usize {
    if matches!(P::TYPE, Type::Generic) { S::WIDTH } else { P::WIDTH }
}

/// Ports whose value is the same whatever `generic` stands for.
macro_rules! ports {
    ($($(#[doc = $doc:literal])+ $port:ident: $type:ident, $width:literal, $e:ident => $value:ty,
        $(fixed $fixed:literal,)? load |$words:ident, $at:ident| $load:expr $(, store |$sink:ident, $to:ident, $stored:ident| $store:expr)?;)+) => {$(
        $(#[doc = $doc])+
        #[derive(Debug)]
        pub enum $port {}

        impl Port for $port {
            const TYPE: Type = Type::$type;
            const WIDTH: usize = $width;
            $(const FIXED: bool = $fixed;)?
            type Value<$e: Emit, T: Copy> = $value;
            #[inline(always)]
            fn load<$e: Emit, S: Form>($words: &impl Words<$e>, $at: usize) -> $value {
                $load
            }
            #[inline(always)]
            fn component<$e: Emit, S: Shape>(value: $value, _: usize) -> $value {
                value
            }
        }

        $(impl Computed for $port {
            #[inline(always)]
            fn store<$e: Emit, S: Form>($sink: &mut impl Sink<$e>, $to: usize, $stored: $value) {
                $store
            }
        })?
    )+};
}

ports! {
    /// A number.
    scalar: Scalar, 1, E => E::Real,
        load |words, at| words.real(at), store |sink, at, value| sink.real(at, value);
    /// A whole number.
    integer: Integer, 1, E => E::Int,
        load |words, at| words.int(at), store |sink, at, value| sink.int(at, value);
    /// A truth value.
    boolean: Boolean, 1, E => E::Mask,
        load |words, at| words.mask(at), store |sink, at, value| sink.mask(at, value);
    /// Three numbers.
    vector: Vector, 3, E => Vector<E::Real>,
        load |words, at| emit::read_vector::<E>(words, at),
        store |sink, at, value| emit::write_vector(sink, at, value);
    /// A colour with alpha.
    color: Color, 4, E => Color<E::Real>,
        load |words, at| emit::read_color::<E>(words, at),
        store |sink, at, value| emit::write_color(sink, at, value);
    /// An affine map.
    transform: Transform, 16, E => emit::Transform<E::Real>,
        load |words, at| emit::read_transform::<E>(words, at),
        store |sink, at, value| write_transform(sink, at, value);
    /// Text, as its number.
    string: String, 1, E => E::Int, load |words, at| words.int(at);
    /// A picture: in the code, not in words.
    texture: Texture, 0, E => (), load |_words, _at| ();
    /// A light: in the code, not in words.
    light: Light, 0, E => (), load |_words, _at| ();
    /// Lights: in the code, not in words.
    lights: Lights, 0, E => (), load |_words, _at| ();
    /// A whole number known before shading: how often a body does something.
    count: Integer, 1, E => i32, fixed true, load |words, at| words.fixed(at);
    /// One of several names, known before shading: to the body its number, from 0.
    choice: Integer, 1, E => i32, fixed true, load |words, at| words.fixed(at);
    /// The colour of a shader that was called.
    shader: Shader, 4, E => Color<E::Real>, load |words, at| emit::read_color::<E>(words, at);
}

/// Writes four rows of four numbers, the last column that of an affine map.
#[inline(always)]
fn write_transform<E: Emit>(sink: &mut impl Sink<E>, at: usize, value: emit::Transform<E::Real>) {
    use crate::emit::Real;
    let (zero, one) = (value.x.x.same(0.0), value.x.x.same(1.0));
    emit::write_vector(sink, at, value.x);
    sink.real(at + 3, zero);
    emit::write_vector(sink, at + 4, value.y);
    sink.real(at + 7, zero);
    emit::write_vector(sink, at + 8, value.z);
    sink.real(at + 11, zero);
    emit::write_vector(sink, at + 12, value.translation);
    sink.real(at + 15, one);
}

/// The one type a generic node is used with.
#[derive(Debug)]
pub enum generic {}

impl Port for generic {
    const TYPE: Type = Type::Generic;
    const WIDTH: usize = 0;
    type Value<E: Emit, T: Copy> = T;
    #[inline(always)]
    fn load<E: Emit, S: Form>(words: &impl Words<E>, at: usize) -> S::Of<E> {
        S::take(words, at)
    }
    #[inline(always)]
    fn component<E: Emit, S: Shape>(value: <S as Shape>::Of<E>, number: usize) -> E::Real {
        value.to_words()[number]
    }
}

impl Computed for generic {
    #[inline(always)]
    fn store<E: Emit, S: Form>(sink: &mut impl Sink<E>, at: usize, value: S::Of<E>) {
        S::put(sink, at, value);
    }
}

macro_rules! shapes {
    ($($port:ident, $components:literal, $shape:ident, read |$words:ident, $at:ident| $read:expr, write |$sink:ident, $to:ident, $value:ident| $write:expr;)+) => {$(
        impl Shape for $port {
            const COMPONENTS: usize = $components;
            type Of<E: Emit> = $shape<E::Real>;
            #[inline(always)]
            fn read<E: Emit>($words: &impl Words<E>, $at: usize) -> Self::Of<E> {
                $read
            }
            #[inline(always)]
            fn write<E: Emit>($sink: &mut impl Sink<E>, $to: usize, $value: Self::Of<E>) {
                $write
            }
        }
    )+};
}

shapes! {
    scalar, 1, One, read |words, at| One { x: words.real(at) }, write |sink, at, value| sink.real(at, value.x);
    vector, 3, Vector, read |words, at| emit::read_vector::<E>(words, at), write |sink, at, value| emit::write_vector(sink, at, value);
    color, 3, Color, read |words, at| emit::read_color::<E>(words, at), write |sink, at, value| emit::write_color(sink, at, value);
}

#[cfg(test)]
mod tests {
    use super::*;

    node! {
        /// Every type there is, and those a node can compute again.
        everything in arithmetic,
        source "",
        inputs {
            /// An input.
            number: scalar = 0.0;
            /// An input.
            count: integer = 0;
            /// An input.
            truth: boolean = false;
            /// An input.
            direction: vector = [0.0; 3];
            /// An input.
            tint: color = crate::nodes::BLACK;
            /// An input.
            map: transform = crate::values::Literal::IDENTITY;
            /// An input.
            name: string = "";
            /// An input.
            picture: texture = crate::values::Literal::Texture(None);
            /// An input.
            lamps: lights = Vec::new();
            /// An input.
            shade: shader = crate::values::Literal::NoShader;
        }
        outputs {
            /// An output.
            map: transform;
            /// An output.
            tint: color;
            /// An output.
            direction: vector;
            /// An output.
            truth: boolean;
            /// An output.
            count: integer;
            /// An output.
            number: scalar;
            /// An output.
            shaded: color;
            /// An output.
            same: boolean;
        }
        body |e, i| Outputs {
            map: i.map,
            tint: i.tint,
            direction: i.direction,
            truth: i.truth,
            count: i.count,
            number: i.number,
            shaded: i.shade,
            same: {
                let ((), ()) = (i.picture, i.lamps);
                crate::emit::Int::equal(i.name, e.int(40))
            },
        }
    }

    #[test]
    fn values_pass_through_words_unchanged() {
        let definition = definition();
        let code = definition.overloads[0].code.expect("it has a body");
        let mut inputs: Vec<u32> = (1..=31).collect();
        inputs[2] = u32::MAX;
        inputs[26] = 40;
        // The last column of an affine map.
        let [zero, one] = [0.0_f32, 1.0].map(f32::to_bits);
        for (at, word) in [(13, zero), (17, zero), (21, zero), (25, one)] {
            inputs[at] = word;
        }
        let mut outputs = vec![0; code.outputs];
        code.scalar(&inputs, &mut outputs);
        let expected = [
            &inputs[10..26],
            &inputs[6..10],
            &inputs[3..6],
            &inputs[2..3],
            &inputs[1..2],
            &inputs[0..1],
            &inputs[27..31],
            &[u32::MAX],
        ];
        assert_eq!(outputs, expected.concat());
    }

    #[test]
    fn ports_are_as_wide_as_their_types() {
        macro_rules! widths {
            ($($port:ident)+) => { [$((<$port as Port>::TYPE, <$port as Port>::WIDTH)),+] };
        }
        let ports = widths!(scalar integer boolean color vector transform string texture light
            lights shader);
        assert_eq!(ports.map(|(port, _)| port), Type::ALL);
        for (port, width) in ports {
            assert_eq!(width, port.width(), "{port:?}");
        }
        assert_eq!((width::<generic, vector>(), width::<integer, vector>()), (3, 1));
    }
}
