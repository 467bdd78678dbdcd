//! A form as a directory: its images, and an index in TOML that reads back.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::json;
use sha2::{Digest, Sha256};

use super::form::{Form, FormKind, FormSpec};
use super::images::{self, Pixels};
use super::paper::Border;
use super::texels::{Scale, Texel, Texels};
use crate::platform::error::{Error, refuse};
use crate::platform::input;

/// The index's file name.
pub const INDEX: &str = "images.toml";
/// How an index begins.
pub const MARK: &str = "# brdfgen sphere images";

/// The index.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Index {
    form: String,
    size: usize,
    texel: String,
    exposure: f64,
    /// The octaves of 1 - n·h that the columns of `bivariate` lie along; without them they lie along √θh.
    #[serde(skip_serializing_if = "Option::is_none")]
    octaves: Option<u32>,
    /// How the paper's images are looked up.
    #[serde(skip_serializing_if = "Option::is_none")]
    border: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    behind: Option<String>,
    image: Vec<Entry>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    file: String,
    /// The light's angle in degrees.
    phi: f64,
    /// The full scale of the codes: one, or one for each row from the bottom.
    caps: Vec<f64>,
}

/// The files of a form: names and bytes, then the index and the list of all of them, by which the next run knows those
/// that it no longer writes.
///
/// # Errors
/// A picture that is too large for its format.
pub fn files(form: &Form) -> Result<Vec<(String, Vec<u8>)>, Error> {
    let mut files = images(form, None)?;
    files.push(manifest(&files));
    Ok(files)
}

/// The images of a form and their index, the last of them. The columns of `bivariate` lie along so many octaves of
/// 1 - n·h, or along √θh.
///
/// # Errors
/// As [`files`].
pub fn images(form: &Form, octaves: Option<u32>) -> Result<Vec<(String, Vec<u8>)>, Error> {
    let Form { spec, exposure, texels } = form;
    let mut files = Vec::new();
    let mut entries = Vec::new();
    let bands = if texels.scale() == Scale::Row { texels.height } else { 1 };
    for (layer, &phi) in spec.angles.iter().enumerate() {
        let (suffix, bytes) = match texels.texel.full() {
            None => {
                let mut pixels: Vec<[f32; 3]> = texels.layer(layer).iter().map(|&[r, g, b, _]| [r, g, b]).collect();
                images::flip(texels.width, &mut pixels);
                ("exr", images::exr(texels.width, &pixels)?)
            }
            Some(full) => {
                let depth = if full.iter().all(|&full| full < 256) { 8 } else { 16 };
                let top = ((1u32 << depth) - 1) as f32;
                let code = |part: f32| (part * top).round() as u16;
                let mut codes: Vec<[u16; 3]> =
                    texels.layer(layer).iter().map(|&[r, g, b, _]| [r, g, b].map(code)).collect();
                images::flip(texels.width, &mut codes);
                let gamma = Some(if texels.is_root() { 0.5 } else { 1.0 });
                let pixels = Pixels { width: texels.width, height: texels.height, depth, gamma, codes };
                ("png", images::png(&pixels))
            }
        };
        let file = format!("{:03}_phi_{}.{suffix}", layer, (phi * 1e3).round() / 1e3);
        let caps = texels.caps()[layer * bands..][..bands].to_vec();
        entries.push(Entry { file: file.clone(), phi, caps });
        files.push((file, bytes));
    }
    let paper = spec.kind == FormKind::Paper;
    let index = Index {
        form: spec.kind.name().to_owned(),
        size: spec.size,
        texel: spec.texel.to_string(),
        exposure: *exposure,
        octaves,
        border: paper.then(|| spec.options.border.to_string()),
        behind: paper.then(|| spec.options.behind.to_string()),
        image: entries,
    };
    let text = toml::to_string(&index).expect("plain values");
    files.push((INDEX.to_owned(), format!("{MARK}: {spec}\n{text}").into_bytes()));
    Ok(files)
}

fn manifest(files: &[(String, Vec<u8>)]) -> (String, Vec<u8>) {
    let digest = |(path, bytes): &(String, Vec<u8>)| {
        let hex = Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect::<String>();
        (path.clone(), json!(hex))
    };
    let digests: serde_json::Map<String, serde_json::Value> = files.iter().map(digest).collect();
    let text = serde_json::to_string_pretty(&json!({ "generator": "brdfgen", "files_sha256": digests }));
    ("manifest.json".to_owned(), (text.expect("JSON of plain values") + "\n").into_bytes())
}

/// What an index says, before its images are read.
#[derive(Debug)]
pub struct Listed {
    spec: FormSpec,
    exposure: f64,
    octaves: Option<u32>,
    files: Vec<String>,
    caps: Vec<f64>,
}

/// Reads an index; `name` is the file's, for messages.
///
/// # Errors
/// What is no such index, with its place; values out of range; files that are not in the index's directory.
pub fn parse(text: &str, name: &str) -> Result<Listed, Error> {
    let index: Index = toml::from_str(text).map_err(|error| {
        let span = error.span().unwrap_or(0..0);
        let allowed = "an index of sphere images as `brdfgen reflectance images` writes it";
        Error::text(error.message(), allowed, name, text, (span.start, span.len()))
    })?;
    let wrong = |what: String, allowed: &str| Error::input(format!("{name}: {what}"), allowed);
    let said = |what: String| wrong(what, "an index as `brdfgen reflectance images` writes it");
    let kind: FormKind = index.form.parse().map_err(said)?;
    let texel: Texel = index.texel.parse().map_err(said)?;
    let mut options = kind.options();
    if let Some(border) = &index.border {
        options.border = border.parse::<Border>().map_err(said)?;
    }
    if let Some(behind) = &index.behind {
        options.behind = behind.parse().map_err(said)?;
    }
    let angles: Vec<f64> = index.image.iter().map(|entry| entry.phi).collect();
    let spec = FormSpec { kind, angles, size: index.size, texel, options };
    spec.check()?;
    if !(index.exposure > 0.0 && index.exposure.is_finite()) {
        return Err(wrong(format!("exposure = {}", index.exposure), "a number above 0"));
    }
    if matches!(kind, FormKind::Bivariate | FormKind::Matcap) && index.image.len() != 1 {
        return Err(wrong(format!("{} images of the form `{}`", index.image.len(), kind.name()), "that form has one"));
    }
    if index.octaves.is_some() && kind != FormKind::Bivariate {
        return Err(wrong(format!("octaves of the form `{}`", kind.name()), "they are of the form `bivariate`"));
    }
    let bands = if kind.scale() == Scale::Row { index.size } else { 1 };
    let mut caps = Vec::new();
    for Entry { file, caps: own, .. } in &index.image {
        let plain = !file.is_empty() && !file.contains(['/', '\\', '\0']) && file != "." && file != "..";
        if !plain {
            return Err(wrong(
                format!("the file `{file}`"),
                "images lie beside the index: give a name without a directory",
            ));
        }
        if own.len() != bands {
            return Err(wrong(format!("{file} has {} caps", own.len()), &format!("it needs {bands}")));
        }
        if let Some(cap) = own.iter().find(|cap| !(0.0..=f64::from(f32::MAX)).contains(*cap)) {
            return Err(wrong(format!("{file} has the cap {cap}"), "caps are finite and not negative"));
        }
        caps.extend(own);
    }
    let files = index.image.into_iter().map(|entry| entry.file).collect();
    Ok(Listed { spec, exposure: index.exposure, octaves: index.octaves, files, caps })
}

/// Reads a directory of sphere images.
///
/// # Errors
/// As [`read_with_octaves`]; images whose columns lie along octaves, as only a core looks them up.
pub fn read(directory: &Path) -> Result<Form, Error> {
    let (form, octaves) = read_with_octaves(directory)?;
    refuse!(
        octaves.is_some(),
        format!("the columns of {} lie along octaves of 1 - n.h", directory.display()),
        "only an image-based core is made of such samples (generate --block image --reflectance-file); those of \
         `brdfgen reflectance images` lie along the root of θh"
    );
    Ok(form)
}

/// Reads a directory of sphere images, and how many octaves of 1 - n·h the columns of `bivariate` lie along; none
/// where it is √θh.
///
/// # Errors
/// As [`parse`]; a file that is missing, no picture, of another size or depth than the index says.
pub fn read_with_octaves(directory: &Path) -> Result<(Form, Option<u32>), Error> {
    let path = directory.join(INDEX);
    refuse!(
        !path.is_file(),
        format!("{} has no {INDEX}", directory.display()),
        "a directory of sphere images as `brdfgen reflectance images` writes it"
    );
    let text = input::read_text(&path, "an index of sphere images is a TOML file")?;
    let name = path.display().to_string();
    let Listed { spec, exposure, octaves, files, caps } = parse(&text, &name)?;
    let mut codes = Vec::with_capacity(files.len() * spec.size * spec.size);
    for file in &files {
        let path = directory.join(file);
        refuse!(
            !path.is_file(),
            format!("{name} lists {file}, which is not there"),
            "all images of an index lie beside it: make them anew, or copy the whole directory"
        );
        let bytes = input::read(&path, images::MAX_PICTURE)?;
        let (width, mut image) = image(&bytes, &path.display().to_string(), spec.texel)?;
        refuse!(
            width != spec.size || image.len() != spec.size * spec.size,
            format!("{} has {width} × {} pixels", path.display(), image.len() / width),
            format!("{INDEX} says {} × {}", spec.size, spec.size)
        );
        images::flip(width, &mut image);
        codes.extend(image);
    }
    let texels = Texels::from_codes(spec.size, spec.size, spec.texel, spec.kind.scale(), caps, &codes);
    Ok((Form { spec, exposure, texels }, octaves))
}

/// The codes of an image's file as parts of the largest one, rows from the top, and the pixels a row.
fn image(bytes: &[u8], name: &str, texel: Texel) -> Result<(usize, Vec<[f32; 3]>), Error> {
    let Some(full) = texel.full() else {
        let (width, _, pixels) = images::read_exr(bytes, name)?;
        return Ok((width, pixels));
    };
    let Pixels { width, depth, codes, .. } = images::read_png(bytes, name)?;
    let top = f64::from((1u32 << depth) - 1);
    // The nearest of the texel's own codes.
    let part = |code: u16, full: u32| {
        let full = f64::from(full);
        (libm::round(f64::from(code) / top * full) / full) as f32
    };
    Ok((width, codes.iter().map(|code| [0, 1, 2].map(|c| part(code[c], full[c]))).collect()))
}
