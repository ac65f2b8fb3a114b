use crate::emit::Transform;
use crate::emit::functions::rotation::diagonal;

node! {
    /// The transform that moves points and leaves vectors alone.
    translation in transforms,
    source "",
    inputs {
        /// Where the origin goes.
        offset: vector = [0.0; 3];
    }
    outputs {
        /// The transform.
        transform: transform;
    }
    body |e, i| {
        let one = diagonal(e, e.real(1.0), e.real(1.0), e.real(1.0));
        Outputs { transform: Transform { translation: i.offset, ..one } }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_last_row_is_the_offset() {
        let rows = numbers!(offset = [7.0, 8.0, 9.0] => transform);
        assert_eq!(rows[..6], [1.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
        assert_eq!(rows[12..], [7.0, 8.0, 9.0, 1.0]);
    }
}
