//! Checking costs no memory that stays: an editor checks with every key that is pressed, and each new
//! name of a file is a name nobody will ask for again.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::check::{Files, check_graph_with};
use phenomenon_compiler::diagnostics::{Code, Finding, Place, SourceFile};
use phenomenon_compiler::document::{Document, read};
use phenomenon_compiler::nodes::NodeLibrary;

thread_local! {
    /// Bytes this thread has, and has not given back.
    static KEPT: Cell<isize> = const { Cell::new(0) };
}

/// The system's allocator, counting.
struct Counting;

// SAFETY: every call goes to the system's allocator as it came; counting touches a cell without a
// destructor, and allocates nothing.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        KEPT.set(KEPT.get() + layout.size() as isize);
        // SAFETY: the caller's promises are those of the system's allocator.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        KEPT.set(KEPT.get() - layout.size() as isize);
        // SAFETY: as above; the memory is the system's.
        unsafe { System.dealloc(memory, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// One phenomenon under any name, with a parameter that has a name of its own for each.
struct Anything;

impl Files for Anything {
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>> {
        let Some(number) = path.file_stem().and_then(|stem| stem.to_str()) else {
            let file = Arc::new(SourceFile::new(path.display().to_string(), ""));
            let place = Place { file, start: 0, end: 0, path: String::new() };
            return Err(Box::new(Finding::new(Code::UNREADABLE_FILE, place, "no such file", "")));
        };
        let text = format!(
            r#"{{ "phenomenon": "p{number}",
                 "interface": {{ "tint_{number}": {{ "type": "color", "default": [1, 1, 1] }} }},
                 "roots": {{ "material": {{ "interface": "tint_{number}" }} }} }}"#
        );
        read(&path.display().to_string(), text.as_bytes())
    }

    fn identity(&self, path: &Path) -> PathBuf {
        path.to_owned()
    }

    fn unusable(&self, _: &Path) -> Option<String> {
        None
    }
}

/// Checks a graph with a phenomenon in it that no other graph has.
fn check(number: usize, library: &NodeLibrary) {
    let text = format!(
        r#"{{ "phenomenon": "user{number}",
             "nodes": {{
                 "n": {{ "type": {{ "file": "{number}.json" }},
                         "inputs": {{ "tint_{number}": [0.5, 0.25, 1] }} }},
                 "bare": {{ "type": {{ "file": "{number}.json" }} }},
                 "both": {{ "type": "add", "inputs": {{ "a": {{ "node": "n" }}, "b": {{ "node": "bare" }} }} }}
             }},
             "roots": {{ "material": {{ "node": "both" }} }} }}"#
    );
    let document = read("user.json", text.as_bytes()).expect("it is JSON");
    let checked = check_graph_with(&document, library, &Anything);
    assert!(checked.findings.is_empty(), "{:?}", checked.findings);
    let graph = checked.graph.expect("a graph without findings");
    assert_eq!(graph.nodes.len(), 1, "the phenomena are their parameters");
}

#[test]
fn ten_thousand_graphs_with_names_of_their_own_leave_nothing_behind() {
    let library = NodeLibrary::standard();
    // What is made once, on first use.
    check(0, &library);
    let before = KEPT.get();
    check(1, &library);
    assert_eq!(KEPT.get(), before, "after one graph");
    for number in 2..10_002 {
        check(number, &library);
    }
    assert_eq!(KEPT.get(), before, "after all");
    let kept = vec![0_u8; 1000];
    assert_eq!(KEPT.get(), before + 1000, "what is kept is counted");
    drop(kept);
}
