node! {
    /// Calls a shader for its colour, here and now: under the scopes and in the loop round this node, and
    /// only where its colour is wanted. Where no shader is given the colour is transparent black.
    call_shader in rays,
    source "mental ray manual, mi_call_shader",
    inputs {
        /// The shader.
        shader: shader = crate::values::Literal::NoShader;
    }
    outputs {
        /// Its colour.
        color: color;
    }
    body |e, i| Outputs { color: i.shader }
}

#[cfg(test)]
mod tests {
    #[test]
    fn yields_what_the_shader_does() {
        let definition = super::definition();
        let code = definition.overloads[0].code.expect("it has a body");
        let words = [0x8000_0000, 1, 0x7f80_0000, 0x3f80_0000];
        let mut color = [0; 4];
        code.scalar(&words, &mut color);
        assert_eq!(color, words);
        assert_eq!(numbers!( => color), [0.0; 4]);
    }
}
