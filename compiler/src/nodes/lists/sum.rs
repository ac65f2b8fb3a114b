use crate::nodes::finite::SUMMAND;
use crate::nodes::{Kind, ListForm, required};

node! {
    #[doc = "The sum of a list, from the first value to the last, each sum rounded; a colour has the \
             alpha of the first. As `add` nodes in a row."]
    sum in lists structural [Kind::List(ListForm::Sum)],
    source "",
    inputs {
        /// The values, all of one type.
        values: generic = required(), in SUMMAND, list;
    }
    outputs {
        /// The sum.
        result: generic;
    }
}
