//! A mistake, before it is a finding.

/// Most mistakes of JSON that are told of one file.
pub const MAX_MISTAKES: usize = 1_000;

/// A mistake by bytes of the text.
#[derive(Clone, Debug)]
pub(super) struct Mistake {
    pub start: usize,
    pub end: usize,
    pub message: String,
    pub help: String,
    /// What to put in its place, where nothing else can be meant.
    pub fix: Option<String>,
    pub related: Vec<(usize, usize, String)>,
}

impl Mistake {
    pub fn new(
        (start, end): (usize, usize),
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        let (message, help) = (message.into(), help.into());
        Self { start, end, message, help, fix: None, related: Vec::new() }
    }

    pub fn fixed_by(mut self, text: impl Into<String>) -> Self {
        self.fix = Some(text.into());
        self
    }

    pub fn with(mut self, (start, end): (usize, usize), message: impl Into<String>) -> Self {
        self.related.push((start, end, message.into()));
        self
    }
}
