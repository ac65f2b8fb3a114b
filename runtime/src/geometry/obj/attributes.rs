//! The numbers of an OBJ file: positions, surface coordinates and normals.

use super::fault::ObjFault;
use super::statements::Statements;
use crate::geometry::COORDINATE_LIMIT;
use crate::geometry::mesh::push;

/// What faces refer to.
#[derive(Debug, Default)]
pub(super) struct Attributes {
    pub(super) positions: Vec<[f32; 3]>,
    /// One per position where any has one, those without white; else none.
    pub(super) colors: Vec<[f32; 3]>,
    pub(super) uvs: Vec<[f32; 2]>,
    pub(super) normals: Vec<[f32; 3]>,
    /// The first line that starts like no statement, and its first word.
    pub(super) stranger: Option<(usize, String)>,
}

/// Statements that are known and left out: names, materials, display and rendering settings, points
/// and lines, free-form geometry but for surfaces, and what older files call them.
const LEFT_OUT: [&str; 40] = [
    "g",
    "o",
    "s",
    "mg",
    "usemtl",
    "mtllib",
    "usemap",
    "maplib",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
    "p",
    "l",
    "vp",
    "cstype",
    "deg",
    "bmat",
    "step",
    "curv",
    "curv2",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "cdc",
    "res",
    "csh",
    "v",
    "vt",
    "vn",
    "f",
    "fo",
];

/// Statements that hold, or fetch, surfaces this reader does not know.
const NOT_READ: [&str; 5] = ["surf", "bsp", "bzp", "cdp", "call"];

impl Attributes {
    /// Reads all of them; on failure `statements` stands in the line at fault.
    pub(super) fn read(statements: &mut Statements<'_>) -> Result<Self, ObjFault> {
        let mut attributes = Self::default();
        while let Some(keyword) = statements.statement() {
            match keyword {
                b"v" => {
                    let (given, count) = numbers::<6>("v", 3, statements, |word, at, number| {
                        match at >= 3 || number.abs() <= COORDINATE_LIMIT {
                            true => Ok(()),
                            false => Err(ObjFault::TooFar(ObjFault::shown(word))),
                        }
                    })?;
                    let [x, y, z, r, g, b] = given;
                    attributes.add_color((count == 6).then_some([r, g, b]))?;
                    push(&mut attributes.positions, [x, y, z])?;
                }
                b"vt" => {
                    let ([u, v, _], _) = numbers("vt", 1, statements, |_, _, _| Ok(()))?;
                    push(&mut attributes.uvs, [u, v])?;
                }
                b"vn" => {
                    let (normal, _) = numbers("vn", 3, statements, |_, _, _| Ok(()))?;
                    push(&mut attributes.normals, normal)?;
                }
                other => attributes.pass(other, statements.line())?,
            }
        }
        Ok(attributes)
    }

    /// The colour of the next position. Before the first that has one none is kept.
    fn add_color(&mut self, color: Option<[f32; 3]>) -> Result<(), ObjFault> {
        const WHITE: [f32; 3] = [1.0; 3];
        if color.is_none() && self.colors.is_empty() {
            return Ok(());
        }
        while self.colors.len() < self.positions.len() {
            push(&mut self.colors, WHITE)?;
        }
        Ok(push(&mut self.colors, color.unwrap_or(WHITE))?)
    }

    fn pass(&mut self, keyword: &[u8], line: usize) -> Result<(), ObjFault> {
        if NOT_READ.iter().any(|known| known.as_bytes() == keyword) {
            return Err(ObjFault::NotRead(ObjFault::shown(keyword)));
        }
        if self.stranger.is_none() && LEFT_OUT.iter().all(|known| known.as_bytes() != keyword) {
            self.stranger = Some((line, ObjFault::shown(keyword)));
        }
        Ok(())
    }
}

/// The first `N` numbers of a statement that needs `least` of them, 0 where it has fewer, and how many it
/// has. What follows (a third surface coordinate) must be numbers too, but does not count; nor need a weight
/// be finite.
fn numbers<const N: usize>(
    keyword: &'static str,
    least: usize,
    statements: &mut Statements<'_>,
    check: impl Fn(&[u8], usize, f32) -> Result<(), ObjFault>,
) -> Result<([f32; N], usize), ObjFault> {
    let mut numbers = [0.0; N];
    let mut count = 0;
    let mut strange = None;
    while let Some(word) = statements.word() {
        let number = number(word)?;
        if let Some(slot) = numbers.get_mut(count) {
            if !number.is_finite() && count < least.max(2) {
                return Err(ObjFault::NotFinite(ObjFault::shown(word)));
            }
            if !number.is_finite() {
                strange = Some(ObjFault::shown(word));
            }
            check(word, count, number)?;
            *slot = number;
        }
        count += 1;
    }
    match strange {
        // All of them count.
        Some(word) if count == N => Err(ObjFault::NotFinite(word)),
        _ if count < least => Err(ObjFault::TooFewNumbers { keyword, least, count }),
        _ => Ok((numbers, count)),
    }
}

/// A number in decimal digits, rounded once to the nearest of 32 bits.
fn number(word: &[u8]) -> Result<f32, ObjFault> {
    let parsed = std::str::from_utf8(word).ok().and_then(|text| text.parse::<f32>().ok());
    match parsed {
        Some(number) => Ok(number),
        // `nan(ind)`, `-1.#IND` and their like.
        None if is_not_finite(word) => Ok(f32::NAN),
        None => Err(ObjFault::NotANumber(ObjFault::shown(word))),
    }
}

fn is_not_finite(word: &[u8]) -> bool {
    let unsigned = word.strip_prefix(b"-").or(word.strip_prefix(b"+")).unwrap_or(word);
    let starts = |with: &str| {
        unsigned.get(..with.len()).is_some_and(|start| start.eq_ignore_ascii_case(with.as_bytes()))
    };
    starts("nan(") || starts("1.#")
}
