//! Pictures side by side, one for each square of surface coordinates.

use std::collections::BTreeMap;

use phenomenon_compiler::effects::{Lookup, Sampling, Wrap};
use phenomenon_compiler::values::Tile;

use super::Picture;
use crate::film::SizeError;

/// The tiles of a set that there are, by row and column.
#[derive(Clone, Debug, Default)]
pub(super) struct Tiles {
    pictures: BTreeMap<Tile, Picture>,
}

impl Tiles {
    /// Adds a tile.
    pub fn add(&mut self, [column, row]: Tile, picture: Picture) {
        self.pictures.insert([row, column], picture);
    }

    /// Columns and rows of pixels of the first.
    pub fn size(&self) -> Option<[u32; 2]> {
        self.pictures.values().next().map(Picture::size)
    }

    /// The sizes of all, each with whether it has coarser versions.
    pub fn sizes(&self) -> impl Iterator<Item = ([u32; 2], bool)> {
        self.pictures.values().map(|picture| (picture.size(), picture.has_levels()))
    }

    /// The sizes of those without coarser versions.
    pub fn sizes_without_levels(&self) -> impl Iterator<Item = [u32; 2]> {
        self.pictures.values().filter(|picture| !picture.has_levels()).map(Picture::size)
    }

    /// Makes the coarser versions of all that have none.
    ///
    /// # Errors
    /// There is not enough memory.
    pub fn make_levels(&mut self) -> Result<(), SizeError> {
        let mut pictures = self.pictures.values_mut();
        pictures.try_for_each(|picture| match picture.has_levels() {
            true => Ok(()),
            false => picture.make_levels(),
        })
    }

    /// The colour of the tile that a place lies in, which ends at its own edges; none where there is no such tile.
    pub fn color(&self, sampling: Sampling, lookup: &Lookup) -> Option<[f32; 4]> {
        let [column, row] = [number(lookup.uv[0])?, number(lookup.uv[1])?];
        let picture = self.pictures.get(&[row, column])?;
        // Exact: what is left of a number without its whole part has no more digits.
        let uv = lookup.uv.map(|x| x - x.floor());
        picture.color(Sampling { wrap: [Wrap::Clamp; 2], ..sampling }, &Lookup { uv, ..*lookup })
    }
}

/// The tile along one axis; none below 0 and for what is not finite.
fn number(coordinate: f32) -> Option<u32> {
    let whole = f64::from(coordinate.floor());
    (0.0..=f64::from(u32::MAX)).contains(&whole).then_some(whole as u32)
}

#[cfg(test)]
mod tests {
    use phenomenon_compiler::effects::Filter;

    use super::*;
    use crate::film::Film;

    /// Tiles of two by two pixels at (0, 0), (1, 0) and (3, 12), each of its own grey, the right column with green.
    fn tiles() -> Tiles {
        let mut tiles = Tiles::default();
        for (number, tile) in [[0, 0], [1, 0], [3, 12]].into_iter().enumerate() {
            let mut film = Film::new(2, 2).unwrap();
            for (column, row) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                film.set(column, row, [(number + 1) as f32, column as f32, 0.0, 1.0]);
            }
            tiles.add(tile, Picture::new(film));
        }
        tiles
    }

    fn read(tiles: &Tiles, filter: Filter, uv: [f32; 2]) -> Option<[f32; 4]> {
        let footprint = [[0.25, 0.0], [0.0, 0.25]];
        let sampling = Sampling { wrap: [Wrap::Periodic, Wrap::Mirror], filter };
        tiles.color(sampling, &Lookup { uv, footprint, default: [7.0; 4] })
    }

    #[test]
    fn a_place_is_read_from_its_own_tile_up_to_the_edge() {
        let mut tiles = tiles();
        tiles.make_levels().unwrap();
        assert_eq!(tiles.sizes_without_levels().count(), 0);
        for filter in [Filter::Linear, Filter::Closest, Filter::Cubic, Filter::Footprint] {
            let red = |uv| read(&tiles, filter, uv).map(|color| color[0]);
            for uv in [[0.0, 0.0], [1.0_f32.next_down(), 0.999], [0.5, 1e-45]] {
                assert_eq!(red(uv), Some(1.0), "{filter:?} {uv:?}");
            }
            assert_eq!(red([1.0, 0.5]), Some(2.0));
            assert_eq!(red([3.999, 12.0]), Some(3.0));
        }
        // Beyond the middles of the outermost pixels nothing comes from the other side or the next tile.
        let green = |u| read(&tiles, Filter::Linear, [u, 0.5]).unwrap()[1];
        assert_eq!([green(0.1), green(0.5), green(0.9), green(1.1)], [0.0, 0.5, 1.0, 0.0]);
        assert_eq!(tiles.size(), Some([2, 2]));
    }

    #[test]
    fn where_there_is_no_tile_there_is_nothing() {
        let tiles = tiles();
        for uv in [
            [2.0, 0.0],
            [-1e-45, 0.5],
            [0.5, -0.5],
            [0.5, 1.0],
            [f32::NAN, 0.0],
            [0.0, f32::INFINITY],
            [f32::MAX, 0.0],
            [4e9, 4e9],
        ] {
            assert_eq!(read(&tiles, Filter::Linear, uv), None, "{uv:?}");
        }
        assert_eq!(read(&tiles, Filter::Linear, [-0.0, -0.0]).map(|color| color[0]), Some(1.0));
        assert_eq!(Tiles::default().size(), None);
    }
}
