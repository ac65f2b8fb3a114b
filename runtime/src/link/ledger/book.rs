//! Joining what nodes claim to rows.

use std::collections::{BTreeSet, HashSet};
use std::sync::Arc;

use phenomenon_compiler::engine::{Shader, ShaderError};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::RayType;
use phenomenon_compiler::values::Texture;

use super::claim::{Claim, Graph};
use super::reach::{Reach, Refusal};
use super::row::{Asked, Bytes, Row};
use super::words;
use crate::link::materials::ShaderUse;
use crate::render::{Cost, Costs, Entry};
use crate::scene::Scene;

/// What a scene calls for, and what not.
#[derive(Clone, Debug)]
pub struct Ledger {
    /// A row for each effect, in the order of [`Entry::ALL`]; textures have one each.
    pub rows: Vec<Row>,
}

impl Ledger {
    /// Looks through the graphs of a scene: its shaders, each with where it is used.
    ///
    /// # Errors
    /// None, for graphs that were compiled.
    pub fn of(
        scene: &Scene,
        shaders: &[Arc<Shader>],
        uses: &[ShaderUse],
    ) -> Result<Self, ShaderError> {
        let graphs = Graph::all(shaders, uses)?;
        let reach = Reach::of(scene, &graphs);
        let book = Book { scene, graphs: &graphs, reach };
        Ok(Self { rows: Entry::ALL.into_iter().flat_map(|entry| book.rows(entry)).collect() })
    }

    /// What a row cost a rendering of a scene.
    pub fn cost(row: &Row, scene: &Scene, costs: &Costs) -> (Cost, Bytes) {
        let mut cost = costs.of(row.entry);
        let bytes = match row.entry {
            Entry::Texture => {
                let file = row.file.as_ref();
                let of_file = |(_, (texture, ..)): &(usize, (&Texture, u64, u64))| {
                    file == Some(&texture.file)
                };
                let opened = || scene.textures.opened().enumerate().filter(of_file);
                // The time went into all of them, by their lookups.
                let all = cost.count.max(1) as f64;
                cost.count = opened().map(|(number, _)| costs.lookups(number)).sum();
                cost.milliseconds *= cost.count as f64 / all;
                opened().map(|(_, (_, bytes, _))| bytes).sum()
            }
            Entry::TextureLevels => scene.textures.opened().map(|(.., coarser)| coarser).sum(),
            Entry::Tree => {
                cost.milliseconds = scene.tree_milliseconds;
                scene.tree.bytes()
            }
            _ => 0,
        };
        (cost, Bytes(bytes))
    }
}

/// A scene whose claims are joined.
struct Book<'l> {
    scene: &'l Scene,
    graphs: &'l [Graph<'l>],
    reach: Reach<'l>,
}

impl Book<'_> {
    fn rows(&self, entry: Entry) -> Vec<Row> {
        match entry {
            Entry::Texture => self.textures(),
            Entry::TextureLevels => {
                let claims = self.claims(Entry::Texture).filter(|claim| claim.part.filtered);
                vec![self.row(entry, claims.collect())]
            }
            Entry::Coordinates => {
                // Where a mesh has no second set, the first stands for it.
                let second = self.claims(Entry::SecondCoordinates);
                vec![self.row(entry, self.claims(entry).chain(second).collect())]
            }
            Entry::Environment => vec![self.environment()],
            Entry::EnvironmentShader => vec![self.environment_shader()],
            Entry::ShadowShaders => vec![self.shadow_shaders()],
            Entry::Tree => {
                let count = self.scene.primitive_count();
                let reason = match count {
                    0 => words::nobody(entry).to_owned(),
                    1 => "rays look for 1 surface".to_owned(),
                    count => format!("rays look for the nearest of {count} surfaces"),
                };
                vec![fact(entry, count > 0, reason)]
            }
            Entry::Motion => vec![self.motion()],
            _ => vec![self.row(entry, self.claims(entry).collect())],
        }
    }

    /// What is claimed of an entry.
    fn claims(&self, entry: Entry) -> impl Iterator<Item = Claim<'_>> {
        self.graphs.iter().flat_map(Graph::claims).filter(move |claim| claim.entry == entry)
    }

    /// A row by what nodes claim.
    fn row(&self, entry: Entry, claims: Vec<Claim<'_>>) -> Row {
        let effective = |claim: &&Claim<'_>| self.reach.refusal(claim).is_none();
        if let Some(first) = claims.iter().find(effective) {
            let asking = || claims.iter().filter(effective);
            let ray_types: BTreeSet<RayType> = asking()
                .filter(|claim| claim.node() == first.node())
                .filter_map(Claim::ray_type)
                .collect();
            let nodes: HashSet<(&str, &str)> = asking().map(Claim::node).collect();
            let reason = words::asks(entry, first, &ray_types, nodes.len() - 1);
            return Row { entry, file: None, asked: Some(first.asked()), on: true, reason };
        }
        // A condition tells more than that there is no connection.
        let refused = claims.iter().filter_map(|claim| Some((claim, self.reach.refusal(claim)?)));
        match refused.min_by_key(|(claim, refusal)| rank(claim, *refusal)) {
            Some((claim, refusal)) => {
                let likewise = match words::depends_on_ray_type(claim, refusal) {
                    true => other_ray_types(&claims, claim),
                    false => BTreeSet::new(),
                };
                let reason = words::refused(claim, refusal, &likewise);
                Row { entry, file: None, asked: Some(claim.asked()), on: false, reason }
            }
            None => fact(entry, false, words::nobody(entry).to_owned()),
        }
    }

    /// A row for each file that a node names.
    fn textures(&self) -> Vec<Row> {
        let claims: Vec<Claim<'_>> = self.claims(Entry::Texture).collect();
        let mut files: Vec<&str> = Vec::new();
        for texture in claims.iter().filter_map(|claim| claim.part.texture.as_ref()) {
            if !files.contains(&texture.file.as_str()) {
                files.push(&texture.file);
            }
        }
        if files.is_empty() {
            return vec![self.row(Entry::Texture, claims)];
        }
        let row = |file: &str| {
            let is_of = |claim: &&Claim<'_>| {
                claim.part.texture.as_ref().is_some_and(|texture| texture.file == file)
            };
            let of_file = claims.iter().filter(is_of).copied().collect();
            Row { file: Some(file.to_owned()), ..self.row(Entry::Texture, of_file) }
        };
        files.into_iter().map(row).collect()
    }

    fn environment(&self) -> Row {
        let entry = Entry::Environment;
        let row = self.row(entry, self.claims(entry).collect());
        match self.scene.environment {
            Some(_) if !row.on => {
                fact(entry, true, "rays that leave the scene see its environment".into())
            }
            _ => row,
        }
    }

    fn environment_shader(&self) -> Row {
        let entry = Entry::EnvironmentShader;
        let graph = self.graphs.iter().find(|graph| graph.used.root == RootKind::Environment);
        match (graph, &self.scene.environment) {
            (Some(graph), _) => {
                let called = !graph.accounts.is_empty();
                let reason = match called {
                    true => format!("the environment of the scene is the graph `{}`", graph.name),
                    false => format!(
                        "`{}` has no environment root: what leaves the scene sees black",
                        graph.name
                    ),
                };
                fact(entry, called, reason)
            }
            (None, Some(_)) => {
                let reason =
                    "the environment of the scene is no graph: a colour, a gradient or a picture";
                fact(entry, false, reason.into())
            }
            (None, None) => fact(entry, false, words::nobody(entry).to_owned()),
        }
    }

    fn shadow_shaders(&self) -> Row {
        let entry = Entry::ShadowShaders;
        let shadowed = |graph: &&Graph<'_>| {
            graph.used.root == RootKind::Material
                && graph.accounts.iter().any(|account| account.root == RootKind::Shadow)
        };
        let Some(graph) = self.graphs.iter().find(shadowed) else {
            return fact(entry, false, words::nobody(entry).to_owned());
        };
        let name = graph.name;
        let reason = match self.reach.shadows() {
            true => format!("the shadow root of `{name}` says what passes on the way to a light"),
            false => format!("no shadow ray is cast that could meet the shadow root of `{name}`"),
        };
        fact(entry, self.reach.shadows(), reason)
    }

    /// Nothing moves yet; who reads the time is told so.
    fn motion(&self) -> Row {
        let row = self.row(Entry::Motion, self.claims(Entry::Motion).collect());
        match row.on {
            true => {
                let reason =
                    format!("nothing in a scene moves, so time is 0 everywhere; {}", row.reason);
                Row { on: false, reason, ..row }
            }
            false => row,
        }
    }
}

/// The other types of ray for which the node of a claim is left out because of the type of the ray.
fn other_ray_types(claims: &[Claim<'_>], of: &Claim<'_>) -> BTreeSet<RayType> {
    let likewise = |claim: &&Claim<'_>| {
        claim.node() == of.node() && words::depends_on_ray_type(claim, Refusal::Folded)
    };
    let ray_types = claims.iter().filter(likewise).filter_map(Claim::ray_type);
    ray_types.filter(|ray_type| Some(*ray_type) != of.ray_type()).collect()
}

/// Which reason is told first: a condition that holds for all rays before one that holds for some.
fn rank(claim: &Claim<'_>, refusal: Refusal) -> usize {
    match refusal {
        Refusal::Folded if !words::depends_on_ray_type(claim, refusal) => 0,
        Refusal::NoRays(_) => 1,
        Refusal::Folded => 2,
        Refusal::NoLights
        | Refusal::NoLightOfTheList
        | Refusal::TraceDepth
        | Refusal::NoEnvironment
        | Refusal::NoEnvironmentLight
        | Refusal::NoSamples => 3,
        Refusal::AboutNothing => 4,
        Refusal::NoShadowRays | Refusal::LightsOfShadows => 5,
        Refusal::Unconnected => 6,
    }
}

fn fact(entry: Entry, on: bool, reason: String) -> Row {
    Row { entry, file: None, asked: None::<Asked>, on, reason }
}
