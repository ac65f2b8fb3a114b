use crate::emit::Color;
use crate::nodes::{BLACK, NOT_NEGATIVE, required};

node! {
    /// Evaluates `second` with the colour of `first` as the state's `incoming`: the way the shaders of
    /// a list in a root hand their colour on. Nodes that read `incoming`, directly or through others,
    /// are evaluated anew; all others are shared with the outside.
    chain in scopes scope [Incoming],
    source "mental ray manual, shader lists; mi_call_shader with the result of the call before",
    inputs {
        /// The colour handed on.
        first: color = required();
    }
    scoped {
        /// What becomes of it.
        second: color = BLACK, in NOT_NEGATIVE;
    }
    changes { incoming: color; }
    outputs {
        /// The value of `second`.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let Color { r, g, b, a } = i.first;
        Changes { incoming: Color { r, g, b, a } }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::Kind;
    use crate::state::Field;
    use crate::values::Literal;

    #[test]
    fn hands_the_color_on_to_the_bit() {
        let definition = super::definition();
        assert_eq!(definition.signature.kind, Kind::Scope(vec![Field::Incoming]));
        let code = definition.overloads[0].code.expect("a scope has a body");
        let first = Literal::Color([-0.0, 1e-45, f32::INFINITY, f32::MAX]).words();
        let mut inputs = first.clone();
        inputs.resize(8, 0);
        let mut incoming = [0; 4];
        code.scalar(&inputs, &mut incoming);
        assert_eq!(incoming.as_slice(), first);
    }
}
