//! Radiance's HDR: headers, orientations, run lengths.

use phenomenon_runtime::film::read;

use crate::files::{Folder, picture, refused};

const START: &str = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

/// 1, 0.5 and 0.25 of a power of two.
const PIXEL: [u8; 4] = [128, 64, 32, 129];

fn file(start: &str, resolution: &str, pixels: &[u8]) -> Vec<u8> {
    [start.as_bytes(), resolution.as_bytes(), b"\n", pixels].concat()
}

#[test]
fn headers_of_other_programs_are_read() {
    for start in [
        START,
        "#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n",
        "#?RGBE\n\n",
        "#?RADIANCE\n# made by hand\nrpict -vp 0 0 1\nVIEW= -vtv\nPRIMARIES=.64 .33\nPIXASPECT=1\nFORMAT = 32-bit_rle_rgbe\nGAMMA=1.0\n\n",
        "#?PHOTOGRAPH\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n",
        "#?RADIANCE\nSOFTWARE=\u{fc}\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n\n",
    ] {
        let film = picture("a.hdr", &file(start, "-Y 1 +X 1", &PIXEL));
        assert_eq!(film.pixel(0, 0), [1.0, 0.5, 0.25, 1.0], "{start}");
    }
}

#[test]
fn exposures_and_corrections_are_divided_by() {
    for (lines, expected) in [
        ("EXPOSURE=2\n", [0.5, 0.25, 0.125]),
        ("EXPOSURE=4\nEXPOSURE=0.25\n", [1.0, 0.5, 0.25]),
        ("EXPOSURE= 1e1 \nEXPOSURE=.2\n", [0.5, 0.25, 0.125]),
        ("COLORCORR=1 2 4\n", [1.0, 0.25, 0.0625]),
        ("COLORCORR= 0.5 0.5 0.5\nEXPOSURE=2\nCOLORCORR=1 1 0.5\n", [1.0, 0.5, 0.5]),
        ("# EXPOSURE=7\nview EXPOSURED\n", [1.0, 0.5, 0.25]),
    ] {
        let start = format!("#?RADIANCE\n{lines}FORMAT=32-bit_rle_rgbe\n\n");
        let film = picture("a.hdr", &file(&start, "-Y 1 +X 1", &PIXEL));
        assert_eq!(film.pixel(0, 0)[..3], expected, "{lines}");
    }
    for lines in [
        "EXPOSURE=0\n",
        "EXPOSURE=-1\n",
        "EXPOSURE=x\n",
        "EXPOSURE=NaN\n",
        "EXPOSURE=inf\n",
        "COLORCORR=1 1\n",
        "COLORCORR=1 1 1 1\n",
        "EXPOSURE=1e-300\nEXPOSURE=1e-300\n",
    ] {
        let start = format!("#?RADIANCE\n{lines}FORMAT=32-bit_rle_rgbe\n\n");
        let said = refused("a.hdr", &file(&start, "-Y 1 +X 1", &PIXEL));
        assert!(said.contains(&lines[..8]), "{lines}: {said}");
    }
}

#[test]
fn what_is_not_read_is_refused_with_its_reason() {
    for (start, resolution, reason) in [
        ("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n", "-Y 1 +X 1", "XYZ"),
        ("#?RADIANCE\nFORMAT=16-bit\n\n", "-Y 1 +X 1", "FORMAT=16-bit"),
        ("#?TEXT\n\n", "-Y 1 +X 1", "FORMAT=32-bit_rle_rgbe"),
        ("#?RGBE\nGAMMA=2.2\n\n", "-Y 1 +X 1", "GAMMA"),
        ("RADIANCE\n\n", "-Y 1 +X 1", "does not begin"),
        ("", "", "does not begin"),
        (START, "1 1", "`1 1`"),
        (START, "-Y 1 -Y 1", "resolution"),
        (START, "-Y 1 +X", "resolution"),
        (START, "-Y 1 +X 1 +Z 1", "resolution"),
        (START, "-Y 99999999999 +X 1", "resolution"),
        (START, "-Y -1 +X 1", "resolution"),
        (START, "-Y 0 +X 1", "0 pixels"),
        (START, "-Y 65537 +X 1", "65537"),
        (START, "-Y 60000 +X 60000", "60000 x 60000"),
        ("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "", "too early"),
    ] {
        let said = refused("a.hdr", &file(start, resolution, &PIXEL));
        assert!(said.contains(reason), "{start}{resolution}: {said}");
    }
}

/// Two by three pixels in the order of the file: their numbers are exponents from 129 on.
#[test]
fn all_eight_orientations_are_read() {
    let pixels: Vec<u8> = (0..6).flat_map(|at| [128, 0, 0, 129 + at]).collect();
    // Rows from the top, of a picture three wide and two high, or turned.
    for (resolution, rows) in [
        ("-Y 2 +X 3", vec![[0, 1, 2], [3, 4, 5]]),
        ("-Y 2 -X 3", vec![[2, 1, 0], [5, 4, 3]]),
        ("+Y 2 +X 3", vec![[3, 4, 5], [0, 1, 2]]),
        ("+Y 2 -X 3", vec![[5, 4, 3], [2, 1, 0]]),
        ("+X 3 -Y 2", vec![[0, 2, 4], [1, 3, 5]]),
        ("-X 3 -Y 2", vec![[4, 2, 0], [5, 3, 1]]),
        ("+X 3 +Y 2", vec![[1, 3, 5], [0, 2, 4]]),
        ("-X 3 +Y 2", vec![[5, 3, 1], [4, 2, 0]]),
    ] {
        let film = picture("a.hdr", &file(START, resolution, &pixels));
        assert_eq!((film.width(), film.height()), (3, 2), "{resolution}");
        for (row, expected) in rows.iter().enumerate() {
            for (column, at) in expected.iter().enumerate() {
                let red = film.pixel(column as u32, row as u32)[0];
                assert_eq!(red, 2.0_f32.powi(*at), "{resolution} {column} {row}");
            }
        }
    }
}

#[test]
fn flat_pixels_and_both_kinds_of_runs_are_read() {
    let flat: Vec<u8> = [PIXEL; 8].concat();
    let old = [PIXEL.to_vec(), vec![1, 1, 1, 7]].concat();
    let new = [
        vec![2, 2, 0, 8],
        vec![136, 128],
        vec![8, 64, 64, 64, 64, 64, 64, 64, 64],
        vec![131, 32, 2, 32, 32, 131, 32],
        vec![129, 129, 135, 129],
    ];
    for pixels in [flat, old, new.concat()] {
        let film = picture("a.hdr", &file(START, "-Y 1 +X 8", &pixels));
        assert!(film.pixels().iter().all(|pixel| *pixel == [1.0, 0.5, 0.25, 1.0]), "{pixels:?}");
    }
    // A run of 0x101: its low byte, then its high one; and a pixel that only looks like a new run.
    let pixels = [vec![2, 2, 128, 130], vec![1, 1, 1, 1], vec![1, 1, 1, 1], PIXEL.to_vec()];
    let film = picture("a.hdr", &file(START, "-Y 1 +X 259", &pixels.concat()));
    assert_eq!(film.pixel(257, 0), film.pixel(0, 0));
    assert_eq!(film.pixel(258, 0)[0], 1.0);
}

#[test]
fn runs_that_do_not_fit_are_refused() {
    for (width, pixels) in [
        (8, vec![1, 1, 1, 8]),
        (8, [PIXEL.to_vec(), vec![1, 1, 1, 8]].concat()),
        (4, [PIXEL.to_vec(), vec![1, 1, 1, 0, 1, 1, 1, 255]].concat()),
        (4, [PIXEL.to_vec(), [[1, 1, 1, 0]; 5].concat(), vec![1, 1, 1, 1]].concat()),
        (8, vec![2, 2, 0, 8, 137, 1]),
        (8, vec![2, 2, 0, 8, 0]),
        (8, vec![2, 2, 0, 8, 4, 1, 2, 3, 4, 5, 1, 2, 3, 4, 5]),
        (8, vec![2, 2, 0, 9, 137, 1]),
    ] {
        let said = refused("a.hdr", &file(START, &format!("-Y 1 +X {width}"), &pixels));
        assert!(said.contains("scanline"), "{pixels:?}: {said}");
    }
}

#[test]
fn a_file_that_is_cut_is_refused_wherever_it_is() {
    let folder = Folder::new();
    let new = [vec![2, 2, 0, 8], vec![136, 128], vec![136, 64], vec![136, 32], vec![136, 129]];
    let whole = file(START, "-Y 1 +X 8", &new.concat());
    read(&folder.file("a.hdr", &whole)).unwrap();
    for length in 0..whole.len() {
        let error = read(&folder.file("a.hdr", &whole[..length])).unwrap_err().to_string();
        assert!(error.contains("a.hdr"), "{length}: {error}");
    }
}
