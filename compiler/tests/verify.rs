//! What is said of specialised graphs and schedules that a pass broke.

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document;
use phenomenon_compiler::effects::Sampling;
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::kernels::BodyForms;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::schedule::{self, Item, RegionId, Schedule, schedule};
use phenomenon_compiler::specialise::{
    self, EpochId, Instance, InstanceId, InstanceKind, LightTableId, Specialised, Subject,
    TexturePosition, expand, internal,
};
use phenomenon_compiler::state::RayType;
use phenomenon_compiler::storage::Source;

/// A loop with a request in one branch, a request in another, and heavy pure nodes in two more.
const NODES: &str = r#"
    "s": { "type": "state" }, "mirror": { "type": "trace_reflection" }, "lit": { "type": "lambert" },
    "loop": { "type": "light_loop", "inputs": { "body": { "node": "lit" } } },
    "either": { "type": "mix", "inputs": { "weight": { "node": "s", "output": "u" },
                "a": { "node": "loop" }, "b": { "node": "mirror", "output": "color" } } },
    "smoke": { "type": "perlin_noise" }, "fire": { "type": "perlin_noise", "inputs": { "octaves": 2 } },
    "inside": { "type": "select", "inputs": { "condition": { "node": "s", "output": "inv_normal" },
                "if_true": { "node": "smoke" }, "if_false": { "node": "fire" } } },
    "sum": { "type": "add", "inputs": { "a": { "node": "either" }, "b": { "node": "inside" } } }"#;

fn graph(library: &NodeLibrary) -> Graph {
    let text = format!(
        r#"{{ "phenomenon": "g", "version": 1, "interface": {{}}, "nodes": {{ {NODES} }},
              "roots": {{ "material": {{ "node": "sum" }} }} }}"#
    );
    let document = document::read("g.json", text.as_bytes()).expect("it is JSON");
    let checked = check_graph(&document, library);
    checked.graph.unwrap_or_else(|| panic!("{:#?}", checked.findings))
}

fn specialised() -> Specialised {
    let library = NodeLibrary::standard();
    let graph = graph(&library);
    expand(&graph, &graph.roots[0], RayType::Eye, &[]).expect("it fits")
}

/// What is said of the graph after a change.
fn broken(change: impl FnOnce(&mut Specialised)) -> String {
    let mut graph = specialised();
    change(&mut graph);
    specialise::verify(&graph).expect_err("it is broken")
}

fn find(graph: &Specialised, is: impl Fn(&Instance) -> bool) -> InstanceId {
    let found = graph.instances.iter().find(|(_, instance)| is(instance));
    found.expect("there is one").0
}

fn is_request(instance: &Instance) -> bool {
    matches!(instance.kind, InstanceKind::Request { .. })
}

fn is_loop(instance: &Instance) -> bool {
    matches!(instance.kind, InstanceKind::Loop { .. })
}

#[test]
fn what_is_made_is_right() {
    let graph = specialised();
    specialise::verify(&graph).expect("specialised");
    schedule::verify(&schedule(&graph)).expect("scheduled");
}

#[track_caller]
fn says(what: &str, said: &str) {
    assert!(said.contains(what), "{said:?} does not speak of {what:?}");
}

#[test]
fn demands_come_before_and_words_are_demanded() {
    says(
        "does not come before it",
        &broken(|graph| {
            let root = graph.root();
            graph.instances[root].demands[0].source = root;
        }),
    );
    says(
        "before it is there",
        &broken(|graph| {
            let root = graph.root();
            graph.instances[root].demands.clear();
        }),
    );
    says(
        "before it is there",
        &broken(|graph| {
            let id = find(graph, |instance| matches!(instance.kind, InstanceKind::Plain(_)));
            graph.instances[id].words.push(Source::Constant { at: 0, bits: 0x1234_5678 });
        }),
    );
    says(
        "before it is there",
        &broken(|graph| {
            // The turn's fields, outside of the loop.
            let root = graph.root();
            let InstanceKind::Loop { fields, .. } = graph.instances[find(graph, is_loop)].kind
            else {
                panic!("a loop")
            };
            graph.instances[root].words[0] = Source::Slot(fields);
        }),
    );
}

#[test]
fn each_slot_is_written_by_one() {
    says(
        "is written by two",
        &broken(|graph| {
            let root = graph.root();
            graph.instances[root].output = graph.instances[find(graph, is_request)].output;
        }),
    );
    says("is written and is none", &broken(|graph| graph.slots -= 1));
}

#[test]
fn guards_are_masks_and_bodies_take_what_they_are_given() {
    let guarded = |graph: &Specialised| {
        find(graph, |instance| instance.demands.iter().any(|demand| demand.guard.is_some()))
    };
    let change = |code: BodyForms| {
        broken(|graph| {
            let id = guarded(graph);
            let demands = graph.instances[id].demands.iter_mut();
            demands.filter_map(|demand| demand.guard.as_mut()).for_each(|guard| guard.code = code);
        })
    };
    says("a guard is no mask", &change(internal::integer_to_scalar_code()));
    says(
        "more words than it is given",
        &broken(|graph| {
            let id = guarded(graph);
            graph.instances[id].words.truncate(1);
        }),
    );
    says(
        "yields another number of words",
        &broken(|graph| {
            let id = guarded(graph);
            graph.instances[id].kind = InstanceKind::Plain(internal::both_code());
        }),
    );
}

#[test]
fn requests_and_loops_name_what_there_is() {
    let request = |change: fn(&mut InstanceKind)| {
        broken(|graph| {
            let id = find(graph, is_request);
            change(&mut graph.instances[id].kind);
        })
    };
    says(
        "in other loops",
        &request(|kind| {
            let InstanceKind::Request { loops, .. } = kind else { panic!("a request") };
            loops.push(EpochId::POINT);
        }),
    );
    says(
        "which is none",
        &request(|kind| {
            let InstanceKind::Request { subject, .. } = kind else { panic!("a request") };
            *subject = Subject::Texture(TexturePosition::from_u32(0), Sampling::default());
        }),
    );
    let loops = |change: fn(InstanceId, &mut InstanceKind)| {
        broken(|graph| {
            let id = find(graph, is_loop);
            change(id, &mut graph.instances[id].kind);
        })
    };
    says(
        "another number of words",
        &loops(|_, kind| {
            let InstanceKind::Loop { words, .. } = kind else { panic!("a loop") };
            words.pop();
        }),
    );
    says(
        "its body does not come before it",
        &loops(|id, kind| {
            let InstanceKind::Loop { body, .. } = kind else { panic!("a loop") };
            *body = Some(id);
        }),
    );
    says(
        "an epoch that it did not open",
        &loops(|_, kind| {
            let InstanceKind::Loop { epoch, .. } = kind else { panic!("a loop") };
            *epoch = EpochId::POINT;
        }),
    );
    says(
        "it belongs to",
        &broken(|graph| {
            let root = graph.root();
            graph.instances[root].epoch = EpochId::from_u32(99);
        }),
    );
}

/// What is said of the schedule after a change.
fn misplanned(change: impl FnOnce(&mut Schedule)) -> String {
    let mut schedule = schedule(&specialised());
    change(&mut schedule);
    schedule::verify(&schedule).expect_err("it is broken")
}

#[test]
fn steps_read_what_was_written() {
    says(
        "before it is written",
        &misplanned(|it| it.segments.values_mut().next().unwrap().steps.reverse()),
    );
    says(
        "is written by two",
        &misplanned(|it| {
            let request = it.requests.keys().next().unwrap();
            it.requests[request].output = it.fields[0].1;
        }),
    );
    says("is written and is none", &misplanned(|it| it.slots -= 1));
}

#[test]
fn all_is_run_in_one_place() {
    says(
        "is run in two places",
        &misplanned(|it| {
            let again = it.regions[RegionId::ROOT].items.clone();
            it.regions[RegionId::ROOT].items.extend(again);
        }),
    );
    says(
        "in no region",
        &misplanned(|it| {
            for region in it.regions.values_mut() {
                region.items.retain(|item| !matches!(item, Item::Request(_)));
            }
        }),
    );
    says(
        "is run in 0 ways",
        &misplanned(|it| {
            for region in it.regions.values_mut() {
                region.items.retain(|item| !matches!(item, Item::Force { .. }));
            }
        }),
    );
    says(
        "not one after it",
        &misplanned(|it| {
            let items = &mut it.regions[RegionId::ROOT].items;
            items.push(Item::Force { region: RegionId::ROOT, guard: None });
        }),
    );
}

#[test]
fn masks_were_found_by_guards() {
    says(
        "a mask that no guard found",
        &misplanned(|it| {
            let slot = it.fields[0].1;
            for item in it.regions.values_mut().flat_map(|region| &mut region.items) {
                if let Item::Force { guard: Some(guard), .. } = item {
                    *guard = Source::Slot(slot);
                }
            }
        }),
    );
    let skipped = |it: &mut Schedule, change: &dyn Fn(&mut Vec<Source>)| {
        let steps = it.segments.values_mut().flat_map(|segment| &mut segment.steps);
        let mut skipped = steps.filter(|step| !step.wanted.is_empty()).peekable();
        assert!(skipped.peek().is_some(), "something is heavy enough to be skipped");
        skipped.for_each(|step| change(&mut step.wanted));
    };
    says(
        "a mask that no guard found",
        &misplanned(|it| {
            let slot = it.fields[0].1;
            skipped(it, &|wanted| wanted[0] = Source::Slot(slot));
        }),
    );
    says(
        "before it is written",
        &misplanned(|it| {
            let root = it.root;
            skipped(it, &|wanted| wanted[0] = Source::Slot(root));
        }),
    );
}

#[test]
fn loops_name_what_there_is() {
    let loops =
        |change: fn(&mut schedule::Loop)| misplanned(|it| it.loops.values_mut().for_each(change));
    says("forgets what is none", &loops(|of| of.emptied.push(LightTableId::from_u32(7))));
    says("not one after it", &loops(|of| of.region = RegionId::ROOT));
}
