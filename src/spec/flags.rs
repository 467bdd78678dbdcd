//! A spec as the flags that give it.

use toml::Value;

use super::{ImageFormName, Memory, ReflectanceFields, ShaderFields, SpecFields, TUSER_BITS};
use crate::fit::Objective;
use crate::method::keys::{Fields, Key};

/// The keys that say what a core is: they come first, whatever the defaults.
const FIRST: [&str; 6] = ["block", "reflectance", "reflectance-file", "method", "shininess", "material"];
/// The keys with semicolons in their values, which a shell would take for ends of the command.
const QUOTED: [&str; 4] = ["golden_inputs", "light_records", "light_colours", "parameters"];

impl SpecFields {
    /// The flags that give these fields where they differ from the defaults.
    pub(super) fn flags(&self) -> Vec<String> {
        let differing = self.values().into_iter().zip(self.defaults().values()).filter(|(own, default)| own != default);
        let given = differing.filter_map(|((key, value), _)| Some((key, value?)));
        let (first, rest): (Vec<_>, Vec<_>) = given.partition(|(key, _)| FIRST.contains(&key.flag().as_str()));
        first.into_iter().chain(rest).flat_map(|(key, value)| self.flags_of(key, &value)).collect()
    }

    /// What need not be given: the fields of a core of which only the [`FIRST`] keys and the shader's kind are said;
    /// those themselves, and everything where they alone make no core, must be.
    fn defaults(&self) -> Self {
        let of_file = self.reflectance.file.is_some();
        let of = |fields: Self| {
            let spec = if of_file { fields.resolve_with_stand_in() } else { fields.resolve() };
            spec.map(|spec| Self::from_spec(&spec)).unwrap_or_default()
        };
        let (model, front) = (self.shader.model, self.shader.front);
        let any = ReflectanceFields { model: self.reflectance.model.clone(), ..ReflectanceFields::default() };
        let plain = of(Self {
            block: self.block,
            method: self.method,
            shininess: self.shininess.clone(),
            material: self.material.clone(),
            image_form: self.image_form,
            reflectance: any.clone(),
            shader: ShaderFields { model, front, ..ShaderFields::default() },
            ..Self::default()
        });
        Self {
            name: of(Self { name: None, reflectance: any, ..self.clone() }).name,
            block: None,
            method: None,
            shininess: None,
            material: None,
            image_form: plain.image_form.filter(|&form| form == ImageFormName::Half),
            reflectance: match self.reflectance.file {
                Some(_) => ReflectanceFields::default(),
                None => ReflectanceFields { model: None, ..plain.reflectance },
            },
            // A core has these only together with keys that are no defaults.
            objective: Some(Objective::default()),
            memory: Some(Memory::Auto),
            tuser_bits: Some(*TUSER_BITS.start()),
            shader: ShaderFields { model: None, front: None, ..plain.shader },
            ..plain
        }
    }

    /// The flags of a key that has this value.
    fn flags_of(&self, key: Key, value: &Value) -> Vec<String> {
        let flag = format!("--{}", key.flag());
        match value {
            Value::Boolean(true) => vec![flag],
            Value::Boolean(false) => vec![flag + "=false"],
            _ if key.name == "material" => {
                let materials = self.material.iter().flatten();
                materials.map(|one| format!("{flag} {}={}", quoted(&one.name), one.shininess)).collect()
            }
            _ if QUOTED.contains(&key.name) => vec![format!("{flag} '{}'", text(value))],
            _ => vec![format!("{flag} {}", text(value))],
        }
    }
}

/// A value as its flag takes it.
fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Float(number) => number.to_string(),
        Value::Array(items) => {
            let between = if items.iter().any(Value::is_array) { ";" } else { "," };
            items.iter().map(text).collect::<Vec<_>>().join(between)
        }
        Value::Table(table) => {
            let pairs = table.iter().map(|(key, value)| format!("{key}={}", text(value)));
            pairs.collect::<Vec<_>>().join(";")
        }
        other => other.to_string(),
    }
}

/// A name as a shell takes it for one word.
fn quoted(name: &str) -> String {
    let is_plain = name.chars().all(|c| c.is_ascii_alphanumeric() || "-_.".contains(c));
    if is_plain { name.to_owned() } else { format!("'{}'", name.replace('\'', "'\\''")) }
}
