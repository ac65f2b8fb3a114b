//! Only the effects a scene calls for: what a ledger says is what is done, and no more.

mod all_on;
mod counted;
mod linking;
mod reasons;
