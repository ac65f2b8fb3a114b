//! Paths in addresses.

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_encode};

/// What is escaped in a path.
const ESCAPED: &AsciiSet =
    &NON_ALPHANUMERIC.remove(b'/').remove(b'-').remove(b'.').remove(b'_').remove(b'~');

/// The bytes of a path as an address has them.
pub fn escaped(path: &[u8]) -> String {
    percent_encode(path, ESCAPED).to_string()
}
