//! A case as graphs of ours, run by an engine.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document;
use phenomenon_compiler::effects::NoScene;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::Literal;
use serde_json::{Map, Value, json};

use crate::cases::Case;
use crate::expression::{Expression, Taken, View, read};
use crate::rows::{How, Row};

/// Part of a case that is evaluated at once.
#[derive(Clone, Copy)]
enum Lane {
    /// All of it.
    All,
    /// The first so many components.
    Front(usize),
    /// One component.
    One(usize),
}

/// The graphs of a case, one for each lane.
pub struct Evaluator<'a> {
    case: &'a Case,
    engine: Engine,
    lanes: Vec<(Lane, Arc<Graph>, BTreeSet<View>)>,
}

impl<'a> Evaluator<'a> {
    /// Checks the graphs.
    ///
    /// # Errors
    /// If one has a mistake.
    pub fn new(
        case: &'a Case,
        row: &Row,
        library: &NodeLibrary,
        engine: Engine,
    ) -> Result<Self, String> {
        let expression = read(row.text);
        let count = case.value.len();
        let lanes = match row.how {
            How::Lanes if count == 4 => vec![Lane::Front(3), Lane::One(3)],
            How::Lanes => vec![Lane::Front(count)],
            How::Each => (0..count).map(Lane::One).collect(),
            How::Whole | How::No => vec![Lane::All],
        };
        let lanes = lanes.into_iter().map(|lane| {
            let mut views = BTreeSet::new();
            let text = graph_text(case, lane, &expression, &mut views)?.to_string();
            let document =
                document::read("case.json", text.as_bytes()).map_err(|error| error.to_string())?;
            let checked = check_graph(&document, library);
            let findings =
                || -> Vec<String> { checked.findings.iter().map(ToString::to_string).collect() };
            let graph = checked
                .graph
                .clone()
                .ok_or_else(|| format!("{}\n{text}", findings().join("\n")))?;
            Ok((lane, Arc::new(graph), views))
        });
        let lanes = lanes.collect::<Result<Vec<_>, String>>()?;
        Ok(Self { case, engine, lanes })
    }

    /// What our nodes give for these numbers.
    ///
    /// # Errors
    /// If a graph does not compile.
    pub fn values(&self, numbers: &BTreeMap<String, Vec<f32>>) -> Result<Vec<f32>, String> {
        let mut all = Vec::new();
        for (lane, graph, views) in &self.lanes {
            let given = views
                .iter()
                .map(|view| Ok((parameter(view), literal(self.case, *lane, view, numbers)?)));
            let given = given.collect::<Result<Vec<(String, Literal)>, String>>()?;
            let options = Options { engine: self.engine, ..Options::default() };
            let shader = Shader::new(Arc::clone(graph), &given, options)
                .map_err(|error| error.to_string())?;
            let mut results = [Shaded::default()];
            let state = State { uv: [0.0; 2], point: [0.0; 3], ..State::default() };
            shader.shade(RootKind::Material, &[state], &mut NoScene, &mut results);
            let width = match lane {
                Lane::All => self.case.value.len(),
                Lane::Front(width) => *width,
                Lane::One(_) => 1,
            };
            all.extend(&results[0].color[..width]);
        }
        Ok(all)
    }
}

/// The name of the parameter for what is taken of an input.
fn parameter(view: &View) -> String {
    match view.taken {
        Taken::Plain => view.name.clone(),
        Taken::Wide => format!("{}-wide", view.name),
        Taken::Integer => format!("{}-integer", view.name),
        Taken::Component(at) => format!("{}-{at}", view.name),
        Taken::Three => format!("{}-three", view.name),
    }
}

/// The value of that parameter.
fn literal(
    case: &Case,
    lane: Lane,
    view: &View,
    numbers: &BTreeMap<String, Vec<f32>>,
) -> Result<Literal, String> {
    let name = &view.name;
    let all = numbers.get(name).ok_or_else(|| format!("the case has no input `{name}`"))?;
    if case.truths.contains(name) {
        return Ok(Literal::Boolean(all[0] != 0.0));
    }
    let three = |all: &[f32]| [0, 1, 2].map(|at| all.get(at).copied().unwrap_or(0.0));
    let several = |all: &[f32]| {
        let [x, y, z] = three(all);
        if case.is_of_colors() && all.len() != 2 {
            Literal::Color([x, y, z, 1.0])
        } else {
            Literal::Vector([x, y, z])
        }
    };
    let number = all[0];
    Ok(match (view.taken, lane, all.len()) {
        (Taken::Integer, ..) => Literal::Integer(number as i32),
        // The fourth of three is the alpha of an opaque colour.
        (Taken::Component(at), ..) => Literal::Scalar(all.get(at).copied().unwrap_or(1.0)),
        (Taken::Three, ..) => Literal::Vector(three(all)),
        (Taken::Wide, Lane::Front(width), 1) if width > 1 => {
            let mut repeated = [number; 3];
            repeated[width..].fill(0.0);
            several(&repeated)
        }
        (Taken::Wide, Lane::All, 1) if case.is_of_colors() => several(&[number; 3]),
        (_, _, 1) => Literal::Scalar(number),
        (_, Lane::One(at), _) => Literal::Scalar(*all.get(at).ok_or("too few components")?),
        (_, Lane::All, 4) if case.is_of_colors() => {
            Literal::Color([all[0], all[1], all[2], all[3]])
        }
        (_, _, 2..=4) => several(&all[..all.len().min(3)]),
        (_, _, 9) => transform([&all[..3], &all[3..6], &all[6..], &[0.0; 3]]),
        // A row's last number is left out: it is of no account where three coordinates are wanted.
        (_, _, 16) => transform([&all[..3], &all[4..7], &all[8..11], &all[12..15]]),
        (_, _, length) => return Err(format!("`{name}` has {length} numbers")),
    })
}

fn transform(rows: [&[f32]; 4]) -> Literal {
    let mut numbers = [0.0; 16];
    for (at, row) in rows.into_iter().enumerate() {
        numbers[4 * at..4 * at + 3].copy_from_slice(row);
    }
    numbers[15] = 1.0;
    Literal::Transform(numbers)
}

/// A graph whose root is the expression, as a colour.
fn graph_text(
    case: &Case,
    lane: Lane,
    expression: &Expression,
    views: &mut BTreeSet<View>,
) -> Result<Value, String> {
    let mut nodes = Map::new();
    nodes.insert("here".into(), json!({ "type": "state" }));
    let mut builder = Builder { case, lane, nodes, views, interface: Map::new() };
    let result = builder.value(expression)?;
    let is_vector = case.value_type.starts_with("vector") && !matches!(lane, Lane::One(_));
    let is_number = matches!(lane, Lane::Front(1) | Lane::One(_));
    let root = match () {
        () if case.value_type == "boolean" => builder.node(
            "select",
            json!({ "condition": result, "if_true": [1, 1, 1], "if_false": [0, 0, 0] }),
            None,
        ),
        () if is_vector && !is_number => {
            builder.node("vector_to_color", json!({ "vector": result }), None)
        }
        () => result,
    };
    Ok(json!({
        "phenomenon": "case", "version": 1,
        "interface": builder.interface, "nodes": builder.nodes, "roots": { "material": root }
    }))
}

struct Builder<'a> {
    case: &'a Case,
    lane: Lane,
    nodes: Map<String, Value>,
    views: &'a mut BTreeSet<View>,
    interface: Map<String, Value>,
}

impl Builder<'_> {
    fn value(&mut self, expression: &Expression) -> Result<Value, String> {
        Ok(match expression {
            Expression::Number(number) => json!(number),
            Expression::Numbers(numbers) => json!(numbers),
            Expression::Text(text) => json!(text),
            Expression::List(values) => Value::Array(
                values.iter().map(|value| self.value(value)).collect::<Result<_, _>>()?,
            ),
            Expression::Input(view) => self.input(view)?,
            Expression::Node { name, inputs, output } => {
                let mut given = Map::new();
                for (input, expression) in inputs {
                    given.insert(input.clone(), self.value(expression)?);
                }
                self.node(name, Value::Object(given), output.as_deref())
            }
        })
    }

    fn node(&mut self, name: &str, inputs: Value, output: Option<&str>) -> Value {
        let at = format!("n{}", self.nodes.len());
        self.nodes.insert(at.clone(), json!({ "type": name, "inputs": inputs }));
        match output {
            Some(output) => json!({ "node": at, "output": output }),
            None => json!({ "node": at }),
        }
    }

    /// A parameter, plus zeros that only the shaded point knows: so an engine computes with it, and not
    /// whoever compiles.
    fn input(&mut self, view: &View) -> Result<Value, String> {
        let literal = literal(self.case, self.lane, view, &self.case.numbers)?;
        // Counts and choices are known before shading.
        if let Literal::Integer(number) = literal {
            return Ok(json!(number));
        }
        let name = parameter(view);
        let (kind, zero) = match &literal {
            Literal::Boolean(_) => ("boolean", None),
            Literal::Transform(_) => ("transform", None),
            Literal::Scalar(_) => ("scalar", Some(json!({ "node": "here", "output": "u" }))),
            Literal::Vector(_) => ("vector", Some(json!({ "node": "here", "output": "point" }))),
            Literal::Color(_) => ("color", Some(json!({ "node": "here", "output": "u" }))),
            other => return Err(format!("{other} is no input")),
        };
        let default = match &literal {
            Literal::Boolean(truth) => json!(truth),
            Literal::Scalar(number) => json!(number),
            Literal::Vector(numbers) => json!(numbers),
            Literal::Color(numbers) => json!(numbers),
            Literal::Transform(numbers) => json!(numbers),
            other => return Err(format!("{other} is no input")),
        };
        self.interface.insert(name.clone(), json!({ "type": kind, "default": default }));
        self.views.insert(view.clone());
        let parameter = json!({ "interface": name });
        Ok(match zero {
            Some(zero) => self.node("add", json!({ "a": parameter, "b": zero }), None),
            None => parameter,
        })
    }
}
