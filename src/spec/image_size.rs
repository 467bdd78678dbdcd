//! The sizes of an image-based block that follow from what its pictures may miss.

use super::{ImageFormName, SpecFields};
use crate::block::image::quality::SphereError;
use crate::block::image::{Image, ImageBlock, SIZE, SLICES, TEXEL_BITS};
use crate::platform::error::Error;
use crate::reflectance::Source;

/// The greatest size that is sought: larger ones take more memory than most devices have.
const LARGEST: u32 = 128;

/// The powers of two in a range.
fn powers(first: u32, last: u32) -> Vec<u32> {
    (first.ilog2()..=last.ilog2()).map(|power| 1 << power).collect()
}

/// The bits of a block's texels.
fn texel_bits(image: &Image) -> u64 {
    image.extents().iter().map(|&extent| u64::from(extent)).product::<u64>() * 3 * u64::from(image.texel_bits)
}

/// What the pictures of a block may miss.
#[derive(Clone, Copy, Debug)]
pub(super) struct PictureBudget {
    /// Their least mean ratio in dB.
    pub(super) min_psnr: Option<f64>,
    /// The greatest error of a channel, in parts of full scale.
    pub(super) max_error: Option<f64>,
}

impl PictureBudget {
    pub(super) fn is_empty(&self) -> bool {
        self.min_psnr.is_none() && self.max_error.is_none()
    }

    fn check(&self) -> Result<(), Error> {
        if let Some(least) = self.min_psnr.filter(|least| !(*least > 0.0 && least.is_finite())) {
            let what = format!("min_psnr = {least} is out of range");
            return Err(Error::input(what, "a number of dB above 0, as in 45.0"));
        }
        match self.max_error.filter(|most| !(*most > 0.0 && *most < 1.0)) {
            Some(most) => Err(Error::input(format!("max_error = {most} is out of range"), "above 0 and below 1")),
            None => Ok(()),
        }
    }

    /// How far from being kept it is: below 1 where it is not.
    fn kept(&self, SphereError { quality, greatest }: &SphereError) -> f64 {
        let ratio = self.min_psnr.map_or(f64::INFINITY, |least| quality.mean / least);
        ratio.min(self.max_error.map_or(f64::INFINITY, |most| most / greatest))
    }
}

impl std::fmt::Display for PictureBudget {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let both = if self.min_psnr.is_some() && self.max_error.is_some() { " and " } else { "" };
        let psnr = self.min_psnr.map_or_else(String::new, |least| format!("min_psnr = {least}"));
        let error = self.max_error.map_or_else(String::new, |most| format!("max_error = {most}"));
        write!(f, "{psnr}{both}{error}")
    }
}

impl SpecFields {
    /// The keys with each of these numbers of images, and with none, sizes and bits of a texel, where they say none of
    /// their own. A form with a number of images refuses some of them, as one without does.
    pub(crate) fn with_image_sizes(&self, images: &[u32], sizes: &[u32], texel_bits: &[u32]) -> Vec<Self> {
        let given = |key: Option<u32>, all: &[u32]| key.map_or_else(|| all.to_vec(), |key| vec![key]);
        let counts = given(self.images, images).into_iter().map(Some);
        let counts = counts.chain(self.images.is_none().then_some(None));
        let (sizes, bits) = (given(self.image_size, sizes), given(self.texel_bits, texel_bits));
        let mut all = Vec::new();
        for images in counts {
            for &size in &sizes {
                let of_size = Self { images, image_size: Some(size), ..self.clone() };
                all.extend(bits.iter().map(|&bits| Self { texel_bits: Some(bits), ..of_size.clone() }));
            }
        }
        all
    }

    /// The blocks with the most bits of a texel that are sought of each number of images and size, those of the fewest
    /// texels first.
    fn shapes(&self) -> Result<Vec<Image>, Error> {
        let (images, sizes) = (powers(*SLICES.start(), *SLICES.end()), powers(*SIZE.start(), LARGEST));
        let (mut shapes, mut refused) = (Vec::<Image>::new(), None);
        for own in self.with_image_sizes(&images, &sizes, &[*TEXEL_BITS.end()]) {
            match own.image() {
                Ok(image) if !shapes.contains(&image) => shapes.push(image),
                Ok(_) => {}
                Err(error) => refused = Some(error),
            }
        }
        shapes.sort_by_key(texel_bits);
        match refused {
            Some(error) if shapes.is_empty() => Err(error),
            _ => Ok(shapes),
        }
    }

    /// The block with the fewest bits of texels whose pictures of a sphere keep a budget against the reflectance
    /// itself, as [`ImageBlock::sphere_error`] measures them. A number of images and a size whose pictures miss it
    /// with the most bits a texel are passed over.
    ///
    /// # Errors
    /// A budget that is out of range or that no block keeps, a reflectance that cannot be read, keys that no block has.
    pub(super) fn smallest_image(&self, budget: PictureBudget) -> Result<Image, Error> {
        budget.check()?;
        let (source, exposure) = self.reflectance.source(self.image_form == Some(ImageFormName::Matcap))?;
        let measured = |image: &Image| -> Result<SphereError, Error> {
            match (&source, source.reflectance()) {
                (Source::Images(picture), _) => {
                    let block = ImageBlock::of_picture(image.clone(), picture, exposure)?;
                    Ok(block.matcap_error(picture, exposure))
                }
                (_, reflectance) => {
                    let reflectance = reflectance.expect("images alone have none");
                    Ok(ImageBlock::new(image.clone(), reflectance, exposure)?.sphere_error(reflectance, exposure))
                }
            }
        };
        // A picture has no more texels than pixels.
        let fits = |shape: &Image| match &source {
            Source::Images(picture) => self.image_size.is_some() || shape.size as usize <= picture.spec.size,
            Source::Table(_) | Source::Model(_) => true,
        };
        let (mut best, mut nearest): (Option<Image>, Option<(SphereError, Image)>) = (None, None);
        for shape in self.shapes()?.into_iter().filter(fits) {
            let fewest = self.texel_bits.unwrap_or(*TEXEL_BITS.start());
            let with = |bits: u32| Image { texel_bits: bits, ..shape.clone() };
            // With the fewest bits it is no smaller than what there is.
            if best.as_ref().is_some_and(|best| texel_bits(&with(fewest)) >= texel_bits(best)) {
                continue;
            }
            let reached = measured(&shape)?;
            if budget.kept(&reached) < 1.0 {
                if nearest.as_ref().is_none_or(|(nearest, _)| budget.kept(&reached) > budget.kept(nearest)) {
                    nearest = Some((reached, shape));
                }
                continue;
            }
            for bits in fewest..=shape.texel_bits {
                let image = with(bits);
                if best.as_ref().is_some_and(|best| texel_bits(&image) >= texel_bits(best)) {
                    break;
                }
                if bits == shape.texel_bits || budget.kept(&measured(&image)?) >= 1.0 {
                    best = Some(image);
                    break;
                }
            }
        }
        best.ok_or_else(|| {
            let nearest = nearest.map_or_else(String::new, |(SphereError { quality, greatest }, image)| {
                format!(": the nearest, {image}, has {:.1} dB and errors up to {greatest:.3}", quality.mean)
            });
            Error::input(
                format!("no image-based block of these keys keeps {budget}{nearest}"),
                "a lower min_psnr or a greater max_error, another image_form, or fewer keys that narrow it (images, \
                 image_size, texel_bits, weight_bits, vector_bits, output_bits)",
            )
        })
    }
}
