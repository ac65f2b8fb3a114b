//! How long reading and checking takes: chains of 1,000 to 100,000 nodes, beside serde_json, which
//! only parses the same bytes.
//!
//! `cargo bench -p phenomenon-compiler --bench check` prints a table of CPU time, the best of many
//! runs, in which what one run makes is also dropped. `-- --json` prints it as JSON.

#[path = "../tests/chain/mod.rs"]
mod chain;

use std::hint::black_box;
use std::time::Duration;

use cpu_time::ThreadTime;
use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document::read;
use phenomenon_compiler::nodes::NodeLibrary;
use serde_json::json;

const LENGTHS: [usize; 4] = [1_000, 4_000, 20_000, 100_000];

/// Time spent on one row and column.
const BUDGET: Duration = Duration::from_secs(1);

fn main() {
    let library = NodeLibrary::standard();
    let rows: Vec<Row> = LENGTHS.iter().map(|&length| row(length, &library)).collect();
    if std::env::args().any(|argument| argument == "--json") {
        let rows: Vec<_> = rows.iter().map(Row::json).collect();
        println!("{}", json!({ "version": 1, "rows": rows }));
        return;
    }
    println!("CPU milliseconds, best of many runs");
    println!(
        "| nodes | kilobytes | read | read and check | per node, µs | serde_json | ratio |\n\
         | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
    );
    for row in &rows {
        println!("{}", row.line());
    }
}

struct Row {
    nodes: usize,
    bytes: usize,
    /// Seconds.
    read: f64,
    checked: f64,
    serde_json: f64,
}

fn row(nodes: usize, library: &NodeLibrary) -> Row {
    let text = chain::chain(nodes, "[1,0,0]");
    let bytes = text.as_bytes();
    Row {
        nodes,
        bytes: bytes.len(),
        read: best(|| drop(black_box(read("chain.json", bytes).expect("it is JSON")))),
        checked: best(|| {
            let document = read("chain.json", bytes).expect("it is JSON");
            let checked = check_graph(&document, library);
            assert_eq!(checked.graph.as_ref().map(|graph| graph.nodes.len()), Some(nodes));
            assert!(checked.findings.is_empty());
            black_box(checked);
        }),
        serde_json: best(|| {
            let value: serde_json::Value = serde_json::from_slice(bytes).expect("it is JSON");
            black_box(value);
        }),
    }
}

/// CPU seconds of the quickest run, after one that is not counted.
fn best(run: impl Fn()) -> f64 {
    run();
    let start = ThreadTime::now();
    let mut best = Duration::MAX;
    while start.elapsed() < BUDGET {
        let start = ThreadTime::now();
        run();
        best = best.min(start.elapsed());
    }
    best.as_secs_f64()
}

impl Row {
    fn line(&self) -> String {
        let Self { nodes, bytes, read, checked, serde_json } = self;
        format!(
            "| {nodes} | {:.0} | {:.2} | {:.2} | {:.2} | {:.2} | {:.1} |",
            *bytes as f64 / 1e3,
            read * 1e3,
            checked * 1e3,
            checked * 1e6 / *nodes as f64,
            serde_json * 1e3,
            checked / serde_json,
        )
    }

    fn json(&self) -> serde_json::Value {
        json!({
            "nodes": self.nodes,
            "bytes": self.bytes,
            "read_ms": self.read * 1e3,
            "check_ms": self.checked * 1e3,
            "serde_json_ms": self.serde_json * 1e3,
            "ratio": self.checked / self.serde_json,
        })
    }
}
