use crate::nodes::{Kind, ListForm, required};

node! {
    #[doc = "One value of a list by its number, counted from 0; only the one chosen is evaluated, and \
             it passes unchanged to the bit. A number outside the list takes the nearest value. The \
             values are of any type that nodes compute. As `select` nodes in a row."]
    element in lists structural [Kind::List(ListForm::Element)],
    source "",
    inputs {
        /// Which one.
        index: integer = 0;
        /// The values, all of one type.
        values: generic = required(), list;
    }
    outputs {
        /// The value chosen, with its alpha.
        result: generic;
    }
}
