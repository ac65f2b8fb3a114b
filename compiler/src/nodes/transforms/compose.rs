use crate::emit::Transform;
use crate::nodes::finite::FACTOR;
use crate::values::Literal;

node! {
    /// One transform after another: what it does to a point is what `second` does to where
    /// `first` takes it. Points are rows, so as matrices it is `first second`.
    compose in transforms,
    source "",
    inputs {
        /// What is done first.
        first: transform = Literal::IDENTITY, in FACTOR;
        /// What is done then.
        second: transform = Literal::IDENTITY, in FACTOR;
    }
    outputs {
        /// Both.
        result: transform;
    }
    body |e, i| {
        let second = i.second;
        let result = Transform {
            x: second.vector(i.first.x),
            y: second.vector(i.first.y),
            z: second.vector(i.first.z),
            translation: second.point(i.first.translation),
        };
        Outputs { result }
    }
}

#[cfg(test)]
mod tests {
    use crate::values::Literal;

    #[test]
    fn the_first_is_done_first() {
        let doubled = Literal::Transform([
            2.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0,
        ]);
        let moved = Literal::Transform([
            1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 2.0, 3.0, 1.0,
        ]);
        let both = numbers!(first = moved.clone(), second = doubled.clone() => result);
        assert_eq!(both[12..], [2.0, 4.0, 6.0, 1.0]);
        let both = numbers!(first = doubled, second = moved => result);
        assert_eq!(both[12..], [1.0, 2.0, 3.0, 1.0]);
        assert_eq!(both[..4], [2.0, 0.0, 0.0, 0.0]);
    }
}
