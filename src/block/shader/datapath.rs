//! A shader around a lobe: scalar products, the cosine of the highlight, the lobe, and the sum of the lights' colours.
//!
//! The lobe is any method's own graph, taken over operation by operation ([`Builder::graft`]), once a light. What is
//! around it is analysed here over all codes of the vectors' ports, of unit length or not: every code has a defined
//! result.

use super::{Cosine, LightColours, Shader, ShaderWidths};
use crate::block::CHANNELS;
use crate::block::parts::{self, AXES};
use crate::datapath::Datapath;
use crate::datapath::builder::{Bound, Builder, Case, HighBits};
use crate::datapath::graph::{Graph, NodeId, Op};
use crate::fixed::{Field, Format, Interval, Table, exp2, interned};
use crate::method::polynomial::datapath::rounded_field;
use crate::method::{Interface, Shininess};

/// The name of the memory with the materials' colours.
pub const COLOURS: &str = "colours";

/// The name of the memory with the reciprocal roots of a light, counted from 0.
#[must_use]
pub fn root_memory(light: usize) -> &'static str {
    interned(format!("root_{}", light + 1))
}

/// The names of the fields of that memory: the root at a segment's start, and its fall.
fn root_fields(light: usize) -> [&'static str; 2] {
    [interned(format!("start_{}", light + 1)), interned(format!("slope_{}", light + 1))]
}

/// The names of a channel's colours in the ROM: ambient, and diffuse and specular of a light (of none in particular
/// where the lights' colours come from ports).
#[must_use]
pub fn colour_names(shader: &Shader, channel: usize, light: usize) -> [&'static str; 3] {
    let c = CHANNELS[channel];
    let of = match shader.light_colours {
        LightColours::Ports => String::new(),
        LightColours::Fixed(_) => format!("_{}", light + 1),
    };
    [interned(format!("ambient_{c}")), interned(format!("diffuse_{c}{of}")), interned(format!("specular_{c}{of}"))]
}

/// The places of the fields of these names among those of the ROM.
pub(crate) fn colour_places(shader: &Shader, channel: usize, light: usize) -> [usize; 3] {
    let of_light = match shader.light_colours {
        LightColours::Ports => 0,
        LightColours::Fixed(_) => light,
    };
    let diffuse = CHANNELS.len() + 2 * (CHANNELS.len() * of_light + channel);
    [channel, diffuse, diffuse + 1]
}

/// The colours of each material, as they stand in the ROM, in the order of [`colour_places`]: in units in which full
/// scale is the greatest code, `1 - 2^-bits`.
///
/// Light colours that are constants are multiplied in. One that is a port's code c stands for `c / (2^bits - 1)`, so
/// that its product with k is `k c 2^-bits` in these units, and k is in the ROM as it is.
fn colours(interface: &Interface, shader: &Shader, frac_bits: i32) -> Table {
    let surfaces = Shader::surfaces(interface);
    let full = shader.full_scale() as f64 * exp2(-(shader.channel_bits as i32));
    let column = |name: &'static str, meaning: &'static str, value: &dyn Fn(usize) -> f64| -> Field {
        rounded_field(name, meaning, frac_bits, (0..surfaces.len()).map(value).collect())
    };
    let mut fields = Vec::new();
    for (channel, &ambient) in shader.ambient_light.iter().enumerate() {
        let name = colour_names(shader, channel, 0)[0];
        fields.push(column(name, "ambient light, k_a and colour", &|row| {
            full * ambient * surfaces[row].ambient[channel]
        }));
    }
    let lights = match &shader.light_colours {
        LightColours::Ports => vec![[1.0 / full; 3]],
        LightColours::Fixed(lights) => lights.clone(),
    };
    for (light, intensity) in lights.iter().enumerate() {
        for (channel, intensity) in intensity.iter().enumerate() {
            let [_, diffuse, specular] = colour_names(shader, channel, light);
            let factor = full * intensity;
            fields.push(column(diffuse, "k_d, colour and light", &|row| factor * surfaces[row].diffuse[channel]));
            fields.push(column(specular, "k_s, colour and light", &|row| factor * surfaces[row].specular[channel]));
        }
    }
    let keys = (0..surfaces.len()).map(|row| row as f64).collect();
    Table::listed(COLOURS, "material", keys, fields)
}

/// Index bits below the point of the table of reciprocal roots: straight lines over segments of `h = 2^-j` are off by
/// `(3/4) h^2 / 16` at most at m = 1, which this keeps below a quarter of the lobe's input step.
#[must_use]
pub fn root_index_bits(interface: &Interface) -> i32 {
    ((interface.input_fraction as i32 - 1) / 2).max(1)
}

/// `1/sqrt(m)` for m from 1 to 4 in straight lines, a row a segment; each lies half its largest error below the chord.
/// Below 1, where only m = 0 falls, it is 1.
fn roots(interface: &Interface, light: usize, frac_bits: i32) -> Table {
    let j = root_index_bits(interface);
    let step = exp2(-j);
    let (mut values, mut slopes) = (Vec::new(), Vec::new());
    for row in 0..4usize << j {
        let a = row as f64 * step;
        if a < 1.0 {
            values.push(1.0);
            slopes.push(0.0);
            continue;
        }
        let root = |m: f64| 1.0 / libm::sqrt(m);
        let slope = (root(a) - root(a + step)) / step;
        // Where the curve is parallel to the chord: m^(-3/2) / 2 = slope.
        let parallel = libm::pow(2.0 * slope, -2.0 / 3.0);
        let below = root(a) - slope * (parallel - a) - root(parallel);
        values.push(root(a) - 0.5 * below);
        slopes.push(slope);
    }
    let [start, slope] = root_fields(light);
    let keys = (0..values.len()).map(|row| row as f64 * step).collect();
    let fields = vec![
        rounded_field(start, "1/sqrt(m) at the segment's start", frac_bits, values),
        rounded_field(slope, "its fall", frac_bits - j + 1, slopes),
    ];
    Table::listed(root_memory(light), "entry", keys, fields)
}

/// Whether the address of a memory of the lobe changes with its operand.
fn follows_operand(graph: &Graph, memory: usize) -> bool {
    let mut varies = vec![false; graph.nodes.len()];
    for (id, node) in graph.nodes.iter().enumerate() {
        varies[id] = id == graph.operand() || node.args.iter().any(|&arg| varies[arg]);
    }
    let reads = |op: Op| matches!(op, Op::Field { memory: of, .. } if of == memory);
    graph.nodes.iter().any(|node| reads(node.op) && varies[node.args[0]])
}

/// The lobe's memories for each light: those that the material alone addresses are shared.
fn lobe_memories(lobe: &Datapath, lights: usize, tables: &mut Vec<Table>) -> Vec<Vec<usize>> {
    tables.extend(lobe.tables.iter().cloned());
    (0..lights)
        .map(|light| {
            let of = |(memory, table): (usize, &Table)| {
                if light == 0 || !follows_operand(&lobe.graph, memory) {
                    return memory;
                }
                tables.push(table.clone().named(interned(format!("{}_{}", table.name, light + 1))));
                tables.len() - 1
            };
            lobe.tables.iter().enumerate().map(of).collect()
        })
        .collect()
}

/// The shader's graph under construction.
struct Shading<'a, 'b> {
    b: Builder<'b>,
    interface: &'a Interface,
    shader: &'a Shader,
    widths: ShaderWidths,
    /// The place of the memory with the colours; those with the roots follow it.
    colours: usize,
    material: NodeId,
    normal: [NodeId; 3],
}

/// The ports of a light, three each.
struct LightPorts {
    direction: [NodeId; 3],
    half: Option<[NodeId; 3]>,
    colour: Option<[NodeId; 3]>,
}

/// The nodes of a light at which a shader falls into parts that can be looked at one by one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Joints {
    /// Where the cosine takes a root: s = 2 + 2 L.V and a = N.L + N.V, as they go into it.
    pub root: Option<[NodeId; 2]>,
    /// The lobe's operand.
    pub operand: NodeId,
    /// The lobe's result.
    pub lobe: NodeId,
    /// Whether the light is behind the surface.
    pub dark: NodeId,
    /// N.L for the diffuse term.
    pub psi: NodeId,
}

impl Joints {
    fn nodes(&mut self) -> impl Iterator<Item = &mut NodeId> {
        let Self { root, operand, lobe, dark, psi } = self;
        root.iter_mut().flatten().chain([operand, lobe, dark, psi])
    }
}

impl Shading<'_, '_> {
    /// The three ports of a vector, signed Q1.f.
    fn vector(&mut self, name: &str) -> [NodeId; 3] {
        let format = Format::signed(1, self.shader.vector_fraction as i32);
        AXES.map(|axis| self.b.port(format, &format!("in_{name}{axis}")))
    }

    /// The ports of a light.
    fn light_ports(&mut self, light: usize) -> LightPorts {
        let l = light + 1;
        let channel = Format::unsigned(0, self.shader.channel_bits as i32);
        let direction = self.vector(&format!("l{l}"));
        let half = (self.shader.cosine == Cosine::Half).then(|| self.vector(&format!("h{l}")));
        let colour = (self.shader.light_colours == LightColours::Ports)
            .then(|| CHANNELS.map(|c| self.b.port(channel, &format!("in_l{l}{c}"))));
        LightPorts { direction, half, colour }
    }

    /// A scalar product.
    fn dot(&mut self, a: [NodeId; 3], c: [NodeId; 3], name: &str, what: &str) -> NodeId {
        parts::dot(&mut self.b, &a, &c, None, name, what)
    }

    /// N.L in [0, 1], rounded down, and whether it is 0 before that.
    fn incidence(&mut self, direction: [NodeId; 3], light: usize) -> (NodeId, NodeId) {
        let l = light + 1;
        let dot = self.dot(self.normal, direction, &format!("nl{l}"), "N.L");
        let exact = self.b.clamp_to_unit(dot, &format!("nl{l}_exact"), "N.L, taken into [0, 1]: no light from behind");
        let lit = self.b.reaches(exact, -self.b.format(exact).frac_bits, &format!("lit{l}"), "N.L > 0");
        let lit = lit.expect("N.L has bits");
        let dark = self.b.not(lit, &format!("dark{l}"), "the light is behind the surface");
        (self.b.floor(exact, self.widths.dot, &format!("nl{l}"), "N.L, rounded down"), dark)
    }

    /// A scalar product, rounded down and clamped to [-1, 1], where those of unit vectors lie.
    fn cosine(&mut self, a: [NodeId; 3], c: [NodeId; 3], name: &str, what: &str) -> NodeId {
        let dot = self.dot(a, c, name, what);
        let bits = self.widths.dot;
        let dot = self.b.floor(dot, bits, &format!("{name}_cut"), &format!("{what}, rounded down"));
        let one = 1i128 << self.b.format(dot).frac_bits;
        self.b.clamp(dot, -one, one, name, &format!("{what}, taken into [-1, 1]"))
    }

    /// The lobe's operand: `value` rounded to nearest and clamped to [0, 1].
    fn operand(&mut self, value: NodeId, name: &str, comment: &str) -> NodeId {
        let bits = self.widths.x;
        let half = self.b.half_ulp(bits);
        let sum = self.b.add(value, half, &format!("{name}_half"), "plus half a last bit");
        let cut = self.b.floor(sum, bits, &format!("{name}_cut"), "rounded to nearest");
        let cut = self.padded(cut, bits, &format!("{name}_padded"));
        self.b.clamp_to_unit(cut, name, comment)
    }

    fn padded(&mut self, a: NodeId, frac_bits: i32, name: &str) -> NodeId {
        let format = self.b.format(a);
        if format.frac_bits >= frac_bits {
            return a;
        }
        self.b.cast(a, Format { frac_bits, ..format }, HighBits::Unused, name, "with zeros")
    }

    /// `u = |N - H|^2 / 2`.
    fn half_vector(&mut self, half: [NodeId; 3], light: usize) -> NodeId {
        let squares = [0, 1, 2].map(|axis| {
            let (l, a) = (light + 1, AXES[axis]);
            let d = self.b.sub(self.normal[axis], half[axis], &format!("d{l}_{a}"), "a component of N - H");
            self.b.mul(d, d, &format!("dd{l}_{a}"), "its square")
        });
        let sum = self.b.add(squares[0], squares[1], &format!("dd{}_xy", light + 1), "|N - H|^2");
        let sum = self.b.add(sum, squares[2], &format!("dd{}_xyz", light + 1), "|N - H|^2");
        let u = self.b.scale(sum, None, -1, &[-1], &format!("u{}_exact", light + 1), "|N - H|^2 / 2");
        self.operand(u, &format!("u{}", light + 1), "u = |N - H|^2 / 2, the versine, taken into [0, 1]")
    }

    /// `x = 2 (N.L)(N.V) - L.V`.
    fn mirror(&mut self, [nl, nv, lv]: [NodeId; 3], light: usize) -> NodeId {
        let l = light + 1;
        let product = self.b.mul(nl, nv, &format!("nlv{l}"), "(N.L)(N.V)");
        let twice = self.b.scale(product, None, 1, &[1], &format!("nlv{l}_twice"), "2 (N.L)(N.V)");
        let x = self.b.sub(twice, lv, &format!("x{l}_exact"), "2 (N.L)(N.V) - L.V");
        self.operand(x, &format!("x{l}"), "x = 2 (N.L)(N.V) - L.V, taken into [0, 1]")
    }

    /// `x = (N.L + N.V) / sqrt(2 + 2 L.V)`. With `s = 2 + 2 L.V = m 4^-k`, m from 1 to 4, it is
    /// `min(2, a 2^k) / sqrt(m)`. With it what goes into the root, s and a.
    fn root(&mut self, [nl, nv, lv]: [NodeId; 3], light: usize) -> (NodeId, [NodeId; 2]) {
        let l = light + 1;
        let a = self.b.add(nl, nv, &format!("a{l}_exact"), "N.L + N.V");
        let d = self.b.format(a).frac_bits;
        let mut a = self.b.clamp(a, 0, 2 << d, &format!("a{l}"), "N.L + N.V, taken into [0, 2]");
        let twice = self.b.scale(lv, None, 1, &[1], &format!("lv{l}_twice"), "2 L.V");
        let two = self.b.constant(2, Format::unsigned(2, 0), "two");
        let s = self.b.add(twice, two, &format!("s{l}_exact"), "s = 2 + 2 L.V");
        let ds = self.b.format(s).frac_bits;
        let mut s = self.b.clamp(s, 0, (4 << ds) - 1, &format!("s{l}"), "s = 2 + 2 L.V, kept below 4");
        let joints = [s, a];
        for amount in [16, 8, 4, 2].into_iter().filter(|&amount| amount < ds + 2) {
            let name = |what: &str| format!("{what}{l}_{amount}");
            let high = self.b.reaches(s, 2 - amount, &name("high"), &format!("the first {amount} bits of s"));
            let high = high.expect("s has these bits");
            let low =
                self.b.cast(s, Format::unsigned(2 - amount, ds), HighBits::Guarded, &name("s_low"), "without them");
            let up = self.b.scale(low, None, amount, &[amount], &name("s_up"), &format!("s 2^{amount}"));
            s = self.b.select(high, [s, up], |_| None, &name("s"), &format!("s, times 2^{amount} if it is so small"));
            let up = self.b.scale(a, None, amount / 2, &[amount / 2], &name("a_up"), &format!("a 2^{}", amount / 2));
            let two = 2i128 << self.b.format(up).frac_bits;
            let up = self.b.clamp(up, 0, two, &name("a_kept"), "at most 2");
            a = self.b.select(high, [a, up], |_| None, &name("a"), "a, times the root of the same");
        }
        let bits = self.widths.root;
        let s = self.b.floor(s, bits, &format!("m{l}"), "m = s 4^k, rounded down");
        let a = self.b.floor(a, bits, &format!("a{l}_scaled"), "a 2^k, rounded down");
        let ds = self.b.format(s).frac_bits;
        let j = root_index_bits(self.interface);
        let row = self.b.cast(s, Format::unsigned(2, j), HighBits::Unused, &format!("m{l}_high"), "the segment of m");
        let row = self.b.scale(row, None, j, &[j], &format!("segment{l}"), "its number");
        let [root, slope] = root_fields(light).map(|name| self.b.field(self.colours + 1 + light, row, name));
        let offset = self.b.cast(
            s,
            Format::unsigned(-j, ds),
            HighBits::Guarded,
            &format!("offset{l}"),
            "m from the segment's start",
        );
        let fall = self.b.mul(slope, offset, &format!("fall{l}_exact"), "slope times offset");
        let fall = self.b.floor(fall, bits, &format!("fall{l}"), "rounded down");
        let root = self.b.sub(root, fall, &format!("root{l}"), "1/sqrt(m)");
        let x = self.b.mul(a, root, &format!("x{l}_exact"), "a 2^k / sqrt(m)");
        (self.operand(x, &format!("x{l}"), "x = (N.L + N.V) / sqrt(2 + 2 L.V), taken into [0, 1]"), joints)
    }

    /// The lobe's operand for a light, and where it takes a root what goes into that; `viewer` is V with N.V, where H
    /// is not given.
    fn front(
        &mut self,
        light: usize,
        ports: &LightPorts,
        nl: NodeId,
        viewer: Option<([NodeId; 3], NodeId)>,
    ) -> (NodeId, Option<[NodeId; 2]>) {
        let (viewer, nv) = match (ports.half, viewer) {
            (Some(half), _) => return (self.half_vector(half, light), None),
            (None, viewer) => viewer.expect("H is given, or V is"),
        };
        let lv = self.cosine(ports.direction, viewer, &format!("lv{}", light + 1), "L.V");
        if self.shader.cosine == Cosine::Mirror {
            return (self.mirror([nl, nv, lv], light), None);
        }
        let (x, root) = self.root([nl, nv, lv], light);
        (x, Some(root))
    }

    /// `sum`, what the lights before have given to a channel, and what this one gives to it.
    fn add_light(
        &mut self,
        sum: Option<NodeId>,
        channel: usize,
        light: usize,
        [psi, spec]: [NodeId; 2],
        colour: Option<[NodeId; 3]>,
    ) -> NodeId {
        let (l, c, bits, b) = (light + 1, CHANNELS[channel], self.widths.term, &mut self.b);
        let [_, diffuse, specular] = colour_names(self.shader, channel, light);
        let mut term = |factor: &'static str, cosine: NodeId, name: &str| {
            let k = b.field(self.colours, self.material, factor);
            let product = b.mul(k, cosine, &format!("{name}_exact"), "colour times cosine");
            b.floor(product, bits, name, "rounded down")
        };
        let diffuse = term(diffuse, psi, &format!("dif{l}_{c}"));
        let specular = term(specular, spec, &format!("spc{l}_{c}"));
        let mut both = b.add(diffuse, specular, &format!("both{l}_{c}"), "diffuse and specular");
        if let Some(colour) = colour {
            let lit = b.mul(both, colour[channel], &format!("lit{l}_{c}_exact"), "times the light's colour");
            both = b.floor(lit, bits, &format!("lit{l}_{c}"), "rounded down");
        }
        match sum {
            None => both,
            Some(before) => b.add(before, both, &format!("lights{l}_{c}"), "the lights so far"),
        }
    }

    /// A channel of the ambient light.
    fn ambient(&mut self, channel: usize) -> NodeId {
        self.b.field(self.colours, self.material, colour_names(self.shader, channel, 0)[0])
    }

    /// The code of a channel, from what the lights give to it.
    fn code(&mut self, lights: NodeId, channel: usize) -> NodeId {
        let ambient = self.ambient(channel);
        let name = format!("sum_{}", CHANNELS[channel]);
        let sum = self.b.add(lights, ambient, &name, "with the ambient light");
        parts::channel_code(&mut self.b, sum, channel, self.shader.channel_bits)
    }

    /// The outputs, from what the lights give to each channel.
    fn outputs(&mut self, lights: [NodeId; 3]) -> Vec<(&'static str, NodeId)> {
        if self.shader.most_lights.is_none() {
            return (0..3).map(|channel| (parts::CODES[channel], self.code(lights[channel], channel))).collect();
        }
        let ShaderWidths { term, k, .. } = self.widths;
        let sums = [0, 1, 2].map(|c| (parts::SUMS[c], parts::channel_sum(&mut self.b, lights[c], c, term)));
        let ambients = [0, 1, 2].map(|channel| {
            let ambient = self.ambient(channel);
            let (format, name) = (Format::unsigned(0, k), format!("ambient_wide_{}", CHANNELS[channel]));
            let ambient = self.b.cast(ambient, format, HighBits::Unused, &name, "with all bits of a colour");
            (parts::AMBIENTS[channel], ambient)
        });
        [sums, ambients].concat()
    }
}

/// The shader around `lobe`, with each light's joints, or `None` if a value would be too wide for this crate.
///
/// The inputs are `in_material`, N, V where it is used, and for each light L, H where it is given, and its colour where
/// that comes from ports. The outputs are the codes of the three channels, or where lights come in sequence their sums
/// and the ambient light.
#[must_use]
pub fn build(interface: &Interface, shader: &Shader, lobe: &Datapath) -> Option<(Datapath, Vec<Joints>)> {
    let widths = shader.widths(interface);
    let lights = shader.lights as usize;
    let mut tables = Vec::new();
    let memories = lobe_memories(lobe, lights, &mut tables);
    let colours_place = tables.len();
    tables.push(colours(interface, shader, widths.k));
    if shader.cosine == Cosine::Sqrt {
        tables.extend((0..lights).map(|light| roots(interface, light, widths.root)));
    }
    let shininess = interface.shininess.values().into_iter().fold(1.0, f64::max);
    let case = Case { active: Interval::UNIT, shininess, rows: vec![None; tables.len()] };
    let mut b = Builder::new(&tables, vec![case]);
    let material = material_port(&mut b, &interface.shininess);
    let mut shading = Shading { b, interface, shader, widths, colours: colours_place, material, normal: [0; 3] };
    shading.normal = shading.vector("n");
    let viewer = (shader.cosine != Cosine::Half).then(|| shading.vector("v"));
    let ports: Vec<LightPorts> = (0..lights).map(|light| shading.light_ports(light)).collect();
    let viewer = viewer.map(|viewer| (viewer, shading.cosine(shading.normal, viewer, "nv", "N.V")));
    let mut sums: [Option<NodeId>; 3] = [None; 3];
    let mut joints = Vec::new();
    for (light, ports) in ports.iter().enumerate() {
        let l = light + 1;
        let (nl, dark) = shading.incidence(ports.direction, light);
        let (operand, root) = shading.front(light, ports, nl, viewer);
        let b = &mut shading.b;
        let given = [(lobe.graph.index(), material), (operand_clamp(&lobe.graph), operand)];
        let lobe = b.graft(&lobe.graph, &memories[light], &given, &format!("lobe{l}"));
        let spec = b.zero_if(Some(dark), lobe, &format!("spec{l}"), "no highlight from a light behind the surface");
        let psi = b.floor(nl, widths.cos, &format!("psi{l}"), "N.L for the diffuse term, rounded down");
        for (channel, sum) in sums.iter_mut().enumerate() {
            *sum = Some(shading.add_light(*sum, channel, light, [psi, spec], ports.colour));
        }
        joints.push(Joints { root, operand, lobe, dark, psi });
    }
    let outputs = shading.outputs(sums.map(|sum| sum.expect("there are lights")));
    let graph = shading.b.finish(&outputs, joints.iter_mut().flat_map(Joints::nodes))?;
    Some((Datapath { graph, tables, errors: lobe.errors.clone(), constants: lobe.constants.clone() }, joints))
}

/// The port `in_material`.
fn material_port(b: &mut Builder, set: &Shininess) -> NodeId {
    let last = f64::from(set.index_of_row(set.rows() - 1));
    let bound = Bound { range: Interval::new(0.0, last), error: Interval::ZERO, grid: 0 };
    b.input(Format::unsigned(set.index_bits() as i32, 0), "in_material", |_| bound)
}

/// The node that takes the lobe's operand into [0, 1]: the shader's front end has done so already.
fn operand_clamp(graph: &Graph) -> NodeId {
    let clamps =
        |&id: &NodeId| matches!(graph.nodes[id].op, Op::Clamp { .. }) && graph.nodes[id].args == [graph.operand()];
    (0..graph.nodes.len()).find(clamps).expect("every lobe takes its operand into [0, 1]")
}
