//! The keys of what phenomena offer and of colours: sections that hold no others.

use crate::document::{Given, Key, Kind, Section};
use crate::values::{ColorSpace, Type};

/// A key that goes with all types.
pub(super) const fn key(name: &'static str, kind: Kind, given: Given, doc: &'static str) -> Key {
    Key { name, kind, only: &[], given, unit: "", doc }
}

/// What editors keep.
pub(super) const EDITOR: Key = key(
    "editor",
    Kind::Anything,
    Given::Optional,
    "Whatever editors keep here; it changes nothing",
);
/// The names of the types of outputs.
const COMPUTED: [&str; Type::COMPUTED.len()] = {
    let mut names = [""; Type::COMPUTED.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = Type::COMPUTED[at].name();
        at += 1;
    }
    names
};

/// A value that a phenomenon offers.
pub static OUTPUT: Section = Section {
    name: "output",
    what: "an output",
    keys: &[
        key("type", Kind::Word(&COMPUTED), Given::Required, "What its values are"),
        key(
            "from",
            Kind::Value { text: "value or connection", definition: "output_value" },
            Given::Required,
            "Where it comes from, of that type",
        ),
        key("doc", Kind::Text, Given::Optional, "What it means"),
        EDITOR,
    ],
    one_of: &[],
};

const ENCODED: Kind = Kind::Value {
    text: "`\"#ff8000\"`, `\"#f80\"`, `\"#ff8000cc\"`, or three or four numbers of 0 to 1",
    definition: "encoded_color",
};
const LIGHT: Kind = Kind::Value { text: "three or four numbers", definition: "linear_color" };

/// A colour of another space.
pub static COLOR: Section = Section {
    name: "color",
    what: "a colour",
    keys: &[
        key("srgb", ENCODED, Given::Choice, "sRGB"),
        key("srgb_texture", ENCODED, Given::Choice, "The same"),
        key("g22_rec709", ENCODED, Given::Choice, "Rec. 709 to the power of 2.2"),
        key("g18_rec709", ENCODED, Given::Choice, "Rec. 709 to the power of 1.8"),
        key(
            "rec709_display",
            ENCODED,
            Given::Choice,
            "Rec. 709 as displays show it, to the power of 2.4",
        ),
        key("lin_rec709", LIGHT, Given::Choice, "Linear Rec. 709: what `[r, g, b]` is too"),
        key("lin_srgb", LIGHT, Given::Choice, "The same"),
        key("acescg", LIGHT, Given::Choice, "ACEScg: linear AP1"),
        key("lin_ap1", LIGHT, Given::Choice, "The same"),
        key("g22_ap1", ENCODED, Given::Choice, "AP1 to the power of 2.2"),
        key("g18_ap1", ENCODED, Given::Choice, "AP1 to the power of 1.8"),
        key("adobergb", ENCODED, Given::Choice, "Adobe RGB"),
        key("lin_adobergb", LIGHT, Given::Choice, "Adobe RGB, linear"),
        key("srgb_displayp3", ENCODED, Given::Choice, "Display P3"),
        key("lin_displayp3", LIGHT, Given::Choice, "Display P3, linear"),
    ],
    one_of: &SPACES,
};

const SPACES: [&str; ColorSpace::ALL.len()] = {
    let mut names = [""; ColorSpace::ALL.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = ColorSpace::ALL[at].name;
        at += 1;
    }
    names
};
