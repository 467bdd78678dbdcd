//! From what was written to a core's spec, with every default and every check, and back.

use super::{
    Block, BlockKind, CoreSpec, Cosine, DspBlocks, Form, INPUT_FRACTION, ImageSpec, InputRange, Interface, Language,
    LightSource, LobeSpec, Material, OUTPUT_FRACTION, Operand, PIPELINE_DEPTH, Pipeline, RomStyle, SHININESS_FRACTION,
    Shader, ShaderFields, Shininess, SpecFields, TUSER_BITS, VhdlPorts, check_name, image,
};
use crate::emit::rom::RomFormat;
use crate::method::{About, Configured, Options, within};
use crate::platform::error::{Error, refuse};

impl SpecFields {
    /// Fills in the defaults and checks every value.
    ///
    /// # Errors
    /// Names the value that is wrong and what is allowed.
    pub fn resolve(self) -> Result<CoreSpec, Error> {
        self.resolve_with(Self::resolved_image)
    }

    /// As [`SpecFields::resolve`], with a stand-in for what an image-based block reflects, whatever the keys say of
    /// that: for where it does not matter.
    pub(crate) fn resolve_with_stand_in(self) -> Result<CoreSpec, Error> {
        self.resolve_with(Self::image_of_stand_in)
    }

    fn resolve_with(self, image_of: impl Fn(&Self) -> Result<ImageSpec, Error>) -> Result<CoreSpec, Error> {
        self.check_block()?;
        let (texel_latency, swap) = (self.resolved_texel_latency()?, self.resolved_swap()?);
        let (block, default_name) = match self.block {
            Some(BlockKind::Image) => {
                let image = image_of(&self)?;
                let name = image::default_name(&image.image);
                (Block::Image(image), name)
            }
            _ => self.resolved_around_lobe()?,
        };
        if let Some(Pipeline::Depth(depth)) = self.pipeline {
            within("pipeline", depth, PIPELINE_DEPTH)?;
        }
        let axi_stream = self.resolved_axi_stream()?;
        let light_source = self.resolved_light_source(&block)?;
        let rom = self.resolved_rom(&block);
        let name = self.name.unwrap_or(default_name);
        check_name(&name)?;
        let languages = resolved_languages(self.languages)?;
        let vhdl_ports = self.vhdl_ports.unwrap_or_default();
        if self.vhdl_ports.is_some() && !languages.contains(&Language::Vhdl) {
            return Err(Error::input(
                "vhdl_ports is given for a core without VHDL",
                "add vhdl to languages, or leave vhdl_ports out",
            ));
        }
        let mut rom_formats = self.rom_formats.unwrap_or_default();
        rom_formats.push(RomFormat::Mem);
        rom_formats.sort_unstable();
        rom_formats.dedup();
        Ok(CoreSpec {
            name,
            block,
            rom,
            texel_latency,
            swap,
            rom_formats,
            pipeline: self.pipeline.unwrap_or(Pipeline::Auto),
            dsp: self.dsp.unwrap_or_default(),
            languages,
            vhdl_ports,
            axi_stream,
            light_source,
            light_records: self.light_records.unwrap_or_default(),
            golden_inputs: self.golden_inputs.unwrap_or_default(),
        })
    }

    /// A lobe, alone or in a shader, and what its core is called whose spec has no name.
    fn resolved_around_lobe(&self) -> Result<(Block, String), Error> {
        let Some(method) = self.method else {
            return Err(Error::input(
                "no method is given",
                "give --method quadratic, --method cubic or another, or a spec file",
            ));
        };
        let shader = self.resolved_shader()?;
        let (operand, input_range) = self.resolved_operand(shader.as_ref())?;
        let set = self.given_set(shader.as_ref())?;
        let form = self.form.unwrap_or(Form::Stable);
        let method = Configured::new(method, &Options { form: Some(form), ..self.options() })?;
        let shininess = self.resolved_set(set, method.about(), shader.as_ref())?;
        // A channel's last bit is worth sixteen of the lobe's, and a step of the cosine moves a highlight of n = 256 by
        // one.
        let (input_fraction, output_fraction) =
            shader.as_ref().map_or((16, 16), |shader| (shader.channel_bits + 8, shader.channel_bits + 4));
        let input_fraction = within("input_fraction", self.input_fraction.unwrap_or(input_fraction), INPUT_FRACTION)?;
        let output_fraction =
            within("output_fraction", self.output_fraction.unwrap_or(output_fraction), OUTPUT_FRACTION)?;
        let monotone = self.monotone.unwrap_or(true);
        let interface = Interface { shininess, input_fraction, output_fraction, operand, input_range, monotone };
        method.check(&interface)?;
        let name = default_name(method.about(), form, shader.as_ref());
        let lobe = LobeSpec { method, interface };
        Ok((
            match shader {
                None => Block::Lobe(lobe),
                Some(shader) => Block::Shader(lobe, shader),
            },
            name,
        ))
    }

    /// The shader around the lobe, if there is one.
    fn resolved_shader(&self) -> Result<Option<Shader>, Error> {
        match self.block.unwrap_or_default() {
            BlockKind::Shader => {
                let shader = self.shader.clone().resolve(self.lights_a_clock, self.most_lights)?;
                if self.rom == Some(RomStyle::Writable) {
                    return Err(Error::input(
                        "a shader's memories cannot be written",
                        "use rom = \"inline\" or \"file\"",
                    ));
                }
                Ok(Some(shader))
            }
            BlockKind::Image => unreachable!("it has no lobe"),
            BlockKind::Lobe if self.shader.is_empty() => Ok(None),
            BlockKind::Lobe => {
                Err(Error::input("keys of a shader are given for a lobe", "use --block shader, or leave them out"))
            }
        }
    }

    /// What the lobe is given, and which codes of it: in a shader what its front end computes.
    fn resolved_operand(&self, shader: Option<&Shader>) -> Result<(Operand, InputRange), Error> {
        let operand = match (shader, self.operand) {
            (None, operand) => operand.unwrap_or(Operand::Cos),
            (Some(_), Some(_)) => return Err(Error::input("a shader computes its own cosine", "leave operand out")),
            (Some(shader), None) if shader.cosine == Cosine::Half => Operand::Versine,
            (Some(_), None) => Operand::Cos,
        };
        if shader.is_some() && self.input_range.is_some() {
            return Err(Error::input("a shader keeps its own cosine in [0, 1]", "leave input_range out"));
        }
        Ok((operand, self.input_range.unwrap_or(InputRange::Any)))
    }

    /// The shininesses or the materials, whichever are given.
    fn given_set(&self, shader: Option<&Shader>) -> Result<Shininess, Error> {
        let (what, allowed) = match (&self.shininess, &self.material) {
            (set, None) if shader.is_some() => {
                let set = set.as_ref().map_or("no materials".to_owned(), |set| format!("the shininess {set}"));
                let allowed = "a shader serves materials: give --material NAME=N, or [[material]] in a spec file";
                (format!("the block shader is given {set}"), allowed)
            }
            (Some(set), None) => return Ok(set.clone()),
            (None, Some(materials)) => return Ok(Shininess::Materials(materials.clone())),
            (None, None) => {
                ("no shininess is given".to_owned(), "give --shininess 1..=1000, a list, or --material NAME=N")
            }
            (Some(_), Some(_)) => ("both shininess and materials are given".to_owned(), "give one of the two"),
        };
        Err(Error::input(what, allowed))
    }

    /// The shininesses with the fraction bits of a range and the surfaces of a shader's materials.
    fn resolved_set(&self, set: Shininess, about: &About, shader: Option<&Shader>) -> Result<Shininess, Error> {
        let frac_bits = within("shininess_fraction", self.shininess_fraction.unwrap_or(0), SHININESS_FRACTION)?;
        let set = match set {
            set if frac_bits == 0 => set,
            Shininess::Range(first, last) => Shininess::Fixed { first, last, frac_bits },
            _ => {
                return Err(Error::input(
                    "shininess_fraction needs a range",
                    "a list or materials hold real numbers already: leave shininess_fraction out",
                ));
            }
        };
        set.check()?;
        let set = match (set, shader) {
            (Shininess::Materials(materials), Some(_)) => {
                materials.iter().try_for_each(Material::check_surface)?;
                Shininess::Materials(materials.into_iter().map(Material::with_surface).collect())
            }
            (Shininess::Materials(materials), None) if materials.iter().any(Material::has_surface) => {
                return Err(Error::input("a lobe has no colours", "use --block shader, or leave the colours out"));
            }
            (set, _) => set,
        };
        if frac_bits > 0 && !about.interpolates && !about.computes_with_shininess {
            return Err(Error::input(
                format!("the method {} takes no shininess between the integers of a range", about.name),
                "leave shininess_fraction out, or give a list",
            ));
        }
        Ok(set)
    }

    /// The bits of `tuser`, if there is a wrapper with AXI4-Stream interfaces.
    fn resolved_axi_stream(&self) -> Result<Option<u32>, Error> {
        match (self.axi_stream.unwrap_or(false), self.tuser_bits) {
            (true, bits) => within("tuser_bits", bits.unwrap_or(*TUSER_BITS.start()), TUSER_BITS).map(Some),
            (false, None) => Ok(None),
            (false, Some(_)) => Err(Error::input(
                "tuser_bits is given for a core without AXI4-Stream interfaces",
                "give axi_stream as well, or leave tuser_bits out",
            )),
        }
    }

    /// Where lights in sequence come from.
    fn resolved_light_source(&self, block: &Block) -> Result<LightSource, Error> {
        let source = self.light_source.unwrap_or_default();
        refuse!(
            self.light_source.is_some() && block.shader().is_some_and(|shader| shader.most_lights.is_none()),
            "light_source is given for a shader that takes all lights of a sample at once",
            "give lights_a_clock as well, or leave light_source out"
        );
        let given = self.light_records.as_ref().is_some_and(|records| !records.0.is_empty());
        refuse!(
            given && source != LightSource::Rom,
            "light_records are given for a core whose lights are not a ROM's",
            "give light_source = \"rom\" as well, or leave light_records out"
        );
        refuse!(
            source == LightSource::Rom && !given,
            "light_source = \"rom\" is given without lights",
            "light_records, the codes of a light's ports each, as `brdfgen image lights` writes them"
        );
        Ok(source)
    }

    /// The fields of a resolved spec, all given.
    #[must_use]
    pub fn from_spec(spec: &CoreSpec) -> Self {
        let shader = spec.block.shader();
        let common = Self {
            name: Some(spec.name.clone()),
            block: shader.map(|_| BlockKind::Shader),
            rom: Some(spec.rom),
            rom_formats: Some(spec.rom_formats.clone()),
            pipeline: Some(spec.pipeline),
            languages: Some(spec.languages.clone()),
            // These keys are younger than specs that are compared by their digests.
            dsp: Some(spec.dsp).filter(|&dsp| dsp != DspBlocks::default()),
            vhdl_ports: Some(spec.vhdl_ports).filter(|&ports| ports != VhdlPorts::default()),
            axi_stream: spec.axi_stream.map(|_| true),
            tuser_bits: spec.axi_stream,
            light_source: Some(spec.light_source).filter(|&source| source != LightSource::default()),
            light_records: Some(spec.light_records.clone()).filter(|records| !records.0.is_empty()),
            golden_inputs: Some(spec.golden_inputs.clone()).filter(|inputs| !inputs.0.is_empty()),
            lights_a_clock: shader.filter(|shader| shader.most_lights.is_some()).map(|shader| shader.lights),
            most_lights: shader.and_then(|shader| shader.most_lights),
            shader: shader.map(ShaderFields::from_shader).unwrap_or_default(),
            ..Self::default()
        };
        match &spec.block {
            Block::Lobe(lobe) => {
                let Interface { operand, input_range, .. } = lobe.interface;
                let input_range = Some(input_range).filter(|&range| range != InputRange::Any);
                Self { operand: Some(operand), input_range, ..common }.with_lobe(lobe)
            }
            Block::Shader(lobe, _) => common.with_lobe(lobe),
            Block::Image(image) => common.with_image(image, spec),
        }
    }

    /// With what both a lobe alone and that of a shader are given.
    fn with_lobe(self, LobeSpec { method, interface }: &LobeSpec) -> Self {
        let (shininess, material, shininess_fraction) = match &interface.shininess {
            Shininess::Materials(materials) => (None, Some(materials.clone()), None),
            &Shininess::Fixed { first, last, frac_bits } => {
                (Some(Shininess::Range(first, last)), None, Some(frac_bits))
            }
            set => (Some(set.clone()), None, None),
        };
        Self {
            method: Some(method.name()),
            shininess,
            shininess_fraction,
            input_fraction: Some(interface.input_fraction),
            output_fraction: Some(interface.output_fraction),
            monotone: Some(interface.monotone).filter(|&monotone| !monotone),
            material,
            ..self.with_options(Options { form: Some(method.form()), ..method.options() })
        }
    }
}

/// What a core is called whose spec has no name.
fn default_name(about: &About, form: Form, shader: Option<&Shader>) -> String {
    if shader.is_some() {
        return "shader".to_owned();
    }
    let name = about.core_name.map_or_else(|| about.name.replace('-', "_"), str::to_owned);
    name + if form == Form::Paper { "_paper" } else { "" }
}

/// The languages, both unless they are given, each once.
fn resolved_languages(given: Option<Vec<Language>>) -> Result<Vec<Language>, Error> {
    let mut languages = given.unwrap_or_else(|| vec![Language::Verilog, Language::Vhdl]);
    languages.sort_unstable();
    languages.dedup();
    if languages.is_empty() {
        return Err(Error::input("no language is given", "give verilog, vhdl or both"));
    }
    Ok(languages)
}
