//! All engines give the same results and ask the same of the renderer, on random graphs.
//!
//! `PHENOMENON_CASES` sets how many graphs, `PHENOMENON_SEED` the first seed.

use std::sync::Arc;

use phenomenon_compiler::engine::{Engine, Options, Shader};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::specialise::Asking;
use phenomenon_compiler::testing::differential::outcome;
use phenomenon_compiler::testing::engines::{agreed, random_case};

fn from_environment(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(otherwise)
}

#[test]
fn on_random_graphs() {
    agree_on_random_graphs(NodeLibrary::standard(), 2_000);
}

#[test]
fn on_random_graphs_with_more_scopes_requests_and_loops() {
    agree_on_random_graphs(phenomenon_foreign_nodes::library(), 500);
}

fn agree_on_random_graphs(library: NodeLibrary, cases: u64) {
    let first = from_environment("PHENOMENON_SEED", 0);
    let cases = from_environment("PHENOMENON_CASES", cases);
    let mut ran = 0;
    let mut naive = 0;
    let mut with_requests = 0;
    let mut requests = 0;
    for seed in first..first + cases {
        let agreement = agreed(seed, &random_case(seed, &library));
        ran += u64::from(agreement.ran);
        naive += u64::from(agreement.naive);
        with_requests += u64::from(agreement.requests > 0);
        requests += agreement.requests;
    }
    println!(
        "{cases} graphs, {ran} run, {naive} naively, {with_requests} with {requests} requests"
    );
    // A test that runs nothing would pass too.
    assert!(ran * 10 >= cases * 9 && naive * 2 >= cases && with_requests * 2 >= cases);
}

#[test]
fn whatever_engine_is_taken_by_itself() {
    let library = NodeLibrary::standard();
    for seed in 1 << 32..(1 << 32) + 40 {
        let mut case = random_case(seed, &library);
        case.options = vec![Options { engine: Engine::Auto, ..case.options[1] }; 3];
        agreed(seed, &case);
    }
}

#[test]
fn what_laziness_leaves_out_changes_nothing() {
    let library = NodeLibrary::standard();
    let (mut compared, mut saved) = (0, 0);
    for seed in 1 << 33..(1 << 33) + 150 {
        let case = random_case(seed, &library);
        let shader = |options: Options| Shader::new(Arc::clone(&case.graph), &case.values, options);
        let walk = Options { engine: Engine::Walk, ..Options::default() };
        let Ok(lazy) = shader(walk) else { continue };
        for engine in [Engine::Walk, Engine::Batch, Engine::Jit] {
            let eager = Options { engine, asking: Asking::All, ..Options::default() };
            // More than there is room for, maybe.
            let Ok(eager) = shader(eager) else { continue };
            for root in &case.graph.roots {
                let wanted = outcome(&lazy, root.kind, &case.points);
                let all = outcome(&eager, root.kind, &case.points);
                assert_eq!(wanted.results, all.results, "{engine:?}, seed {seed}");
                assert!(wanted.log.len() <= all.log.len(), "{engine:?}, seed {seed}");
                compared += 1;
                saved += all.log.len() - wanted.log.len();
            }
        }
    }
    assert!(compared > 300 && saved > 1000, "{compared} compared, {saved} requests saved");
}
