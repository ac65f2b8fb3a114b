//! `-o DIR`: the rows of a measurement as `DIR/NAME.json`.

use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::failure::Failure;
use crate::outputs::Output;

/// The file of results in a folder, found to be writable before the work starts.
pub struct Results {
    path: PathBuf,
}

impl Results {
    /// The results of `bench QUESTION` in a folder, which is made unless it is there.
    ///
    /// # Errors
    /// The folder cannot be made, the file cannot be written, or something under its name is no result of
    /// an earlier run: the name was not chosen, so it must not cost anybody a graph that is called so.
    pub fn new(folder: &Path, question: &str) -> Result<Self, Failure> {
        make_folder(folder)?;
        let results = Self { path: folder.join(question).with_extension("json") };
        results.output().require_writable()?;
        require_replaceable(&results.path, question)?;
        Ok(results)
    }

    /// What will be written.
    pub fn output(&self) -> Output<'_> {
        Output { flag: "-o", path: &self.path }
    }

    /// Writes `{"version":1,"rows":[…]}`.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, rows: &[Value]) -> Result<(), Failure> {
        self.output().write(format!("{:#}\n", json!({ "version": 1, "rows": rows })))
    }
}

fn make_folder(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|error| {
        Failure::new(format!("-o {}: {error}", folder.display()), "name another folder")
    })
}

fn require_replaceable(path: &Path, question: &str) -> Result<(), Failure> {
    let is_result = |value: &Value| {
        let keys = value.as_object().map(|object| object.keys().map(String::as_str).collect());
        keys == Some(vec!["version", "rows"]) && value["rows"].is_array()
    };
    // A pipe must not be opened; that it cannot be written is said before.
    if !path.is_file() {
        return Ok(());
    }
    let read = std::fs::File::open(path)
        .map(|file| serde_json::from_reader::<_, Value>(BufReader::new(file.take(LARGEST_RESULT))));
    if matches!(read, Ok(Ok(value)) if is_result(&value)) {
        return Ok(());
    }
    let message = format!("-o {} exists, and is no result of `bench {question}`", path.display());
    Err(Failure::new(message, "name another folder with -o"))
}

/// Bytes; a result has some thousand.
const LARGEST_RESULT: u64 = 1 << 20;
