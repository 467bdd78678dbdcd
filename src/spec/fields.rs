//! The spec as it is written, in TOML or as flags.

use std::path::Path;

use clap::Args;
use serde::{Deserialize, Serialize};

use super::{
    Block, BlockKind, Coefficients, CoreSpec, Cosine, Divider, Form, GoldenInputs, INPUT_FRACTION, InputRange, Inside,
    Language, Material, Memory, MethodName, OUTPUT_FRACTION, Operand, PIPELINE_DEPTH, Pipeline, RomStyle,
    SHININESS_FRACTION, ShaderFields, Shininess, TUSER_BITS, Tail, VhdlPorts,
};
use crate::emit::rom::RomFormat;
use crate::fit::Objective;
use crate::method::{Configured, Interface, Options, within, word};
use crate::platform::error::Error;
use crate::platform::input;

/// A spec as written: a key of the TOML file and a flag each. A flag wins over the file.
#[derive(Args, Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[command(next_help_heading = "Core")]
pub struct SpecFields {
    /// Name of the core, its module and its files [default: method and form]
    #[arg(long)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,

    /// What the core is [default: lobe]
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub block: Option<BlockKind>,

    /// How the lobe is approximated
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub method: Option<MethodName>,

    /// How the polynomial is evaluated [default: stable]
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub form: Option<Form>,

    /// Where the coefficients come from [default: paper, and minimax where no paper gives any]
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coefficients: Option<Coefficients>,

    /// What fitted coefficients make least: max-abs, max-abs:LEVEL or max-rel:LEVEL (where x^n is at least LEVEL), or
    /// weighted:POWER (errors times a power of x^n) [default: max-abs]
    #[arg(long)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,

    /// Level of the cubic's point of contact, 0.05 to 0.95 [default: 0.5]
    #[arg(long)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub q: Option<f64>,

    /// Level of the three-point cubic's second point, above 0 and below q [default: 1/18]
    #[arg(long)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub g: Option<f64>,

    /// What the cubic is past its minimum [default: cut]
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tail: Option<Tail>,

    /// The polynomial inside a power [default: quadratic]
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inside: Option<Inside>,

    /// Bits A of the method log-exp: a core smaller than the faithful one, proved within 2^-A of x^n, 3 to 15 and at most G - 1
    #[arg(long, value_name = "A")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<u32>,

    /// Where the tables of a core with an accuracy are meant to lie: they are sized for it [default: auto]
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub memory: Option<Memory>,

    /// How the core divides [default: digit]
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub divider: Option<Divider>,

    /// Address bits of the versine in the method table: each shininess has 2^BITS entries, 2 to 14 [default: 7]
    #[arg(long, value_name = "BITS")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub table_bits: Option<u32>,

    /// Address bits of the logarithm's table in the method harris, within an octave of the versine, 2 to 12 [default: 8]
    #[arg(long, value_name = "BITS")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub log_bits: Option<u32>,

    /// Address bits of the exponential's table in the method harris, 2 to 14 [default: 9]
    #[arg(long, value_name = "BITS")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exp_bits: Option<u32>,

    /// Shininesses served: a range of integers, 1..=1000, or a list of real numbers, 5,12.5,80
    #[arg(long, conflicts_with = "material")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shininess: Option<Shininess>,

    /// Fraction bits of the port in_n, for a range: real shininesses between the integers, 0 to 10 [default: 0]
    #[arg(long, value_name = "R")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shininess_fraction: Option<u32>,

    /// Fraction bits F of the input, 4 to 24 [default: 16]
    #[arg(long, value_name = "F")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub input_fraction: Option<u32>,

    /// Fraction bits G of the output, 4 to 20 [default: 16]
    #[arg(long, value_name = "G")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output_fraction: Option<u32>,

    /// What the core is given [default: cos]
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub operand: Option<Operand>,

    /// Codes of the operand that the core may be given: any, or those in [0, 1], which spares it the limits at both ends
    /// [default: any]
    #[arg(long, value_enum, value_name = "RANGE")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub input_range: Option<InputRange>,

    /// Where the HDL finds the coefficients [default: inline]
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rom: Option<RomStyle>,

    /// ROM files written beside the HDL; mem is always written [default: mem]
    #[arg(long, value_enum, value_delimiter = ',', value_name = "FORMATS")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rom_formats: Option<Vec<RomFormat>>,

    /// Registers between input and output, 1 to 64, or auto [default: auto]
    #[arg(long, value_name = "DEPTH|auto")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pipeline: Option<Pipeline>,

    /// Languages written [default: verilog,vhdl]
    #[arg(long, value_enum, value_delimiter = ',')]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub languages: Option<Vec<Language>>,

    /// Types of the VHDL's ports: numeric (unsigned and signed), or std-logic (std_logic_vector, as Vivado's block designs need them)
    /// [default: numeric]
    #[arg(long, value_enum, value_name = "TYPES")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vhdl_ports: Option<VhdlPorts>,

    /// Write a wrapper with AXI4-Stream interfaces around the core as well
    #[arg(long, value_name = "true|false", num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axi_stream: Option<bool>,

    /// Bits of tuser of the AXI4-Stream interfaces, 1 to 64 [default: 1]
    #[arg(long, value_name = "BITS")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tuser_bits: Option<u32>,

    /// Inputs for the golden vectors besides those that are chosen: the codes of the input ports in order, CODE,CODE;CODE,CODE
    #[arg(long, value_name = "INPUTS")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub golden_inputs: Option<GoldenInputs>,

    /// A named material, NAME=SHININESS; repeat for more. `in_n` is their index
    #[arg(long, value_name = "NAME=SHININESS")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material: Option<Vec<Material>>,

    /// What a shader has beyond its lobe.
    #[command(flatten)]
    #[serde(default, skip_serializing_if = "ShaderFields::is_empty")]
    pub shader: ShaderFields,
}

/// Words that cannot name a module, entity or file scope: the reserved words of Verilog-2005, SystemVerilog-2017 (as which most
/// tools read Verilog), Verilog-AMS, VHDL-2008 with PSL and VHDL-AMS, and names that the generated text itself uses.
const RESERVED: &str = "\
    above abs absdelay abstol ac_stim accept_on access acos acosh across after alias aliasparam all always \
    always_comb always_ff always_latch analog analysis and architecture array asin asinh assert assign assume \
    assume_guarantee atan atan2 atanh attribute automatic before begin bind bins binsof bit block body boolean \
    branch break buf buffer bufif0 bufif1 bus byte case casex casez ceil cell chandle character checker class \
    clocking cmos component config configuration connect connectmodule connectrules const constant constraint \
    context continue continuous cos cosh cover covergroup coverpoint cross ddt ddt_nature ddx deassign default \
    defparam design disable discipline disconnect discrete dist do domain downto driver_update edge else elsif end \
    endcase endchecker endclass endclocking endconfig endconnectmodule endconnectrules enddiscipline endfunction \
    endgenerate endgroup endinterface endmodule endnature endpackage endparamset endprimitive endprogram endproperty \
    endsequence endspecify endtable endtask entity enum event eventually exclude exit exp expect export extends \
    extern fairness file final final_step first_match flicker_noise floor flow for force foreach forever fork \
    forkjoin from function generate generic genvar global ground group guarded highz0 highz1 hypot idt idt_nature \
    idtmod ieee if iff ifnone ignore_bins illegal_bins implements implies import impure in incdir include inertial \
    inf initial initial_step inout input inside instance int integer interconnect interface intersect is join \
    join_any join_none label laplace_nd laplace_np laplace_zd laplace_zp large last_crossing let liblist library \
    limexp limit line linkage literal ln local localparam log logic longint loop macromodule map matches max medium \
    merged min mod modport module nand natural nature negedge net_resolution nettype new next nexttime nmos noise \
    noise_table noise_table_log nor noshowcancelled not notif0 notif1 null numeric_std of on open or others out \
    output package packed parameter paramset pmos port posedge positive postponed potential pow primitive priority \
    procedural procedure process program property protected pull0 pull1 pulldown pullup pulsestyle_ondetect \
    pulsestyle_onevent pure quantity rand randc randcase randsequence range rcmos real realtime record ref reference \
    reg register reject reject_on release rem repeat report resize resolveto restrict restrict_guarantee return \
    rising_edge rnmos rol ror rpmos rtran rtranif0 rtranif1 s_always s_eventually s_nexttime s_until s_until_with \
    scalared select sequence severity shared shift_left shortint shortreal showcancelled signal signed sin sinh sla \
    slew sll small soft solve specify specparam spectrum split sqrt sra srl static std std_logic std_logic_1164 \
    std_logic_vector std_ulogic string strong strong0 strong1 struct subnature subtype super supply0 supply1 \
    sync_accept_on sync_reject_on table tagged tan tanh task terminal textio then this through throughout time \
    timeprecision timer timeunit to to_integer to_signed to_unsigned tolerance top tran tranif0 tranif1 transition \
    transport tri tri0 tri1 triand trior trireg type typedef unaffected union unique unique0 units unsigned until \
    until_with untyped use uwire var variable vectored virtual vmode void vprop vunit wait wait_order wand weak \
    weak0 weak1 when while white_noise wildcard wire with within wor work wreal xnor xor zi_nd zi_np zi_zd zi_zp \
";

/// Names that the text of cores, wrappers and benches uses for something else; whatever else it does is told apart where it is written.
const USED: &str = "\
    accept accept_beat accepted aclk aresetn at at_end beat beat_word bench bits ce character_at check check_outputs \
    choose_rates clk clock clock_of_garbage clocks code colours compared complement complements complements_compared \
    complements_fed complements_sent conclude core count digit digits drain draw due due_number dut early_tready \
    early_tvalid empty_pipeline enable entry expect_line_end expected failed fault feed_complement feed_complements \
    feed_vector field file_idle file_stall first first_in golden good granted have_count have_vector held held_beat \
    hex idle idle_clock in_cos in_material in_n in_valid in_ver index input_word known last last_out latency length \
    lfsr longest line_ended line_number load looked m_axis_tdata m_axis_tlast m_axis_tready m_axis_tuser \
    m_axis_tvalid malformed message mismatches name next_character number of_number oldest one_in_eight out_b out_g \
    out_r out_spec out_valid output_word path place places present_garbage quiet ramstyle random_stalls rate \
    read_count read_decimal read_fields read_hex read_line read_space read_vector read_words ready reciprocal \
    ref_number reported reset_phase result ring rom row rst rtl run run_vectors s_axis_tdata s_axis_tlast \
    s_axis_tready s_axis_tuser s_axis_tvalid say scale send send_complement send_vector show_mismatch shown \
    shown_outputs sink_rate sink_ready skid skid_valid skip_space slot source source_rate stall stalled_clock stalls \
    status sum take taken text text_line under_way unused user user_word valid value vector_file vectors waits want \
    was_ready what width word wr_addr wr_data wr_en wrong \
";

/// Names that Windows keeps for devices, whatever follows them behind a dot; `com` and `lpt` with a digit are others.
const DEVICES: [&str; 4] = ["aux", "con", "nul", "prn"];

/// The most letters of a name: the longest names of files, such as those of a memory's, stay far below the 255 bytes of file systems.
const NAME_LETTERS: usize = 64;

impl SpecFields {
    /// Reads a TOML file, or the one in a generated core's directory.
    ///
    /// # Errors
    /// An unreadable file, text that is not TOML, an unknown key (with the nearest known one) or a value
    /// of the wrong kind, with its place.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let inside = path.join("core.toml");
        let path = if path.is_dir() { &inside } else { path };
        let text = input::read_text(path, "a spec is a TOML file")?;
        Self::parse(&text, &path.display().to_string())
    }

    /// Reads TOML text; `file` names it in messages.
    ///
    /// # Errors
    /// As [`SpecFields::read`].
    pub fn parse(text: &str, file: &str) -> Result<Self, Error> {
        toml::from_str(text).map_err(|error| {
            toml_error(&error, &[], "see `brdfgen generate --help` for the keys and values", file, text)
        })
    }

    /// These fields, and where one is missing the other's.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        // The two ways to give the set exclude each other, so one given here hides both of the other's.
        let set_here = self.shininess.is_some() || self.material.is_some();
        Self {
            name: self.name.or(other.name),
            block: self.block.or(other.block),
            method: self.method.or(other.method),
            form: self.form.or(other.form),
            coefficients: self.coefficients.or(other.coefficients),
            objective: self.objective.or(other.objective),
            q: self.q.or(other.q),
            g: self.g.or(other.g),
            tail: self.tail.or(other.tail),
            inside: self.inside.or(other.inside),
            accuracy: self.accuracy.or(other.accuracy),
            memory: self.memory.or(other.memory),
            divider: self.divider.or(other.divider),
            table_bits: self.table_bits.or(other.table_bits),
            log_bits: self.log_bits.or(other.log_bits),
            exp_bits: self.exp_bits.or(other.exp_bits),
            shininess_fraction: self.shininess_fraction.or(other.shininess_fraction),
            shininess: if set_here { self.shininess } else { other.shininess },
            input_fraction: self.input_fraction.or(other.input_fraction),
            output_fraction: self.output_fraction.or(other.output_fraction),
            operand: self.operand.or(other.operand),
            input_range: self.input_range.or(other.input_range),
            rom: self.rom.or(other.rom),
            rom_formats: self.rom_formats.or(other.rom_formats),
            pipeline: self.pipeline.or(other.pipeline),
            languages: self.languages.or(other.languages),
            vhdl_ports: self.vhdl_ports.or(other.vhdl_ports),
            axi_stream: self.axi_stream.or(other.axi_stream),
            tuser_bits: self.tuser_bits.or(other.tuser_bits),
            golden_inputs: self.golden_inputs.or(other.golden_inputs),
            material: if set_here { self.material } else { other.material },
            shader: self.shader.or(other.shader),
        }
    }

    /// Fills in the defaults and checks every value.
    ///
    /// # Errors
    /// Names the value that is wrong and what is allowed.
    pub fn resolve(self) -> Result<CoreSpec, Error> {
        let Some(method) = self.method else {
            return Err(Error::input(
                "no method is given",
                "give --method quadratic, --method cubic or another, or a spec file",
            ));
        };
        let form = self.form.unwrap_or(Form::Stable);
        let shader = match self.block.unwrap_or_default() {
            BlockKind::Shader => Some(self.shader.resolve()?),
            BlockKind::Lobe if self.shader.is_empty() => None,
            BlockKind::Lobe => {
                return Err(Error::input(
                    "keys of a shader are given for a lobe",
                    "use --block shader, or leave them out",
                ));
            }
        };
        if shader.is_some() && self.rom == Some(RomStyle::Writable) {
            return Err(Error::input("a shader's memories cannot be written", "use rom = \"inline\" or \"file\""));
        }
        let operand = match (&shader, self.operand) {
            (None, operand) => operand.unwrap_or(Operand::Cos),
            (Some(_), Some(_)) => {
                return Err(Error::input("a shader computes its own cosine", "leave operand out"));
            }
            (Some(shader), None) if shader.cosine == Cosine::Half => Operand::Versine,
            (Some(_), None) => Operand::Cos,
        };
        if shader.is_some() && self.input_range.is_some() {
            return Err(Error::input("a shader keeps its own cosine in [0, 1]", "leave input_range out"));
        }
        let shininess = match (self.shininess, self.material) {
            (set, None) if shader.is_some() => {
                let set = set.map_or("no materials".to_owned(), |set| format!("the shininess {set}"));
                return Err(Error::input(
                    format!("the block shader is given {set}"),
                    "a shader serves materials: give --material NAME=N, or [[material]] in a spec file",
                ));
            }
            (Some(set), None) => set,
            (None, Some(materials)) => Shininess::Materials(materials),
            (None, None) => {
                return Err(Error::input(
                    "no shininess is given",
                    "give --shininess 1..=1000, a list, or --material NAME=N",
                ));
            }
            (Some(_), Some(_)) => {
                return Err(Error::input("both shininess and materials are given", "give one of the two"));
            }
        };
        let method = Configured::new(
            method,
            &Options {
                form: Some(form),
                coefficients: self.coefficients,
                objective: self.objective,
                q: self.q,
                g: self.g,
                tail: self.tail,
                inside: self.inside,
                accuracy: self.accuracy,
                memory: self.memory,
                divider: self.divider,
                table_bits: self.table_bits,
                log_bits: self.log_bits,
                exp_bits: self.exp_bits,
            },
        )?;
        let about = method.about();
        let shininess_fraction =
            within("shininess_fraction", self.shininess_fraction.unwrap_or(0), SHININESS_FRACTION)?;
        let shininess = match shininess {
            set if shininess_fraction == 0 => set,
            Shininess::Range(first, last) => Shininess::Fixed { first, last, frac_bits: shininess_fraction },
            _ => {
                return Err(Error::input(
                    "shininess_fraction needs a range",
                    "a list or materials hold real numbers already: leave shininess_fraction out",
                ));
            }
        };
        shininess.check()?;
        let shininess = match (shininess, &shader) {
            (Shininess::Materials(materials), Some(_)) => {
                materials.iter().try_for_each(Material::check_surface)?;
                Shininess::Materials(materials.into_iter().map(Material::with_surface).collect())
            }
            (Shininess::Materials(materials), None) if materials.iter().any(Material::has_surface) => {
                return Err(Error::input("a lobe has no colours", "use --block shader, or leave the colours out"));
            }
            (set, _) => set,
        };
        if shininess_fraction > 0 && !about.interpolates && !about.computes_with_shininess {
            return Err(Error::input(
                format!("the method {} takes no shininess between the integers of a range", about.name),
                "leave shininess_fraction out, or give a list",
            ));
        }
        if let Some(Pipeline::Depth(depth)) = self.pipeline {
            within("pipeline", depth, PIPELINE_DEPTH)?;
        }
        let default_name = match &shader {
            None => {
                let name = about.core_name.map_or_else(|| about.name.replace('-', "_"), str::to_owned);
                name + if form == Form::Paper { "_paper" } else { "" }
            }
            Some(_) => "shader".to_owned(),
        };
        // A channel's last bit is worth sixteen of the lobe's, and a step of the cosine moves a highlight of n = 256 by one.
        let (input_fraction, output_fraction) =
            shader.as_ref().map_or((16, 16), |shader| (shader.channel_bits + 8, shader.channel_bits + 4));
        let input_fraction = within("input_fraction", self.input_fraction.unwrap_or(input_fraction), INPUT_FRACTION)?;
        let output_fraction =
            within("output_fraction", self.output_fraction.unwrap_or(output_fraction), OUTPUT_FRACTION)?;
        let input_range = self.input_range.unwrap_or(InputRange::Any);
        let interface = Interface { shininess, input_fraction, output_fraction, operand, input_range };
        method.check(&interface)?;
        let name = self.name.unwrap_or(default_name);
        check_name(&name)?;
        let mut rom_formats = self.rom_formats.unwrap_or_default();
        rom_formats.push(RomFormat::Mem);
        rom_formats.sort_unstable();
        rom_formats.dedup();
        let mut languages = self.languages.unwrap_or_else(|| vec![Language::Verilog, Language::Vhdl]);
        languages.sort_unstable();
        languages.dedup();
        if languages.is_empty() {
            return Err(Error::input("no language is given", "give verilog, vhdl or both"));
        }
        let vhdl_ports = self.vhdl_ports.unwrap_or_default();
        if self.vhdl_ports.is_some() && !languages.contains(&Language::Vhdl) {
            return Err(Error::input(
                "vhdl_ports is given for a core without VHDL",
                "add vhdl to languages, or leave vhdl_ports out",
            ));
        }
        let axi_stream = match (self.axi_stream.unwrap_or(false), self.tuser_bits) {
            (true, bits) => Some(within("tuser_bits", bits.unwrap_or(1), TUSER_BITS)?),
            (false, None) => None,
            (false, Some(_)) => {
                return Err(Error::input(
                    "tuser_bits is given for a core without AXI4-Stream interfaces",
                    "give axi_stream as well, or leave tuser_bits out",
                ));
            }
        };
        Ok(CoreSpec {
            name,
            block: shader.map_or(Block::Lobe, Block::Shader),
            method,
            interface,
            rom: self.rom.unwrap_or(RomStyle::Inline),
            rom_formats,
            pipeline: self.pipeline.unwrap_or(Pipeline::Auto),
            languages,
            vhdl_ports,
            axi_stream,
            golden_inputs: self.golden_inputs.unwrap_or_default(),
        })
    }

    /// The fields of a resolved spec, all given.
    #[must_use]
    pub fn from_spec(spec: &CoreSpec) -> Self {
        let (shininess, material, shininess_fraction) = match &spec.interface.shininess {
            Shininess::Materials(materials) => (None, Some(materials.clone()), None),
            &Shininess::Fixed { first, last, frac_bits } => {
                (Some(Shininess::Range(first, last)), None, Some(frac_bits))
            }
            set => (Some(set.clone()), None, None),
        };
        let shader = spec.block.shader();
        let options = spec.method.options();
        Self {
            name: Some(spec.name.clone()),
            block: shader.map(|_| BlockKind::Shader),
            method: Some(spec.method.name()),
            form: Some(spec.method.form()),
            coefficients: options.coefficients,
            objective: options.objective,
            q: options.q,
            g: options.g,
            tail: options.tail,
            inside: options.inside,
            accuracy: options.accuracy,
            memory: options.memory,
            divider: options.divider,
            table_bits: options.table_bits,
            log_bits: options.log_bits,
            exp_bits: options.exp_bits,
            shininess,
            shininess_fraction,
            input_fraction: Some(spec.interface.input_fraction),
            output_fraction: Some(spec.interface.output_fraction),
            operand: shader.is_none().then_some(spec.interface.operand),
            // As below, the key is younger than specs that are compared by their digests.
            input_range: Some(spec.interface.input_range).filter(|&range| range != InputRange::Any),
            rom: Some(spec.rom),
            rom_formats: Some(spec.rom_formats.clone()),
            pipeline: Some(spec.pipeline),
            languages: Some(spec.languages.clone()),
            // The keys are younger than specs that are compared by their digests.
            vhdl_ports: Some(spec.vhdl_ports).filter(|&ports| ports != VhdlPorts::default()),
            axi_stream: spec.axi_stream.map(|_| true),
            tuser_bits: spec.axi_stream,
            golden_inputs: Some(spec.golden_inputs.clone()).filter(|inputs| !inputs.0.is_empty()),
            material,
            shader: shader.map(ShaderFields::from_shader).unwrap_or_default(),
        }
    }

    /// The fields as TOML text.
    ///
    /// # Panics
    /// Never: every field has a TOML form.
    #[must_use]
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("every field has a TOML form")
    }

    /// The flags that give these fields where they differ from the defaults.
    pub(super) fn flags(&self) -> Vec<String> {
        let defaults = Self {
            name: None,
            rom_formats: None,
            shininess: self.shininess.clone(),
            material: self.material.clone(),
            block: self.block,
            method: self.method,
            shader: ShaderFields { model: self.shader.model, front: self.shader.front, ..ShaderFields::default() },
            ..Self::default()
        }
        .resolve()
        .map(|spec| Self::from_spec(&spec))
        .unwrap_or_default();
        let plain_name = Self { name: None, ..self.clone() }.resolve().map(|spec| spec.name).ok();
        let mut flags = Vec::new();
        let mut flag = |name: &str, value: String| flags.push(format!("--{name} {value}"));
        if let Some(block) = &self.block {
            flag("block", word(block));
        }
        if let Some(method) = &self.method {
            flag("method", word(method));
        }
        if let Some(set) = &self.shininess {
            flag("shininess", set.to_string());
        }
        for material in self.material.iter().flatten() {
            let plain = material.name.chars().all(|c| c.is_ascii_alphanumeric() || "-_.".contains(c));
            let name =
                if plain { material.name.clone() } else { format!("'{}'", material.name.replace('\'', "'\\''")) };
            flag("material", format!("{name}={}", material.shininess));
        }
        if self.name != plain_name {
            flag("name", self.name.clone().unwrap_or_default());
        }
        if let Some(form) = self.form.filter(|_| self.form != defaults.form) {
            flag("form", word(&form));
        }
        if let Some(coefficients) = self.coefficients.filter(|_| self.coefficients != defaults.coefficients) {
            flag("coefficients", word(&coefficients));
        }
        if let Some(objective) = self.objective.filter(|&objective| objective != Objective::default()) {
            flag("objective", objective.to_string());
        }
        if let Some(q) = self.q.filter(|_| self.q != defaults.q) {
            flag("q", q.to_string());
        }
        if let Some(g) = self.g.filter(|_| self.g != defaults.g) {
            flag("g", g.to_string());
        }
        if let Some(tail) = self.tail.filter(|_| self.tail != defaults.tail) {
            flag("tail", word(&tail));
        }
        if let Some(inside) = self.inside.filter(|_| self.inside != defaults.inside) {
            flag("inside", word(&inside));
        }
        if let Some(bits) = self.accuracy {
            flag("accuracy", bits.to_string());
        }
        if let Some(memory) = self.memory.filter(|&memory| memory != Memory::Auto) {
            flag("memory", word(&memory));
        }
        if let Some(divider) = self.divider.filter(|_| self.divider != defaults.divider) {
            flag("divider", word(&divider));
        }
        for (name, own, default) in [
            ("table-bits", self.table_bits, defaults.table_bits),
            ("log-bits", self.log_bits, defaults.log_bits),
            ("exp-bits", self.exp_bits, defaults.exp_bits),
        ] {
            if let Some(bits) = own.filter(|_| own != default) {
                flag(name, bits.to_string());
            }
        }
        if let Some(bits) = self.shininess_fraction {
            flag("shininess-fraction", bits.to_string());
        }
        if let Some(bits) = self.input_fraction.filter(|_| self.input_fraction != defaults.input_fraction) {
            flag("input-fraction", bits.to_string());
        }
        if let Some(bits) = self.output_fraction.filter(|_| self.output_fraction != defaults.output_fraction) {
            flag("output-fraction", bits.to_string());
        }
        if let Some(operand) = self.operand.filter(|_| self.operand != defaults.operand) {
            flag("operand", word(&operand));
        }
        if let Some(range) = self.input_range.filter(|&range| range != InputRange::Any) {
            flag("input-range", word(&range));
        }
        if let Some(rom) = self.rom.filter(|_| self.rom != defaults.rom) {
            flag("rom", word(&rom));
        }
        if let Some(formats) = self.rom_formats.as_ref().filter(|_| self.rom_formats != defaults.rom_formats) {
            flag("rom-formats", formats.iter().map(word).collect::<Vec<_>>().join(","));
        }
        if let Some(pipeline) = self.pipeline.filter(|_| self.pipeline != defaults.pipeline) {
            flag("pipeline", pipeline.to_string());
        }
        if let Some(languages) = self.languages.as_ref().filter(|_| self.languages != defaults.languages) {
            flag("languages", languages.iter().map(word).collect::<Vec<_>>().join(","));
        }
        if let Some(ports) = self.vhdl_ports.filter(|&ports| ports != VhdlPorts::default()) {
            flag("vhdl-ports", word(&ports));
        }
        if self.axi_stream == Some(true) {
            flags.push("--axi-stream".to_owned());
        }
        let mut flag = |name: &str, value: String| flags.push(format!("--{name} {value}"));
        if let Some(bits) = self.tuser_bits.filter(|bits| bits != TUSER_BITS.start()) {
            flag("tuser-bits", bits.to_string());
        }
        if let Some(inputs) = &self.golden_inputs {
            flag("golden-inputs", format!("'{inputs}'"));
        }
        let (shader, plain) = (&self.shader, &defaults.shader);
        if let Some(model) = &shader.model {
            flag("model", word(model));
        }
        if let Some(front) = &shader.front {
            flag("front", word(front));
        }
        if let Some(lights) = shader.lights.filter(|_| shader.lights != plain.lights) {
            flag("lights", lights.to_string());
        }
        if let Some(bits) = shader.channel_bits.filter(|_| shader.channel_bits != plain.channel_bits) {
            flag("channel-bits", bits.to_string());
        }
        if let Some(bits) = shader.vector_fraction.filter(|_| shader.vector_fraction != plain.vector_fraction) {
            flag("vector-fraction", bits.to_string());
        }
        if let Some(light) = shader.ambient_light.as_ref().filter(|_| shader.ambient_light != plain.ambient_light) {
            flag("ambient-light", light.iter().map(f64::to_string).collect::<Vec<_>>().join(","));
        }
        if let Some(colours) = shader.light_colours.as_ref().filter(|_| shader.light_colours != plain.light_colours) {
            flag("light-colours", format!("'{colours}'"));
        }
        flags
    }
}

/// What is wrong with TOML text, with its place: an unknown key with the nearest of those that the parser or `more` knows, or what
/// the parser says with `help`.
pub(crate) fn toml_error(error: &toml::de::Error, more: &[&str], help: &str, file: &str, text: &str) -> Error {
    let span = error.span().unwrap_or(0..0);
    let (what, allowed) = match error.message().strip_prefix("unknown field `").and_then(|rest| rest.split_once('`')) {
        Some((key, rest)) => {
            let known = rest.split('`').skip(1).step_by(2).chain(more.iter().copied());
            (format!("unknown key `{key}`"), suggest("keys", key, known))
        }
        None => (error.message().to_owned(), help.to_owned()),
    };
    Error::text(what, allowed, file, text, (span.start, span.len()))
}

/// "did you mean ...?" where a known name is near, and the list of all of them; `what` they are, in the plural.
pub(crate) fn suggest<'a>(what: &str, name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    let nearest = known.iter().max_by(|a, b| strsim::jaro_winkler(name, a).total_cmp(&strsim::jaro_winkler(name, b)));
    match nearest.filter(|near| strsim::jaro_winkler(name, near) > 0.7) {
        Some(near) => format!("did you mean `{near}`? The {what} are {}", known.join(", ")),
        None => format!("the {what} are {}", known.join(", ")),
    }
}

/// Whether a name is an identifier of both languages that files can be named by.
fn is_name(name: &str) -> bool {
    let numbered = name.strip_prefix("com").or(name.strip_prefix("lpt"));
    let is_device =
        DEVICES.contains(&name) || numbered.is_some_and(|rest| rest.len() == 1 && rest.as_bytes()[0].is_ascii_digit());
    name.len() <= NAME_LETTERS
        && name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
        && !name.ends_with('_')
        && !name.contains("__")
        && !is_device
        && [RESERVED, USED].iter().all(|words| words.split_ascii_whitespace().all(|word| word != name))
}

/// A name that is allowed, as near to this one as may be.
fn allowed_name(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let mapped: String = name.chars().map(plain).collect();
    let parts: Vec<&str> = mapped.split('_').filter(|part| !part.is_empty()).collect();
    let joined = parts.join("_");
    let joined = if joined.starts_with(|c: char| c.is_ascii_lowercase()) { joined } else { format!("lobe_{joined}") };
    let cut = |name: &str, letters: usize| name[..letters.min(name.len())].trim_end_matches('_').to_owned();
    let whole = cut(&joined, NAME_LETTERS);
    if is_name(&whole) { whole } else { cut(&joined, NAME_LETTERS - 5) + "_core" }
}

/// Refuses a name that is not an identifier of both languages, or that no file can have everywhere.
pub(crate) fn check_name(name: &str) -> Result<(), Error> {
    if is_name(name) {
        return Ok(());
    }
    Err(Error::input(
        format!("the name `{name}` is not allowed"),
        format!(
            "`{}` would be: a name is an identifier of both languages and of files, up to {NAME_LETTERS} lower-case letters, digits \
             and single underscores, a letter first, no underscore last, no reserved word, no port, no device of Windows",
            allowed_name(name)
        ),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn parse(text: &str) -> Result<CoreSpec, Error> {
        SpecFields::parse(text, "core.toml")?.resolve()
    }

    fn message(text: &str) -> String {
        match parse(text).expect_err(text) {
            Error::Input { what, allowed } | Error::Text { what, allowed, .. } => format!("{what} | {allowed}"),
            other => panic!("{other}"),
        }
    }

    #[test]
    fn defaults_are_resolved_and_written_back() {
        let spec = parse("method = \"quadratic\"\nshininess = \"1..=1000\"").unwrap();
        assert_eq!(
            (spec.interface.input_fraction, spec.interface.output_fraction, spec.method.form()),
            (16, 16, Form::Stable)
        );
        assert_eq!(spec.languages, [Language::Verilog, Language::Vhdl]);
        assert_eq!(parse(&spec.to_toml()).unwrap(), spec);
        assert_eq!(spec.command(), "brdfgen generate --method quadratic --shininess 1..=1000");
        // The default of a level that the method does not have is no obstacle.
        assert_eq!(parse("method = \"cubic\"\nshininess = [3]\nq = 0.051").unwrap().method.options().q, Some(0.051));
    }

    /// Specs without the interfaces keep the digests that they had before there were any.
    #[test]
    fn axi_stream_is_written_only_where_it_is_asked_for() {
        let base = "method = \"quadratic\"\nshininess = \"1..=1000\"\n";
        let plain = parse(base).unwrap();
        assert_eq!(plain.axi_stream, None);
        assert!(!plain.to_toml().contains("axi") && !plain.to_toml().contains("tuser"));
        assert_eq!(parse(&format!("{base}axi_stream = false")).unwrap(), plain);
        for (more, bits, flags) in [("", 1, "--axi-stream"), ("tuser_bits = 64", 64, "--axi-stream --tuser-bits 64")] {
            let spec = parse(&format!("{base}axi_stream = true\n{more}")).unwrap();
            assert_eq!(spec.axi_stream, Some(bits));
            assert!(spec.to_toml().contains(&format!("axi_stream = true\ntuser_bits = {bits}\n")));
            assert_eq!(parse(&spec.to_toml()).unwrap(), spec);
            assert_ne!(spec.digest(), plain.digest());
            assert_eq!(spec.command(), format!("brdfgen generate --method quadratic --shininess 1..=1000 {flags}"));
        }
    }

    /// As above; what the codes may be is for the design to say.
    #[test]
    fn golden_inputs_are_written_only_where_there_are_any() {
        let base = "method = \"quadratic\"\nshininess = \"1..=1000\"\n";
        let plain = parse(base).unwrap();
        assert!(!plain.to_toml().contains("golden_inputs"));
        assert_eq!(parse(&format!("{base}golden_inputs = []")).unwrap(), plain);
        let spec = parse(&format!("{base}golden_inputs = [[4, 57395], [7, -3]]")).unwrap();
        assert_eq!(spec.golden_inputs, "4,57395; 7, -3".parse().unwrap());
        assert!(spec.to_toml().contains("golden_inputs = [[4, 57395], [7, -3]]\n"));
        assert_eq!(parse(&spec.to_toml()).unwrap(), spec);
        assert_ne!(spec.digest(), plain.digest());
        assert_eq!(spec.flags().last().unwrap(), "--golden-inputs '4,57395;7,-3'");
        for wrong in ["4,", "", "4;;5", "0x4,5", "9223372036854775808,1"] {
            assert!(wrong.parse::<GoldenInputs>().unwrap_err().contains("is no code"), "{wrong}");
        }
    }

    #[test]
    fn every_wrong_value_is_named() {
        let base = "method = \"cubic\"\nshininess = \"1..=1000\"\n";
        let set = |set: &str| format!("method = \"quadratic\"\nshininess = {set}");
        for (text, expected) in [
            (format!("{base}inputfraction = 8"), "did you mean `input_fraction`?"),
            (format!("{base}input_fraction = 0"), "input_fraction = 0 is out of range"),
            (format!("{base}output_fraction = 200"), "from 4 to 20"),
            (format!("{base}q = 1.5"), "level q = 1.5"),
            (format!("{base}name = \"module\""), "the name `module`"),
            (format!("{base}name = \"a b\""), "the name `a b`"),
            (format!("{base}pipeline = 99"), "from 1 to 64"),
            (format!("{base}languages = []"), "no language"),
            (format!("{base}[[material]]\nname = \"a\"\nshininess = 2"), "both shininess and materials"),
            (format!("{base}[[material]]\nname = \"a\"\nshine = 2"), "unknown key `shine`"),
            (set("[0.5]"), "shininess 0.5"),
            (set("[nan]"), "shininess NaN"),
            (set("[inf]"), "shininess inf"),
            (set("\"0..=5\""), "shininess 0"),
            (set("\"1..=1000000000\""), "1000000000 shininesses"),
            (set("\"0..=4294967295\""), "4294967296 shininesses"),
            (set("\"9..=2\""), "is empty"),
            (set("\"1..1000\""), "both ends"),
            (set("[]"), "0 shininesses"),
            (set("true"), "the shininess is a range"),
            ("shininess = [3]".to_owned(), "no method"),
            ("method = \"cubic\"".to_owned(), "no shininess"),
            (format!("{base}shininess_fraction = 40"), "from 0 to 10"),
            (format!("{base}g = 0.1"), "the method cubic has no level g"),
            (format!("{base}divider = \"digit\""), "the method cubic has no divider"),
            (format!("{base}inside = \"linear\""), "the method cubic has no choice of inside"),
            (format!("{base}coefficients = \"minimax\"\nq = 0.4"), "no level q with fitted coefficients"),
            (format!("{base}coefficients = \"minimax\"\nform = \"paper\""), "the paper form has the paper's"),
            ("method = \"schlick\"\nshininess = [3]\ncoefficients = \"paper\"".to_owned(), "has no paper coefficients"),
            ("method = \"cubic-three-point\"\nshininess = [3]\ng = 0.6".to_owned(), "level g = 0.6"),
            ("method = \"quadratic\"\nshininess = [3]\ntail = \"hold\"".to_owned(), "has no choice of tail"),
            ("method = \"quadratic\"\nshininess = [3]\nshininess_fraction = 2".to_owned(), "needs a range"),
            (set("\"3..=4\"\nform = \"paper\"\nshininess_fraction = 1"), "the paper form takes no shininess between"),
            (format!("{base}form = \"paper\"\nshininess_fraction = 10"), "the paper form takes no shininess between"),
            (format!("{}\nq = 0.7", set("[3]")), "the method quadratic has no level q"),
            (format!("{base}tuser_bits = 4"), "tuser_bits is given for a core without AXI4-Stream interfaces"),
            (format!("{base}axi_stream = false\ntuser_bits = 4"), "give axi_stream as well"),
            (format!("{base}axi_stream = true\ntuser_bits = 0"), "tuser_bits = 0 is out of range"),
            (format!("{base}axi_stream = true\ntuser_bits = 65"), "from 1 to 64"),
            (format!("{base}axi_stream = 1"), "invalid type"),
            (format!("{base}golden_inputs = [4, 57395]"), "invalid type"),
            (format!("{base}golden_inputs = [[4, 1.5]]"), "invalid type"),
        ] {
            let message = message(&text);
            assert!(message.contains(expected), "{text}\n{message}\nexpected: {expected}");
        }
    }

    proptest! {
        #[test]
        fn any_text_is_taken_or_refused(text in "\\PC*") {
            let _ = parse(&text);
        }

        #[test]
        fn any_value_is_taken_or_refused(key in "(method|form|q|shininess|input_fraction|rom|pipeline|languages|name)", value in "(\"[a-z0-9.=,]{0,12}\"|-?[0-9]{1,12}|[0-9]{1,3}\\.[0-9]{1,3}|\\[[0-9., ]{0,9}\\]|nan|true)") {
            let _ = parse(&format!("method = \"cubic\"\nshininess = [3]\n{key} = {value}\n"));
            let _ = parse(&format!("{key} = {value}\n"));
        }

        #[test]
        fn resolved_specs_survive_toml(n in proptest::collection::vec(1.0f64..5000.0, 1..5), f in 4u32..=24, g in 4u32..=20, q in 0.05f64..0.95, depth in 1u32..=32) {
            let text = format!("method = \"cubic\"\nshininess = {n:?}\ninput_fraction = {f}\noutput_fraction = {g}\nq = {q:?}\npipeline = {depth}\nrom_formats = [\"csv\", \"mem\", \"csv\"]");
            let spec = parse(&text).unwrap();
            prop_assert_eq!(&parse(&spec.to_toml()).unwrap(), &spec);
        }
    }
}
