//! Matcaps: a picture of a sphere with its light in it, which is looked up where x and y of a normal say, whatever the
//! light. The sphere touches the picture's sides.

use super::form::{Form, FormKind, FormSpec};
use super::texels::Samples;

/// Whether a pixel of a picture of so many along a side lies wholly on the sphere, its corners included.
fn is_inside(size: usize, [x, y]: [usize; 2]) -> bool {
    // In half pixels from the middle to the corner that is the furthest.
    let corner = |place: usize| (2 * place + 1).abs_diff(size) + 1;
    corner(x).pow(2) + corner(y).pow(2) <= size.pow(2)
}

/// The pixel that gives a pixel its colour: itself on the sphere, and beyond it the outermost one of the same direction
/// that lies wholly on it.
fn owner(size: usize, [x, y]: [usize; 2]) -> [usize; 2] {
    let middle = size as f64 / 2.0;
    let from_middle = [x, y].map(|place| place as f64 + 0.5 - middle);
    let length = libm::sqrt(from_middle[0] * from_middle[0] + from_middle[1] * from_middle[1]);
    // In quarters of a pixel from the rim.
    (0..2 * size)
        .map(|step| (middle - 0.25 * step as f64) / length)
        .map(|part| from_middle.map(|from| (middle + from * part).min(size as f64 - 0.5) as usize))
        .find(|&pixel| is_inside(size, pixel))
        .unwrap_or([x, y])
}

/// The form of a picture's samples, which are linear light with +y upwards: square, and so many along a side.
///
/// What is beside the sphere, and pixels on its rim that are mixed with that, have the colours of the rim, so that
/// nothing of a background is blended into a silhouette.
#[must_use]
pub fn form(size: usize, picture: Vec<[f32; 3]>) -> Form {
    let pixel = |place: usize| {
        let at = [place % size, place / size];
        let [x, y] = if is_inside(size, at) { at } else { owner(size, at) };
        picture[y * size + x]
    };
    let data = (0..size * size).map(pixel).collect();
    let spec = FormSpec { size, ..FormSpec::of(FormKind::Matcap) };
    spec.encode(&Samples { width: size, height: size, data }, 1.0)
}

/// The part of each of `from` equal cells in each of `to` along the same side, as places and weights: `to` is at most
/// `from`.
fn overlaps(from: usize, to: usize) -> Vec<Vec<(usize, f64)>> {
    let cell = |number: usize| {
        let (first, end) = (number * from, (number + 1) * from);
        let shared = |place: usize| end.min((place + 1) * to) - first.max(place * to);
        (first / to..end.div_ceil(to)).map(|place| (place, shared(place) as f64 / from as f64)).collect()
    };
    (0..to).map(cell).collect()
}

/// The mean of a matcap's picture over each of so many cells along a side, times an exposure; the picture itself where
/// it has no more pixels. Sums have one order on every machine, so that the samples are the same ones.
///
/// # Panics
/// On more cells than pixels.
#[must_use]
pub fn samples(form: &Form, size: usize, exposure: f64) -> Samples {
    let from = form.texels.width;
    assert!(size <= from, "no more cells than pixels");
    let cells = overlaps(from, size);
    let mean = |cell: &[(usize, f64)], at: &dyn Fn(usize) -> [f64; 3]| {
        cell.iter().fold([0.0; 3], |sum: [f64; 3], &(place, weight)| {
            let own = at(place);
            [0, 1, 2].map(|c| sum[c] + weight * own[c])
        })
    };
    let picture = form.texels.layer(0);
    let channels = |pixel: [f32; 4]| [pixel[0], pixel[1], pixel[2]].map(f64::from);
    let of_row = |row: &[[f32; 4]]| cells.iter().map(|cell| mean(cell, &|x| channels(row[x]))).collect();
    let rows: Vec<Vec<[f64; 3]>> = picture.chunks(from).map(of_row).collect();
    let of_cell = |cell: &[(usize, f64)], x: usize| mean(cell, &|y| rows[y][x]).map(|mean| (mean * exposure) as f32);
    let data = cells.iter().flat_map(|cell| (0..size).map(|x| of_cell(cell, x))).collect();
    Samples { width: size, height: size, data }
}
