//! The node `twice`.

use phenomenon_compiler::node;

node! {
    /// A whole number, twice.
    twice in foreign,
    source "",
    inputs {
        /// The number.
        number: integer = 0;
    }
    outputs {
        /// Its double.
        result: integer;
    }
    body |e, i| Outputs { result: i.number + i.number }
}
