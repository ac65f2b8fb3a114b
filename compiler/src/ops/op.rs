//! One operation, and the pure segment it stands in.

use crate::emit::Table;
use crate::storage::Source;

/// Position of an operation on its tape; operands come before.
pub type OpId = u32;

/// A constant number, in 64 bits until a back end rounds it; equal where all its bits are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Number(u64);

impl Number {
    /// The constant.
    pub const fn new(value: f64) -> Self {
        Self(value.to_bits())
    }

    /// Its value.
    pub const fn value(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// What the words of an operation's result mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Numbers.
    Real,
    /// Integers.
    Int,
    /// Truth values: all bits set, or none.
    Mask,
}

/// The [`Class`] of this name.
macro_rules! class {
    (real) => {
        $crate::ops::Class::Real
    };
    (int) => {
        $crate::ops::Class::Int
    };
    (mask) => {
        $crate::ops::Class::Mask
    };
}

/// The type of an operand, whatever its name.
macro_rules! id {
    ($operand:ident) => {
        OpId
    };
}

macro_rules! define {
    (
        operators { $($operator:ident $operator_name:literal $both:ident $trait:ident::$call:ident
            [$($operator_flag:ident)?];)+ }
        methods { $($method:ident $method_name:literal $of:ident.$calls:ident($($operand:ident: $its:ident),*)
            -> $out:ident [$($method_flag:ident)?];)+ }
        shifts { $($shift:ident $shift_calls:ident;)+ }
        words { $($word:ident $word_name:literal ($($on:ident),+) [$($word_flag:ident)?];)+ }
        functions { $($function:ident $function_calls:ident($($second:ident)?);)+ }
    ) => {
        /// One operation on words. Every variant is an operation of [`crate::emit::Emit`]; see
        /// `docs/numerics.md`.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[expect(missing_docs, reason = "each is the operation of the same name in `emit`")]
        pub enum Op {
            /// The word of a source, numbered by whoever records.
            Load(u32),
            /// These bits in every lane, whatever they mean.
            Constant(u32),
            /// A constant number. [`legalise`](super::legalise) rounds it.
            Number(Number),
            /// A constant integer.
            Integer(i32),
            /// A constant truth value.
            Truth(bool),
            /// The number of a table at a position.
            Table(Table, OpId),
            $($operator(OpId, OpId),)+
            $($method(OpId $(, id!($operand))*),)+
            /// By a constant number of bits below 32.
            $($shift(OpId, u32),)+
            $($word($(id!($on)),+),)+
            $($function(OpId $(, id!($second))?),)+
        }

        impl Op {
            /// The names of all operations, fetches aside, as their variants are called.
            pub const ALL: &[&str] = &[
                "Table",
                $(stringify!($operator),)+ $(stringify!($method),)+ $(stringify!($shift),)+
                $(stringify!($word),)+ $(stringify!($function),)+
            ];

            /// What it is called in text.
            pub const fn name(self) -> &'static str {
                match self {
                    Op::Load(..) => "load",
                    Op::Constant(..) => "constant",
                    Op::Number(..) => "number",
                    Op::Integer(..) => "integer",
                    Op::Truth(..) => "truth",
                    Op::Table(..) => "table",
                    $(Op::$operator(..) => $operator_name,)+
                    $(Op::$method(..) => $method_name,)+
                    $(Op::$shift(..) => stringify!($shift_calls),)+
                    $(Op::$word(..) => $word_name,)+
                    $(Op::$function(..) => stringify!($function_calls),)+
                }
            }

            /// What its result means; none where that is what its operands or sources mean.
            pub const fn class(self) -> Option<Class> {
                Some(match self {
                    Op::Load(..) | Op::Constant(..) => return None,
                    Op::Number(..) => Class::Real,
                    Op::Integer(..) => Class::Int,
                    Op::Truth(..) => Class::Mask,
                    Op::Table(..) => Class::Real,
                    $(Op::$operator(..) => class!($both),)+
                    $(Op::$method(..) => class!($out),)+
                    $(Op::$shift(..) => Class::Int,)+
                    $(Op::$word(..) => return None,)+
                    $(Op::$function(..) => Class::Real,)+
                })
            }

            /// Whether it is a function, which a tier expands.
            pub const fn is_function(self) -> bool {
                matches!(self, $(Op::$function(..))|+)
            }

            /// Whether its first two operands may change places.
            pub const fn is_commutative(self) -> bool {
                let flag = match self {
                    $(Op::$operator(..) => stringify!($($operator_flag)?),)+
                    $(Op::$method(..) => stringify!($($method_flag)?),)+
                    $(Op::$word(..) => stringify!($($word_flag)?),)+
                    _ => "",
                };
                !flag.is_empty()
            }

            /// The same operation on operands renamed by `rename`, which is called in operand order.
            pub fn map_operands(self, mut rename: impl FnMut(OpId) -> OpId) -> Self {
                match self {
                    Op::Load(_) | Op::Constant(_) | Op::Number(_) | Op::Integer(_) | Op::Truth(_) => self,
                    Op::Table(table, index) => Op::Table(table, rename(index)),
                    $(Op::$operator(a, b) => Op::$operator(rename(a), rename(b)),)+
                    $(Op::$method(a $(, $operand)*) => Op::$method(rename(a) $(, rename($operand))*),)+
                    $(Op::$shift(a, bits) => Op::$shift(rename(a), bits),)+
                    $(Op::$word($($on),+) => Op::$word($(rename($on)),+),)+
                    $(Op::$function(a $(, $second)?) => Op::$function(rename(a) $(, rename($second))?),)+
                }
            }
        }
    };
}
operations! {define}

impl Op {
    /// Calls `visit` with every operand, in order.
    pub fn for_each_operand(self, mut visit: impl FnMut(OpId)) {
        self.map_operands(|id| {
            visit(id);
            id
        });
    }

    /// The same with the operands of a commutative operation in order, so that value numbering finds
    /// it however it was written.
    #[must_use]
    pub fn in_order(self) -> Self {
        if !self.is_commutative() {
            return self;
        }
        let (mut first, mut count) = ([0; 2], 0);
        self.for_each_operand(|id| {
            if count < 2 {
                first[count] = id;
            }
            count += 1;
        });
        first.sort_unstable();
        let mut first = first.into_iter();
        self.map_operands(|id| first.next().unwrap_or(id))
    }

    /// Whether it only fetches a word: cheaper to repeat than to keep.
    pub fn is_fetch(self) -> bool {
        matches!(
            self,
            Op::Load(_) | Op::Constant(_) | Op::Number(_) | Op::Integer(_) | Op::Truth(_)
        )
    }
}

/// A pure piece of a shader program: what is computed between two requests.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct OpSegment {
    /// The operations; operands come before their users.
    pub ops: Vec<Op>,
    /// What [`Op::Load`] reads: `Load(n)` is `sources[n]`.
    pub sources: Vec<Source>,
    /// The slots written, and with what. All loads happen before the first store.
    pub stores: Vec<(u32, OpId)>,
    /// Masks, read before all else: a lane wants the segment where all of them hold; without any, all do.
    /// A block in which no lane does is left as it is; in others, what lanes get that do not want it is
    /// open, for nobody may show it.
    pub wanted: Vec<Source>,
}
