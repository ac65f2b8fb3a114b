//! How a socket looks.

/// How a socket looks, besides its type.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    /// Evaluated only where needed.
    pub hollow: bool,
    /// Evaluated in a scope.
    pub double: bool,
    /// Nothing is connected.
    pub small: bool,
}

impl Look {
    /// A connected socket with nothing else to say.
    pub fn plain() -> Self {
        Self { hollow: false, double: false, small: false }
    }
}
