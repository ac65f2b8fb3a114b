//! What must not change while the house is rebuilt: the bits of small pictures of everything that is
//! shipped, the rays they took, the digits of every node, and every finding. The program is run, so that
//! this holds whatever its libraries are called.
//!
//! `PHENOMENON_BLESS=1 cargo test --workspace --test checksums` writes the lists anew; do so only where a
//! change is meant to alter what a user sees, and read what changed before committing it.

mod files;
mod findings;
mod ledger;
mod pictures;
mod program;
mod values;
