//! All that shade one subject, against one another.

use std::collections::HashMap;
use std::sync::Arc;

use phenomenon_compiler::effects::NoScene;
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;

use super::column::Column;
use super::contender::Contender;
use super::laziness::Saved;
use super::materials::{Material, Stage};
use super::points::{Answers, Points};
use super::subject::Subject;
use crate::commands::bench::workloads::Workload;
use crate::failure::Failure;

/// Points of one call.
const BATCHES: [usize; 3] = [1, 16, MOST_POINTS];

/// Most points of one call.
const MOST_POINTS: usize = 256;

/// All that shade one subject in calls of one number of points.
pub struct Race {
    /// What they shade.
    pub subject: Subject,
    /// Points of a call.
    pub batch: usize,
    /// Who takes part.
    pub contenders: Vec<Contender>,
    points: Points,
}

impl Race {
    /// Each of them once, for a turn of some 10 ms.
    pub fn take_turn(&mut self) {
        for contender in &mut self.contenders {
            contender.take_turn(&mut self.points);
        }
    }

    /// Fails where something was asked that was not recorded: what was measured is not what was meant.
    ///
    /// # Errors
    /// It tells how much that was.
    pub fn require_answers(&self) -> Result<(), Failure> {
        match self.points.unknown() {
            0 => Ok(()),
            unknown => {
                let name = self.subject.name();
                let message = format!("{unknown} requests of {name} were not recorded");
                Err(Failure::new(message, "this is a fault of the program; please report it"))
            }
        }
    }
}

/// The races of a workload.
///
/// # Errors
/// Its graph cannot be used.
pub fn of_workload(
    workload: Workload,
    columns: &[Column],
    library: &NodeLibrary,
) -> Result<Vec<Race>, Failure> {
    let (subject, graph) = (Subject::Workload(workload), Arc::new(workload.graph(library)?));
    let race = |batch| {
        let points = Points::new(workload.states(), batch, Answers::None(NoScene));
        race(subject, &graph, columns, batch, points)
    };
    BATCHES.into_iter().map(race).collect()
}

/// The races of a material, and what laziness saves there.
///
/// # Errors
/// Its graph cannot be used.
pub fn of_material(
    material: Material,
    columns: &[Column],
    library: &NodeLibrary,
) -> Result<(Vec<Race>, Saved), Failure> {
    let subject = Subject::Material(material);
    let mut stage = Stage::new(material, library)?;
    let saved = Saved::of(&mut stage)?;
    // Whatever else any of them asks is recorded too. Each is compiled by itself: shaders that are in use share their
    // code, so what the contenders take to compile would tell of the first alone. The second time nothing of the
    // process is new.
    let mut compiling = Vec::new();
    for &column in columns.iter().chain(columns) {
        if let Some(shading) = column.shading(subject, &stage.graph, MOST_POINTS)? {
            stage.record(shading.shader());
            compiling.extend(shading.compile_milliseconds().map(|took| (column, took)));
        }
    }
    let compiling: HashMap<&str, f64> =
        compiling.into_iter().map(|(column, took)| (column.name(), took)).collect();
    let (graph, states) = (Arc::clone(&stage.graph), stage.states().to_vec());
    let recorded = stage.recorded();
    let race = |batch| {
        let points = Points::new(states.clone(), batch, Answers::Recorded(recorded.clone()));
        let mut race = race(subject, &graph, columns, batch, points)?;
        for contender in &mut race.contenders {
            contender.compile_milliseconds = compiling.get(contender.column.name()).copied();
        }
        Ok(race)
    };
    let races: Result<Vec<Race>, Failure> = BATCHES.into_iter().map(race).collect();
    Ok((races?, saved))
}

fn race(
    subject: Subject,
    graph: &Arc<Graph>,
    columns: &[Column],
    batch: usize,
    mut points: Points,
) -> Result<Race, Failure> {
    let mut contenders = Vec::new();
    for &column in columns {
        if let Some(shading) = column.shading(subject, graph, batch)? {
            contenders.push(Contender::new(column, shading, &mut points));
        }
    }
    Ok(Race { subject, batch, contenders, points })
}
