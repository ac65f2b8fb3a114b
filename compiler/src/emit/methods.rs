//! The functions as methods of back ends.

/// Inside an implementation of [`Real`] by a type that has [`Bits`]: the functions, as the standard
/// tier expands them.
macro_rules! standard_functions {
    () => {
        standard_functions! {
            sin() cos() tan() asin() acos() atan() atan2(x) exp() exp2() expm1() sinh() cosh() tanh()
            ln() log2() log1p() pow(exponent)
        }
    };
    ($($function:ident($($second:ident)?))+) => {$(
        #[inline(always)]
        fn $function(self $(, $second: Self)?) -> Self {
            $crate::emit::standard::$function(self $(, $second)?)
        }
    )+};
}
pub(crate) use standard_functions;
