//! What the nodes of a scene claim.

use std::sync::Arc;

use phenomenon_compiler::diagnostics::listed;
use phenomenon_compiler::engine::{Shader, ShaderError};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::specialise::{Account, Needed, Part};
use phenomenon_compiler::state::RayType;

use super::row::Asked;
use crate::link::materials::ShaderUse;
use crate::link::uncompilable::place_of_node;
use crate::render::Entry;

/// A graph of the scene, with what its roots ask for.
pub(super) struct Graph<'l> {
    pub name: &'l str,
    pub used: &'l ShaderUse,
    pub accounts: Vec<Account>,
}

/// A node that asks for something, in one root of one graph.
#[derive(Clone, Copy)]
pub(super) struct Claim<'b> {
    pub graph: &'b Graph<'b>,
    pub account: &'b Account,
    pub part: &'b Part,
    pub entry: Entry,
}

impl<'l> Graph<'l> {
    /// The graphs of a scene, each use that differs once.
    pub fn all(
        shaders: &'l [Arc<Shader>],
        uses: &'l [ShaderUse],
    ) -> Result<Vec<Self>, ShaderError> {
        let graph = |(shader, used): (&'l Arc<Shader>, &'l ShaderUse)| {
            let called = |account: &Account| match used.root {
                RootKind::Environment => account.root == RootKind::Environment,
                _ => account.root != RootKind::Environment,
            };
            let accounts = shader.accounts()?.into_iter().filter(called).collect();
            Ok(Self { name: &shader.graph().name, used, accounts })
        };
        shaders.iter().zip(uses).map(graph).collect()
    }

    /// All that its nodes claim.
    pub fn claims(&self) -> impl Iterator<Item = Claim<'_>> {
        self.accounts.iter().flat_map(move |account| {
            account.parts.iter().filter_map(move |part| {
                let entry = entry(part)?;
                Some(Claim { graph: self, account, part, entry })
            })
        })
    }
}

fn entry(part: &Part) -> Option<Entry> {
    match part.needed {
        Needed::Request(effect) => Some(effect.into()),
        Needed::Turns(iterated) => Some(iterated.into()),
        Needed::Field(field) => Entry::of_field(field),
    }
}

impl Claim<'_> {
    /// The node that asks.
    pub fn asked(&self) -> Asked {
        let node = &self.part.node;
        Asked {
            graph: self.graph.name.to_owned(),
            node: node.name.clone(),
            node_type: node.node_type.clone(),
            place: place_of_node(&self.graph.used.document, &node.name),
        }
    }

    /// The root in which it asks, in words: the material root of `advanced_glass`.
    pub fn root(&self) -> String {
        let graph = listed([self.graph.name]);
        format!("the {} root of {graph}", self.account.root.name())
    }

    /// The node in the file of its graph: all uses of the file have it in common, all its roots and ray types.
    pub fn node(&self) -> (&str, &str) {
        (&self.graph.used.document.file.name, &self.part.node.name)
    }

    /// The ray type it asks for; none where it does for all.
    pub fn ray_type(&self) -> Option<RayType> {
        self.account.ray_type
    }
}
