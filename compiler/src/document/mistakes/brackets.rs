//! Which brackets are missing or too many. Where they do not come out even, indentation says where: a
//! line that stands further out than it should follows one that is missing, a line that stands further
//! in follows one too many. Indentation is believed only as far as the brackets need it.

use super::corrections::Corrections;
use super::lexer::{Kind, Lexer};
use super::matching::Matching;

/// Deepest nesting that is followed.
const DEEPEST: usize = 128;

/// Most brackets too many that are looked for beside as many that are missing.
const MOST_PAIRS: usize = 4;

/// Most brackets of a file that are matched to tell which is missing or too many: what is kept of each is some dozens of
/// bytes.
pub const MAX_BRACKETS: usize = 1 << 20;

/// Finds how the brackets of a text are to be read.
pub(super) fn corrections(text: &str) -> Corrections {
    let mut lexer = Lexer::new(text, true);
    let (mut opened, mut closed, mut deepest) = (0_usize, 0_usize, 0_usize);
    while let Some(token) = lexer.next() {
        match token.kind {
            Kind::Open(_) => opened += 1,
            Kind::Close(_) => closed += 1,
            _ => {}
        }
        deepest = deepest.max(opened.saturating_sub(closed));
    }
    if lexer.is_full() || deepest > DEEPEST || opened + closed > MAX_BRACKETS {
        return Corrections { given_up: true, ..Corrections::default() };
    }
    let missing = opened.saturating_sub(closed);
    let extra = closed.saturating_sub(opened);
    let by_lines = Matching::of(text, missing, extra, false);
    if by_lines.overrun {
        // They come out even, but one is too many before one is missing.
        for more in 1..=MOST_PAIRS {
            let pairs = Matching::of(text, missing + more, extra + more, false);
            if pairs.is_solved() {
                return pairs.finish();
            }
        }
    }
    if by_lines.missing > 0 {
        // A file without indentation may still say by its keys where it is.
        let by_keys = Matching::of(text, missing, extra, true);
        if by_keys.missing < by_lines.missing {
            return by_keys.finish();
        }
    }
    by_lines.finish()
}
