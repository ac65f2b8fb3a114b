//! Pixels from a file.

use std::collections::HashSet;
use std::io::{self, Read, Seek};

use exr::block::UncompressedBlock;
use exr::block::lines::LineRef;
use exr::block::reader::ChunksReader;
use exr::prelude::{SampleType, f16};

use super::header::Header;
use crate::film::Film;
use crate::film::fault::Fault;
use crate::film::size::room_for;

/// What a decoder holds of a chunk at most: as it is in the file, decoded, and in between.
const COPIES: u64 = 4;

/// Reads the pixels of a file from its start, after its header was found good: those of its display window,
/// transparent where the file has none.
pub(in crate::film) fn read(header: &Header, file: impl Read + Seek) -> Result<Film, Fault> {
    let summary = header.summary();
    let mut film = Film::new(summary.width, summary.height)?;
    room_for(COPIES * header.chunk_bytes, (summary.width, summary.height))?;
    if header.selection.alpha.is_none() {
        film.pixels_mut().fill([0.0, 0.0, 0.0, 1.0]);
    }
    let reader = exr::block::read(file, false).map_err(fault)?;
    let channels = reader.headers().get(header.part).map(|part| part.channels.clone());
    let channels = channels.ok_or_else(|| Fault::malformed("its headers contradict each other"))?;
    let chunks = reader
        .filter_chunks(false, |_, tile, block| {
            block.layer == header.part && tile.is_largest_resolution_level()
        })
        .map_err(fault)?;
    let expected = chunks.expected_chunk_count();
    let mut found = HashSet::new();
    for block in chunks.sequential_decompressor(false) {
        let block: UncompressedBlock = block.map_err(fault)?;
        let index = block.index;
        if index.layer != header.part || index.level.0 != 0 || index.level.1 != 0 {
            return Err(Fault::malformed("a chunk is not where its table says"));
        }
        if !found.insert((index.pixel_position.0, index.pixel_position.1)) {
            return Err(Fault::malformed("a chunk is there twice, so another is missing"));
        }
        for line in block.lines(&channels) {
            copy(header, &mut film, &line, channels.list[line.location.channel].sample_type)?;
        }
    }
    match found.len() == expected {
        true => Ok(film),
        false => Err(Fault::malformed("some of its pixels are missing")),
    }
}

/// Puts a line of one channel where it belongs, if anywhere.
fn copy(
    header: &Header,
    film: &mut Film,
    line: &LineRef<'_>,
    sample_type: SampleType,
) -> Result<(), Fault> {
    let (selection, channel) = (&header.selection, line.location.channel);
    let wanted: [bool; 4] = std::array::from_fn(|k| match selection.color.get(k) {
        Some(color) => *color == channel,
        None => selection.alpha == Some(channel),
    });
    if !wanted.contains(&true) {
        return Ok(());
    }
    let inside = |at: usize, data: i32, display: i32, count: u32| {
        let at = at as i64 + i64::from(data) - i64::from(display);
        (0..i64::from(count)).contains(&at).then_some(at as u32)
    };
    let (data, display) = (header.data, header.display);
    let row = inside(line.location.position.1, data.top, display.top, film.height());
    let Some(row) = row else { return Ok(()) };
    let mut put = |at: usize, value: f32| {
        let column = line.location.position.0 + at;
        if let Some(column) = inside(column, data.left, display.left, film.width()) {
            let mut pixel = film.pixel(column, row);
            for (part, _) in pixel.iter_mut().zip(wanted).filter(|(_, wanted)| *wanted) {
                *part = value;
            }
            film.set(column, row, pixel);
        }
    };
    match sample_type {
        SampleType::F32 => {
            for (at, value) in line.read_samples::<f32>().enumerate() {
                put(at, value.map_err(fault)?);
            }
        }
        SampleType::F16 => {
            for (at, value) in line.read_samples::<f16>().enumerate() {
                put(at, value.map_err(fault)?.to_f32());
            }
        }
        SampleType::U32 => {
            for (at, value) in line.read_samples::<u32>().enumerate() {
                put(at, value.map_err(fault)? as f32);
            }
        }
    }
    Ok(())
}

/// What the decoder says, in our terms.
pub(super) fn fault(error: exr::error::Error) -> Fault {
    match error {
        // No system goes to a place before the start of a file.
        exr::error::Error::Io(error) if error.kind() == io::ErrorKind::InvalidInput => {
            Fault::malformed("a chunk is not where its table says")
        }
        exr::error::Error::Io(error) => error.into(),
        other => Fault::Malformed(other.to_string()),
    }
}
