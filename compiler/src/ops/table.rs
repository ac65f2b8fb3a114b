//! The one table of operations.

/// Hands the table to a macro, section by section:
///
/// * `operators`: variant, name, class of operands and result, trait and method of `std::ops`;
/// * `methods`: variant, name, method of [`Real`](crate::emit::Real) or [`Int`](crate::emit::Int) with the
///   class of the operand it is called on, its further operands, and the result;
/// * `shifts`: variant and method of [`Int`](crate::emit::Int), by a constant;
/// * `words`: variant, name and operands of what works on bits, whatever they mean;
/// * `functions`: variant and method of [`Real`](crate::emit::Real) that a tier expands.
///
/// `commutative` is said of the first two operands.
#[doc(hidden)]
#[macro_export]
macro_rules! operations {
    ($then:ident) => {
        $then! {
            operators {
                Add "add" real Add::add [commutative];
                Sub "sub" real Sub::sub [];
                Mul "mul" real Mul::mul [commutative];
                Div "div" real Div::div [];
                IntAdd "int_add" int Add::add [commutative];
                IntSub "int_sub" int Sub::sub [];
                IntMul "int_mul" int Mul::mul [commutative];
            }
            methods {
                Neg "neg" real.neg() -> real [];
                MulAdd "mul_add" real.mul_add(factor: real, addend: real) -> real [commutative];
                Minimum "minimum" real.minimum(other: real) -> real [];
                Maximum "maximum" real.maximum(other: real) -> real [];
                Absolute "absolute" real.absolute() -> real [];
                Sqrt "sqrt" real.sqrt() -> real [];
                Floor "floor" real.floor() -> real [];
                Ceil "ceil" real.ceil() -> real [];
                Truncate "truncate" real.truncate() -> real [];
                RoundEven "round_even" real.round_even() -> real [];
                Less "less" real.less(other: real) -> mask [];
                LessEqual "less_equal" real.less_equal(other: real) -> mask [];
                Equal "equal" real.equal(other: real) -> mask [commutative];
                NotEqual "not_equal" real.not_equal(other: real) -> mask [commutative];
                ToInt "to_int" real.to_int() -> int [];
                IntEqual "int_equal" int.equal(other: int) -> mask [commutative];
                IntLess "int_less" int.less(other: int) -> mask [];
                ToReal "to_real" int.to_real() -> real [];
            }
            shifts {
                ShiftLeft shift_left;
                ShiftRight shift_right;
                ShiftRightSigned shift_right_signed;
            }
            words {
                And "and" (a, b) [commutative];
                Or "or" (a, b) [commutative];
                Xor "xor" (a, b) [commutative];
                Not "not" (a) [];
                Select "select" (mask, if_true, if_false) [];
            }
            functions {
                Sin sin();
                Cos cos();
                Tan tan();
                Asin asin();
                Acos acos();
                Atan atan();
                Atan2 atan2(x);
                Exp exp();
                Exp2 exp2();
                Expm1 expm1();
                Sinh sinh();
                Cosh cosh();
                Tanh tanh();
                Ln ln();
                Log2 log2();
                Log1p log1p();
                Pow pow(exponent);
            }
        }
    };
}
