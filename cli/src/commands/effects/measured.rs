//! A ledger with what its rows cost.

use phenomenon_runtime::link::{Bytes, Ledger, Row};
use phenomenon_runtime::render::{Cost, RenderError, Rendered, Settings};

use crate::failure::Failure;
use crate::scenes::Picture;
use crate::terminal;

/// What a rendering cost as a whole.
#[derive(Clone, Copy, Debug)]
pub struct Whole {
    /// All rays, those from the camera included.
    pub rays: u64,
    /// Milliseconds.
    pub milliseconds: f64,
}

/// What a row cost.
#[derive(Clone, Copy, Debug)]
pub struct RowCost {
    /// How many, and how long.
    pub cost: Cost,
    /// Bytes held.
    pub bytes: Bytes,
}

/// What the rows and the whole cost one picture.
#[derive(Clone, Debug)]
pub struct Costs {
    /// The picture.
    pub whole: Whole,
    /// By position in the rows.
    pub rows: Vec<RowCost>,
}

/// The picture with all effects on.
#[derive(Clone, Debug)]
pub enum AllEffects {
    /// It was not asked for.
    NotAsked,
    /// It takes more rays than this.
    TooManyRays(u64),
    /// It was rendered.
    Measured(Costs),
}

/// A ledger with its costs.
#[derive(Clone, Debug)]
pub struct Measured {
    /// How the picture was rendered.
    pub settings: Settings,
    /// The rows.
    pub rows: Vec<Row>,
    /// What they cost in the picture as the scene calls for it.
    pub costs: Costs,
    /// And with all effects on.
    pub all_effects: AllEffects,
}

impl Measured {
    /// Renders a picture, and holds its costs against the rows of its ledger.
    ///
    /// # Errors
    /// The picture cannot be rendered.
    pub fn of(picture: &Picture, settings: Settings) -> Result<Self, Failure> {
        let Ledger { rows } = picture.ledger()?;
        let rendered = render(picture, &settings)?.map_err(not_rendered)?;
        let costs = costs(&rows, picture, &rendered);
        Ok(Self { settings, rows, costs, all_effects: AllEffects::NotAsked })
    }

    /// Renders the same with all effects on, which may take so many rays.
    ///
    /// # Errors
    /// The picture cannot be rendered.
    pub fn compare(&mut self, picture: &Picture, rays: u64) -> Result<(), Failure> {
        let settings = Settings { ray_limit: Some(rays), ..self.settings };
        self.all_effects = match render(picture, &settings)? {
            Ok(rendered) => AllEffects::Measured(costs(&self.rows, picture, &rendered)),
            Err(RenderError::Rays(limit)) => AllEffects::TooManyRays(limit),
            Err(error) => return Err(not_rendered(error)),
        };
        Ok(())
    }

    /// The costs with all effects on, if they were measured.
    pub fn all_costs(&self) -> Option<&Costs> {
        match &self.all_effects {
            AllEffects::Measured(costs) => Some(costs),
            AllEffects::NotAsked | AllEffects::TooManyRays(_) => None,
        }
    }
}

fn costs(rows: &[Row], picture: &Picture, rendered: &Rendered) -> Costs {
    let cost = |row: &Row| {
        let (cost, bytes) = Ledger::cost(row, &picture.scene, &rendered.costs);
        RowCost { cost, bytes }
    };
    let statistics = &rendered.statistics;
    let whole =
        Whole { rays: statistics.rays.traced(), milliseconds: statistics.whole_milliseconds };
    Costs { whole, rows: rows.iter().map(cost).collect() }
}

fn not_rendered(error: RenderError) -> Failure {
    Failure::new(error, "choose other values for --size or --spp")
}

/// Renders once to have the code made, with one sample, and once to measure.
fn render(
    picture: &Picture,
    settings: &Settings,
) -> Result<Result<Rendered, RenderError>, Failure> {
    let bar = terminal::progress("tiles", false);
    let progress = |done: usize, total: usize| {
        bar.set_length(total as u64);
        bar.set_position(done as u64);
    };
    let render =
        |settings| phenomenon_runtime::render::render(&picture.scene, &settings, &progress);
    let warm = render(Settings { samples: 1, ..*settings });
    let rendered = warm.and_then(|_| render(*settings));
    bar.finish_and_clear();
    picture.require_jit()?;
    Ok(rendered)
}
