//! What makes a node a map or a fold, and what its turns are given.

use crate::document::Value;

/// How the turns of a node become values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A list of what each turn yields.
    Map,
    /// What the last turn yields, each being handed what the one before did.
    Fold,
}

impl Form {
    /// All there are.
    pub const ALL: [Form; 2] = [Form::Map, Form::Fold];

    /// The one of this name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|form| form.name() == name)
    }

    /// The key of it in the type of a node.
    pub const fn name(self) -> &'static str {
        match self {
            Form::Map => "map",
            Form::Fold => "fold",
        }
    }
}

/// The input with the list that is gone through.
pub const OVER: &str = "over";
/// The input with what the first turn of a fold is handed.
pub const INITIAL: &str = "initial";
/// The parameter of the body that has the value of the turn.
pub const ITEM: &str = "item";
/// The parameter of the body that has the number of the turn, if it has it.
pub const INDEX: &str = "index";
/// The parameter of the body of a fold that has what the turn before yielded.
pub const ACCUMULATED: &str = "accumulated";

/// The form and the body of a node of that type; none of any other type.
pub fn form_of(node_type: &Value) -> Option<(Form, &Value)> {
    Form::ALL.into_iter().find_map(|form| Some((form, node_type.get(form.name())?)))
}

/// The name in the file of a node that is a turn.
pub fn written_name(turn: &str) -> &str {
    turn.rfind('[').map_or(turn, |at| &turn[..at])
}
