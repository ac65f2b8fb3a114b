//! The types of values.

/// The type of an input, an output or an interface parameter. Arrays and structs have none: the
/// checker takes them apart, so that each of their parts is of one of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// True or false.
    Boolean,
    /// 32-bit signed integer.
    Integer,
    /// 32-bit floating point number.
    Scalar,
    /// Scene-linear Rec. 709 red, green, blue, and alpha.
    Color,
    /// Three numbers.
    Vector,
    /// A 4×4 matrix, row by row; points are rows, so the translation is the last row.
    Transform,
    /// Text; uniform, never computed.
    String,
    /// A picture; uniform, never computed.
    Texture,
    /// A light of the scene by name; uniform, never computed.
    Light,
    /// A list of lights by name; uniform, never computed.
    Lights,
    /// A shader that is called for its colour: an output of a node, not its value.
    Shader,
    /// The one type a generic node is used with: scalar, vector or color, in some nodes others.
    Generic,
}

impl Type {
    /// Every type a parameter or a part of one may have.
    pub const ALL: [Type; 11] = [
        Type::Scalar,
        Type::Integer,
        Type::Boolean,
        Type::Color,
        Type::Vector,
        Type::Transform,
        Type::String,
        Type::Texture,
        Type::Light,
        Type::Lights,
        Type::Shader,
    ];

    /// Number of 32-bit words; none for what is not a value of a point.
    pub const fn width(self) -> usize {
        match self {
            Type::Boolean | Type::Integer | Type::Scalar | Type::String => 1,
            Type::Vector => 3,
            Type::Color | Type::Shader => 4,
            Type::Transform => 16,
            Type::Texture | Type::Light | Type::Lights | Type::Generic => 0,
        }
    }

    /// The types whose values nodes compute, which is what [`Type::Generic`] stands for in nodes that choose.
    pub const COMPUTED: [Type; 6] =
        [Type::Scalar, Type::Integer, Type::Boolean, Type::Color, Type::Vector, Type::Transform];

    /// What [`Type::Generic`] stands for where a node does not say.
    pub const GENERIC: [Type; 3] = [Type::Scalar, Type::Vector, Type::Color];

    /// The name in graph files.
    pub const fn name(self) -> &'static str {
        match self {
            Type::Boolean => "boolean",
            Type::Integer => "integer",
            Type::Scalar => "scalar",
            Type::Color => "color",
            Type::Vector => "vector",
            Type::Transform => "transform",
            Type::String => "string",
            Type::Texture => "texture",
            Type::Light => "light",
            Type::Lights => "lights",
            Type::Shader => "shader",
            Type::Generic => "scalar | vector | color",
        }
    }

    /// Whether it is the same for all points: given by a literal or a parameter, never by a node.
    pub fn is_uniform(self) -> bool {
        matches!(self, Type::String | Type::Texture | Type::Light | Type::Lights)
    }

    /// Whether the engines have it in their code rather than in words: another value is other code.
    pub fn is_in_code(self) -> bool {
        matches!(self, Type::Texture | Type::Light | Type::Lights)
    }

    /// Whether its values are numbers that may have a range.
    pub fn is_numeric(self) -> bool {
        matches!(self, Type::Integer | Type::Scalar | Type::Color | Type::Vector | Type::Generic)
    }

    /// Whether a value of this type is converted without a node: integer to scalar, scalar (or
    /// integer) to color, a light to a list of one, the color of a node (or what becomes one) to the shader
    /// that makes it.
    pub fn converts_to(self, to: Type) -> bool {
        self == to
            || matches!(
                (self, to),
                (Type::Integer, Type::Scalar | Type::Color)
                    | (Type::Scalar, Type::Color)
                    | (Type::Light, Type::Lights)
                    | (Type::Integer | Type::Scalar | Type::Color, Type::Shader)
            )
    }
}
