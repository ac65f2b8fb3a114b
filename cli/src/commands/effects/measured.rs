//! A ledger with what its rows cost.

use phenomenon_runtime::link::{Bytes, Ledger, Row};
use phenomenon_runtime::render::{Cost, Rendered, Settings};

use crate::failure::Failure;
use crate::scenes::Picture;

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

/// A row with its costs.
#[derive(Clone, Debug)]
pub struct MeasuredRow {
    /// The row.
    pub row: Row,
    /// What it cost.
    pub cost: RowCost,
    /// What it cost with all effects on, if that was rendered.
    pub all_effects: Option<RowCost>,
}

/// A ledger with its costs.
#[derive(Clone, Debug)]
pub struct Measured {
    /// How the pictures were rendered.
    pub settings: Settings,
    /// The picture as the scene calls for it.
    pub whole: Whole,
    /// With all effects on, if that was rendered.
    pub all_effects: Option<Whole>,
    /// The rows.
    pub rows: Vec<MeasuredRow>,
}

impl Measured {
    /// Renders a picture, and another with all effects on, and holds their costs against one another.
    ///
    /// # Errors
    /// A picture cannot be rendered.
    pub fn of(
        picture: &Picture,
        all_effects: Option<&Picture>,
        settings: Settings,
    ) -> Result<Self, Failure> {
        let Ledger { rows } = picture.ledger()?;
        let rendered = render(picture, &settings)?;
        let all =
            all_effects.map(|of| Ok::<_, Failure>((of, render(of, &settings)?))).transpose()?;
        let cost = |of: &Picture, rendered: &Rendered, row: &Row| {
            let (cost, bytes) = Ledger::cost(row, &of.scene, &rendered.costs);
            RowCost { cost, bytes }
        };
        let row = |row: Row| MeasuredRow {
            cost: cost(picture, &rendered, &row),
            all_effects: all.as_ref().map(|(of, rendered)| cost(of, rendered, &row)),
            row,
        };
        Ok(Self {
            settings,
            whole: whole(&rendered),
            all_effects: all.as_ref().map(|(_, rendered)| whole(rendered)),
            rows: rows.into_iter().map(row).collect(),
        })
    }
}

fn render(picture: &Picture, settings: &Settings) -> Result<Rendered, Failure> {
    let rendered = phenomenon_runtime::render::render(&picture.scene, settings, &|_, _| ())
        .map_err(|error| Failure::new(error, "choose other values for --size or --spp"))?;
    picture.require_jit()?;
    Ok(rendered)
}

fn whole(rendered: &Rendered) -> Whole {
    let statistics = &rendered.statistics;
    Whole { rays: statistics.rays.traced(), milliseconds: statistics.whole_milliseconds }
}
