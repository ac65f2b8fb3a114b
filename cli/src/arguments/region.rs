//! `--region X,Y,W,H`.

use phenomenon_runtime::film::SIDE_LIMIT;
use phenomenon_runtime::render::Region;

use super::numbers::count;

/// Reads `--region`; whether it lies in the picture is known once its size is.
pub fn region(text: &str) -> Result<Region, String> {
    let remedy =
        "write X,Y,WIDTH,HEIGHT in pixels from the upper left corner, such as 128,96,64,64";
    let numbers: Vec<u32> = text
        .split(',')
        .take(5)
        .map(|part| count(part, 0..=SIDE_LIMIT, "a number of pixels"))
        .collect::<Result<_, _>>()
        .map_err(|_| remedy.to_owned())?;
    match numbers.as_slice() {
        [_, _, 0, _] | [_, _, _, 0] => Err(format!("a region without pixels; {remedy}")),
        &[x, y, width, height] => Ok(Region { x, y, width, height }),
        _ => Err(remedy.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_are_read() {
        assert_eq!(region("1,2,3,4"), Ok(Region { x: 1, y: 2, width: 3, height: 4 }));
        assert_eq!(region("0, 0, 1e2, 4.0"), Ok(Region { x: 0, y: 0, width: 100, height: 4 }));
        for text in
            ["", "1,2,3", "1,2,3,4,5", "0,0,0,1", "0,0,1,0", "-1,0,1,1", "0,0,65537,1", "0x0,0,1,1"]
        {
            assert!(region(text).unwrap_err().contains("128,96,64,64"), "{text}");
        }
    }
}
