//! Texels: samples as codes, with a full scale for each band, and their bilinear look-up.

use std::fmt;
use std::str::FromStr;

use super::Rgb;

/// How a sample is stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Texel {
    /// As a floating-point number of 32 bits a channel.
    Float,
    /// As a code of so many bits a channel, 1 to 16: evenly spaced up to the full scale.
    Linear(u32),
    /// As a code of so many bits a channel, 1 to 16, of the square root: codes are interpolated and blended, and
    /// squared once at the end. The full scale is each band's largest sample, or one cap for all.
    Sqrt(u32, Option<f64>),
    /// As 5, 6 and 5 bits: evenly spaced where the form's default is, of the square root elsewhere.
    Packed565,
}

impl Texel {
    /// Bits of a texel.
    #[must_use]
    pub fn bits(self) -> u32 {
        match self {
            Self::Float => 96,
            Self::Linear(bits) | Self::Sqrt(bits, _) => 3 * bits,
            Self::Packed565 => 16,
        }
    }

    /// The largest code of each channel; none of floating-point texels.
    #[must_use]
    pub fn full(self) -> Option<[u32; 3]> {
        match self {
            Self::Float => None,
            Self::Linear(bits) | Self::Sqrt(bits, _) => Some([(1 << bits) - 1; 3]),
            Self::Packed565 => Some([31, 63, 31]),
        }
    }
}

impl FromStr for Texel {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || {
            format!(
                "`{text}` is no texel: `float`, `linear:8` or `sqrt:8` with 1 to 16 bits a channel, `sqrt:8:CAP` with \
                 one cap above 0, or `565`"
            )
        };
        let parts: Vec<&str> = text.split(':').collect();
        let bits = |text: &str| text.parse().ok().filter(|bits| (1..=16).contains(bits)).ok_or_else(wrong);
        let cap = |text: &str| text.parse().ok().filter(|cap: &f64| *cap > 0.0 && *cap <= 1e30).ok_or_else(wrong);
        match parts[..] {
            ["float"] => Ok(Self::Float),
            ["565"] => Ok(Self::Packed565),
            ["linear"] => Ok(Self::Linear(8)),
            ["sqrt"] => Ok(Self::Sqrt(8, None)),
            ["linear", count] => Ok(Self::Linear(bits(count)?)),
            ["sqrt", count] => Ok(Self::Sqrt(bits(count)?, None)),
            ["sqrt", count, top] => Ok(Self::Sqrt(bits(count)?, Some(cap(top)?))),
            _ => Err(wrong()),
        }
    }
}

impl fmt::Display for Texel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Float => write!(f, "float"),
            Self::Linear(bits) => write!(f, "linear:{bits}"),
            Self::Sqrt(bits, None) => write!(f, "sqrt:{bits}"),
            Self::Sqrt(bits, Some(cap)) => write!(f, "sqrt:{bits}:{cap}"),
            Self::Packed565 => write!(f, "565"),
        }
    }
}

/// Layers of samples, row by row, before they are coded.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    /// Samples a row.
    pub width: usize,
    /// Rows a layer.
    pub height: usize,
    /// The samples: layer by layer, row by row.
    pub data: Vec<[f32; 3]>,
}

/// Where the full scale of the codes comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Codes are linear unless told otherwise, up to 1 where they are; a layer is a band.
    Unit,
    /// Codes are of the square root unless told otherwise; each layer is a band and has its largest sample as its cap.
    Layer,
    /// The same with each row as a band.
    Row,
}

/// Layers of texels.
#[derive(Clone, Debug, PartialEq)]
pub struct Texels {
    /// Texels a row.
    pub width: usize,
    /// Rows a layer.
    pub height: usize,
    /// How they are stored.
    pub texel: Texel,
    /// Whether codes stand for square roots.
    root: bool,
    scale: Scale,
    /// The full scale of each band; 1 with floating-point texels.
    caps: Vec<f64>,
    /// Codes as parts of the largest code, or floating-point samples; the fourth number fills the vector register.
    codes: Vec<[f32; 4]>,
}

impl Texels {
    /// Samples as codes; each to the nearest, those above the full scale to the largest.
    #[must_use]
    pub fn encode(samples: &Samples, texel: Texel, scale: Scale) -> Self {
        let root = match texel {
            Texel::Sqrt(..) => true,
            Texel::Packed565 => scale != Scale::Unit,
            Texel::Float | Texel::Linear(_) => false,
        };
        let band = samples.width * if scale == Scale::Row { 1 } else { samples.height };
        let cap = |band: &[[f32; 3]]| match (texel, scale) {
            (Texel::Float, _) | (Texel::Linear(_) | Texel::Packed565, Scale::Unit) => 1.0,
            (Texel::Sqrt(_, Some(cap)), _) => cap,
            _ => f64::from(band.iter().flatten().copied().fold(0.0, f32::max)),
        };
        let caps: Vec<f64> = samples.data.chunks(band).map(cap).collect();
        let code = |(place, sample): (usize, &[f32; 3])| {
            let [r, g, b] = match texel.full() {
                None => *sample,
                Some(full) => {
                    let cap = caps[place / band];
                    [0, 1, 2].map(|c| {
                        let part = if cap > 0.0 { (f64::from(sample[c]) / cap).clamp(0.0, 1.0) } else { 0.0 };
                        let full = f64::from(full[c]);
                        (libm::round(full * if root { part.sqrt() } else { part }) / full) as f32
                    })
                }
            };
            [r, g, b, 0.0]
        };
        let codes = samples.data.iter().enumerate().map(code).collect();
        Self { width: samples.width, height: samples.height, texel, root, scale, caps, codes }
    }

    /// Texels from what a file says: codes as parts of the largest code, or floating-point samples, and the full scale
    /// of each band.
    ///
    /// # Panics
    /// If there are not as many texels or caps as the size says.
    #[must_use]
    pub fn from_codes(
        width: usize,
        height: usize,
        texel: Texel,
        scale: Scale,
        caps: Vec<f64>,
        codes: &[[f32; 3]],
    ) -> Self {
        let layers = codes.len() / (width * height);
        assert!(layers > 0 && codes.len() == layers * width * height, "whole layers");
        assert_eq!(caps.len(), layers * if scale == Scale::Row { height } else { 1 }, "a cap for each band");
        let root = matches!(texel, Texel::Sqrt(..)) || texel == Texel::Packed565 && scale != Scale::Unit;
        let codes = codes.iter().map(|&[r, g, b]| [r, g, b, 0.0]).collect();
        Self { width, height, texel, root, scale, caps, codes }
    }

    /// How many layers there are.
    #[must_use]
    pub fn layers(&self) -> usize {
        self.codes.len() / (self.width * self.height)
    }

    /// The codes of a layer as parts of the largest code, or its floating-point samples; the fourth number is 0.
    #[must_use]
    pub fn layer(&self, layer: usize) -> &[[f32; 4]] {
        &self.codes[layer * self.width * self.height..][..self.width * self.height]
    }

    /// All codes, layer by layer.
    #[must_use]
    pub fn codes(&self) -> &[[f32; 4]] {
        &self.codes
    }

    /// Whether codes stand for square roots, so that what was interpolated and blended is squared at the end.
    #[must_use]
    pub fn is_root(&self) -> bool {
        self.root
    }

    /// Where the full scale comes from.
    #[must_use]
    pub fn scale(&self) -> Scale {
        self.scale
    }

    /// The full scale of each band: a layer, or a row where [`Texels::scale`] says so.
    #[must_use]
    pub fn caps(&self) -> &[f64] {
        &self.caps
    }

    /// What a code of a band weighs in a blend: its full scale, or the root of it.
    #[must_use]
    pub fn weight(&self, band: usize) -> f64 {
        if self.root { self.caps[band].sqrt() } else { self.caps[band] }
    }

    /// What the codes of two layers, or rows, are multiplied by where they are blended, the second with the part `t`.
    #[must_use]
    pub fn weights(&self, [first, second]: [usize; 2], t: f64) -> [f64; 2] {
        [(1.0 - t) * self.weight(first), t * self.weight(second)]
    }

    /// The memory that they take, in KiB.
    #[must_use]
    pub fn kib(&self) -> f64 {
        self.codes.len() as f64 * f64::from(self.texel.bits()) / 8192.0
    }

    /// What the codes stand for: of floating-point texels the samples that they were made of.
    #[must_use]
    pub fn samples(&self) -> Samples {
        let band = self.width * if self.scale == Scale::Row { 1 } else { self.height };
        let sample = |(place, code): (usize, &[f32; 4])| {
            let cap = self.caps[place / band];
            let value = self.value([0, 1, 2].map(|c| f64::from(code[c])));
            value.map(|part| (cap * part) as f32)
        };
        let data = self.codes.iter().enumerate().map(sample).collect();
        Samples { width: self.width, height: self.height, data }
    }

    /// What a blend of codes stands for.
    #[must_use]
    #[inline]
    pub fn value(&self, blend: Rgb) -> Rgb {
        if self.root { blend.map(|code| code * code) } else { blend }
    }

    /// The codes of a layer interpolated at u, v from 0 to 1, whose texels have their centres at (i + 1/2)/width; past
    /// the outermost centres they stay.
    #[must_use]
    pub fn bilinear(&self, layer: usize, u: f64, v: f64) -> Rgb {
        let texels = self.layer(layer);
        let (x, x2, s) = held(u, self.width);
        let (y, y2, t) = held(v, self.height);
        let mix = |a: Rgb, b: Rgb, t: f64| [0, 1, 2].map(|c| a[c] * (1.0 - t) + b[c] * t);
        let at = |x: usize, y: usize| {
            let [r, g, b, _] = texels[y * self.width + x];
            [r, g, b].map(f64::from)
        };
        mix(mix(at(x, y), at(x2, y), s), mix(at(x, y2), at(x2, y2), s), t)
    }
}

/// The two neighbouring texels of a coordinate from 0 to 1, and the weight of the second.
fn held(u: f64, count: usize) -> (usize, usize, f64) {
    let place = (u * count as f64 - 0.5).clamp(0.0, (count - 1) as f64);
    let low = (place as usize).min(count.saturating_sub(2));
    (low, (low + 1).min(count - 1), place - low as f64)
}

/// Two neighbouring layers and how an angle lies between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The layer at or below the angle; the first one below the first angle.
    pub first: usize,
    /// The next one, unless the angle is at or past the last, or before the first.
    pub second: Option<usize>,
    /// The weight of the second.
    pub t: f64,
}

/// The layers that an angle lies between; the angles ascend.
#[must_use]
pub fn pair(angles: &[f64], angle: f64) -> Pair {
    let above = angles.partition_point(|&one| one <= angle);
    match above.checked_sub(1) {
        Some(first) if above < angles.len() => {
            let t = (angle - angles[first]) / (angles[above] - angles[first]);
            Pair { first, second: Some(above), t }
        }
        first => Pair { first: first.unwrap_or(0), second: None, t: 0.0 },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_surround_their_angle() {
        let angles = [10.0, 45.0, 90.0];
        assert_eq!(pair(&angles, 3.0), Pair { first: 0, second: None, t: 0.0 });
        assert_eq!(pair(&angles, 10.0), Pair { first: 0, second: Some(1), t: 0.0 });
        assert_eq!(pair(&angles, 67.5), Pair { first: 1, second: Some(2), t: 0.5 });
        for past in [90.0, 180.0] {
            assert_eq!(pair(&angles, past), Pair { first: 2, second: None, t: 0.0 });
        }
        assert_eq!(pair(&[0.0], 0.0), Pair { first: 0, second: None, t: 0.0 });
    }
}
