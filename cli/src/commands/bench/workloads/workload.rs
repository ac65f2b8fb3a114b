//! The workloads by name.

use clap::ValueEnum;
use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document::read;
use phenomenon_compiler::engine::Shade;
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;

use super::batches::of_points;
#[cfg(target_arch = "x86_64")]
use super::eight;
use super::states::states;
use super::{branchy, fused, light, mixed, ten};
use crate::failure::Failure;

/// A graph that asks nothing of the renderer, and what a programmer would write instead of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Workload {
    /// Some ten simple nodes
    Ten,
    /// 160 light nodes: sums, products, blends
    Light,
    /// A hundred nodes, many of them heavy: sines, powers, hues, directions
    Mixed,
    /// Four choices by the state, with heavy nodes on both sides of each
    Branchy,
    /// The same at points that all choose the same sides
    OneSide,
}

impl Workload {
    /// All of them, the lightest first.
    pub const ALL: [Self; 5] = [Self::Ten, Self::Light, Self::Mixed, Self::Branchy, Self::OneSide];

    /// Name on the command line and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ten => "ten",
            Self::Light => "light",
            Self::Mixed => "mixed",
            Self::Branchy => "branchy",
            Self::OneSide => "one-side",
        }
    }

    /// The graph.
    ///
    /// # Errors
    /// It does not suit this library: a mistake of ours.
    pub fn graph(self, library: &NodeLibrary) -> Result<Graph, Failure> {
        let name = format!("{}.json", self.name());
        let checked = read(&name, self.text().as_bytes()).map(|it| check_graph(&it, library));
        let graph = checked.ok().and_then(|checked| checked.graph);
        graph.ok_or_else(|| Failure::new(format!("the workload {name} cannot be used"), ""))
    }

    /// The points it is shaded at.
    pub fn states(self) -> Vec<State> {
        let mut states = states();
        if self == Self::OneSide {
            states.iter_mut().for_each(branchy::to_one_side);
        }
        states
    }

    /// The graph's file.
    pub fn text(self) -> &'static str {
        match self {
            Self::Ten => include_str!("ten.json"),
            Self::Light => include_str!("light.json"),
            Self::Mixed => include_str!("mixed.json"),
            Self::Branchy | Self::OneSide => include_str!("branchy.json"),
        }
    }

    /// The same by hand: scalar Rust with the functions of std and glam, as a compiler's default target
    /// has them.
    pub fn by_hand(self) -> Box<dyn Shade> {
        match self {
            Self::Ten => of_points(ten::shade),
            Self::Light => of_points(light::shade),
            Self::Mixed => of_points(mixed::shade),
            Self::Branchy | Self::OneSide => of_points(branchy::shade),
        }
    }

    /// The same by hand with the instructions of AVX2; none where nobody wrote it, or the CPU lacks them.
    pub fn by_eight(self) -> Option<Box<dyn Shade>> {
        #[cfg(target_arch = "x86_64")]
        {
            match self {
                Self::Ten => eight::ten(),
                Self::Mixed => eight::mixed(),
                Self::Light | Self::Branchy | Self::OneSide => None,
            }
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            None
        }
    }

    /// The bodies of its nodes as one body, compiled by rustc for eight lanes.
    pub fn fused(self) -> Box<dyn Shade> {
        match self {
            Self::Ten => fused::shader::<fused::Ten>(),
            Self::Light => fused::shader::<fused::Light>(),
            Self::Mixed => fused::shader::<fused::Mixed>(),
            Self::Branchy | Self::OneSide => fused::shader::<fused::Branchy>(),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use phenomenon_compiler::effects::NoScene;
    use phenomenon_compiler::engine::{Engine, Options, Shaded, Shader};
    use phenomenon_compiler::graph::RootKind;
    use phenomenon_compiler::kernels::native_simd;

    use super::*;

    fn colors(workload: Workload, shader: &dyn Shade, batch: usize) -> Vec<[f32; 4]> {
        let states = workload.states();
        let mut results = vec![Shaded::default(); states.len()];
        for (points, results) in states.chunks(batch).zip(results.chunks_mut(batch)) {
            shader.shade(RootKind::Material, points, &mut NoScene, results);
        }
        assert!(results.iter().all(|result| result.ok));
        results.into_iter().map(|result| result.color).collect()
    }

    #[test]
    fn workloads_have_no_findings_and_the_nodes_they_promise() {
        let library = NodeLibrary::standard();
        let nodes = Workload::ALL.map(|workload| {
            let document = read(workload.name(), workload.text().as_bytes()).unwrap();
            let checked = check_graph(&document, &library);
            assert!(checked.findings.is_empty(), "{:?}", checked.findings);
            let graph = checked.graph.unwrap();
            let is_file = |name| name == workload.name() || workload == Workload::OneSide;
            assert!(is_file(graph.name.as_str()), "{}", graph.name);
            graph.nodes.len()
        });
        assert_eq!(nodes, [19, 162, 97, 112, 112]);
    }

    fn walk(workload: Workload) -> Vec<[f32; 4]> {
        let graph = Arc::new(workload.graph(&NodeLibrary::standard()).unwrap());
        let options = Options { engine: Engine::Walk, ..Options::default() };
        colors(workload, &Shader::new(graph, &[], options).unwrap(), 256)
    }

    #[test]
    fn what_is_written_by_hand_computes_the_same() {
        for workload in Workload::ALL {
            let walk = walk(workload);
            for shader in [Some(workload.by_hand()), workload.by_eight()].into_iter().flatten() {
                let by_hand = colors(workload, shader.as_ref(), 13);
                for (point, (a, b)) in walk.iter().zip(&by_hand).enumerate() {
                    for (x, y) in a.iter().zip(b) {
                        let apart = (x - y).abs();
                        let near = apart <= 1e-4 * x.abs();
                        assert!(near, "{} at point {point}: {a:?} {b:?}", workload.name());
                    }
                }
            }
            // No constant is measured.
            let different: std::collections::HashSet<_> =
                walk.iter().map(|color| color.map(f32::to_bits)).collect();
            assert!(different.len() > walk.len() * 9 / 10, "{}", different.len());
        }
        let is_written = Workload::ALL.map(|workload| workload.by_eight().is_some());
        assert_eq!(is_written, [native_simd(), false, native_simd(), false, false]);
    }

    #[test]
    fn bodies_in_one_give_the_bits_of_the_graph() {
        for workload in Workload::ALL {
            let (walk, fused) = (walk(workload), colors(workload, workload.fused().as_ref(), 13));
            for (point, (a, b)) in walk.iter().zip(&fused).enumerate() {
                let bits = |color: &[f32; 4]| color.map(f32::to_bits);
                assert_eq!(bits(a), bits(b), "{} at point {point}: {a:?} {b:?}", workload.name());
            }
        }
    }
}
