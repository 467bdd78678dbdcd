//! Two pictures compared, in output steps.

use serde::Serialize;

use super::Picture;
use super::frame::full_scale;

/// How a picture differs from the exact one, in codes of a channel (output steps).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// The greatest difference of a channel.
    pub max_steps: u16,
    /// The mean of all differences, over pixels and channels.
    pub mean_steps: f64,
    /// How many pixels are off by 0, 1, 2, … steps, each by the channel that is off the most; no trailing zeros.
    pub pixels: Vec<u64>,
    /// The peak signal-to-noise ratio in dB over pixels and channels, `20 log10(full scale / RMS)`; none where the
    /// pictures are the same.
    pub psnr: Option<f64>,
    /// The difference of each pixel's channel that is off the most, row by row from the top.
    #[serde(skip)]
    pub steps: Vec<u16>,
}

impl Difference {
    /// Compares a picture with the exact one.
    ///
    /// # Panics
    /// On pictures of two sizes or depths.
    #[must_use]
    pub fn of(exact: &Picture, other: &Picture) -> Self {
        let same = |p: &Picture| (p.width, p.height, p.channel_bits);
        assert_eq!(same(exact), same(other), "pictures of one size");
        let (mut pixels, mut steps) = (vec![0u64; 1], Vec::with_capacity(exact.codes.len()));
        let (mut sum, mut squares) = (0u64, 0u64);
        for (a, b) in exact.codes.iter().zip(&other.codes) {
            let off = [0, 1, 2].map(|c| a[c].abs_diff(b[c]));
            sum += off.iter().map(|&d| u64::from(d)).sum::<u64>();
            squares += off.iter().map(|&d| u64::from(d) * u64::from(d)).sum::<u64>();
            let most = off.into_iter().max().unwrap_or(0);
            if pixels.len() <= usize::from(most) {
                pixels.resize(usize::from(most) + 1, 0);
            }
            pixels[usize::from(most)] += 1;
            steps.push(most);
        }
        let count = (3 * steps.len()) as f64;
        let full = full_scale(exact.channel_bits);
        let psnr = (squares > 0).then(|| 10.0 * libm::log10(full * full * count / squares as f64));
        let max_steps = (pixels.len() - 1) as u16;
        Self { max_steps, mean_steps: sum as f64 / count, pixels, psnr, steps }
    }
}
