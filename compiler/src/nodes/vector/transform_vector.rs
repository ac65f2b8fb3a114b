use crate::nodes::finite::FACTOR;
use crate::values::Literal;

node! {
    /// Where a transform takes a vector, which its translation leaves alone: `v.x X + v.y Y + v.z Z` for
    /// the rows X, Y and Z.
    transform_vector in vector,
    source "mental ray manual, mi_vector_transform",
    inputs {
        /// The vector.
        vector: vector = [0.0; 3], in FACTOR;
        /// The transform.
        transform: transform = Literal::IDENTITY, in FACTOR;
    }
    outputs {
        /// The vector there.
        result: vector;
    }
    body |e, i| Outputs { result: i.transform.vector(i.vector) }
}

#[cfg(test)]
mod tests {
    use crate::values::Literal;

    #[test]
    fn the_translation_does_not_count() {
        let rows = Literal::Transform([
            0.0, 2.0, 0.0, 0.0, //
            -1.0, 0.0, 0.0, 0.0, //
            0.0, 0.0, 1.0, 0.0, //
            10.0, 20.0, 30.0, 1.0,
        ]);
        assert_eq!(
            numbers!(vector = [1.0, 2.0, 3.0], transform = rows => result),
            [-2.0, 2.0, 3.0]
        );
    }
}
