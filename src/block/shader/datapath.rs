//! A shader around a lobe: scalar products, the cosine of the highlight, the lobe, and the sum of the lights' colours.
//!
//! The lobe is any method's own graph, taken over operation by operation ([`Builder::graft`]), once a light. What is around it is analysed
//! here over all codes of the vectors' ports, of unit length or not: every code has a defined result.

use super::{Cosine, LightColours, Shader};
use crate::datapath::Datapath;
use crate::datapath::builder::{Bound, Builder, Case};
use crate::datapath::graph::{Graph, NodeId, Op};
use crate::fixed::{Field, Format, Interval, Table, Widths, exp2, interned};
use crate::method::polynomial::datapath::{field, nearest_code};
use crate::method::{Interface, Shininess};

/// The name of the memory with the materials' colours.
pub const COLOURS: &str = "colours";

/// Red, green and blue in names.
const CHANNELS: [char; 3] = ['r', 'g', 'b'];
const AXES: [char; 3] = ['x', 'y', 'z'];

/// The name of the memory with the reciprocal roots of a light, counted from 0.
#[must_use]
pub fn root_memory(light: usize) -> &'static str {
    interned(format!("root_{}", light + 1))
}

/// The names of the fields of that memory: the root at a segment's start, and its fall.
fn root_fields(light: usize) -> [&'static str; 2] {
    [interned(format!("start_{}", light + 1)), interned(format!("slope_{}", light + 1))]
}

/// The names of a channel's colours in the ROM: ambient, and diffuse and specular of a light (of none in particular where the lights'
/// colours come from ports).
#[must_use]
pub fn colour_names(shader: &Shader, channel: usize, light: usize) -> [&'static str; 3] {
    let c = CHANNELS[channel];
    let of = match shader.light_colours {
        LightColours::Ports => String::new(),
        LightColours::Fixed(_) => format!("_{}", light + 1),
    };
    [interned(format!("ambient_{c}")), interned(format!("diffuse_{c}{of}")), interned(format!("specular_{c}{of}"))]
}

/// The colours of each material, as they stand in the ROM: in units in which full scale is the greatest code, `1 - 2^-bits`.
///
/// Light colours that are constants are multiplied in. One that is a port's code c stands for `c / (2^bits - 1)`, so that its product with
/// k is `k c 2^-bits` in these units, and k is in the ROM as it is.
fn colours(interface: &Interface, shader: &Shader, frac_bits: i32) -> Table {
    let surfaces = Shader::surfaces(interface);
    let full = shader.full_scale() as f64 * exp2(-(shader.channel_bits as i32));
    let column = |name: &'static str, meaning: &'static str, value: &dyn Fn(usize) -> f64| -> Field {
        let reals: Vec<f64> = (0..surfaces.len()).map(value).collect();
        let codes = reals.iter().map(|&real| nearest_code(real, frac_bits)).collect();
        field(name, meaning, frac_bits, codes, reals)
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

/// `1/sqrt(m)` for m from 1 to 4 in straight lines, a row a segment; each lies half its largest error below the chord. Below 1, where
/// only m = 0 falls, it is 1.
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
    let codes = |reals: &[f64], bits: i32| reals.iter().map(|&real| nearest_code(real, bits)).collect();
    let slope_bits = frac_bits - j + 1;
    let [start, slope] = root_fields(light);
    let keys = (0..values.len()).map(|row| row as f64 * step).collect();
    let fields = vec![
        field(start, "1/sqrt(m) at the segment's start", frac_bits, codes(&values, frac_bits), values),
        field(slope, "its fall", slope_bits, codes(&slopes, slope_bits), slopes),
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
                tables.push(table.clone().renamed(interned(format!("{}_{}", table.name, light + 1))));
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
    widths: Widths,
    normal: [NodeId; 3],
}

impl Shading<'_, '_> {
    /// The three ports of a vector, signed Q1.f.
    fn vector(&mut self, name: &str) -> [NodeId; 3] {
        let format = Format::signed(1, self.shader.vector_fraction as i32);
        let range = Interval::new(format.value(format.min_code()), format.value(format.max_code()));
        AXES.map(|axis| {
            let bound = Bound { range, error: Interval::ZERO, grid: format.frac_bits };
            self.b.input(format, &format!("in_{name}{axis}"), |_| bound)
        })
    }

    /// A scalar product.
    fn dot(&mut self, a: [NodeId; 3], c: [NodeId; 3], name: &str, what: &str) -> NodeId {
        let products = [0, 1, 2].map(|axis| self.b.mul(a[axis], c[axis], &format!("{name}_{}", AXES[axis]), what));
        let sum = self.b.add(products[0], products[1], &format!("{name}_xy"), what);
        self.b.add(sum, products[2], &format!("{name}_xyz"), what)
    }

    /// N.L in [0, 1], rounded down, and whether it is 0 before that.
    fn incidence(&mut self, direction: [NodeId; 3], light: usize) -> (NodeId, Option<NodeId>) {
        let l = light + 1;
        let dot = self.dot(self.normal, direction, &format!("nl{l}"), "N.L");
        let exact = self.b.clamp_to_unit(dot, &format!("nl{l}_exact"), "N.L, taken into [0, 1]: no light from behind");
        let lit = self.b.reaches(exact, -self.b.format(exact).frac_bits, &format!("lit{l}"), "N.L > 0");
        let dark = lit.map(|lit| self.b.not(lit, &format!("dark{l}"), "the light is behind the surface"));
        (self.b.floor(exact, self.widths.get("dot"), &format!("nl{l}"), "N.L, rounded down"), dark)
    }

    /// A scalar product, rounded down and taken into [-1, 1], where those of unit vectors lie.
    fn cosine(&mut self, a: [NodeId; 3], c: [NodeId; 3], name: &str, what: &str) -> NodeId {
        let dot = self.dot(a, c, name, what);
        let bits = self.widths.get("dot");
        let dot = self.b.floor(dot, bits, &format!("{name}_cut"), &format!("{what}, rounded down"));
        let one = 1i128 << self.b.format(dot).frac_bits;
        self.b.clamp(dot, -one, one, name, &format!("{what}, taken into [-1, 1]"))
    }

    /// The lobe's operand: `value` rounded to nearest and taken into [0, 1].
    fn operand(&mut self, value: NodeId, name: &str, comment: &str) -> NodeId {
        let bits = self.widths.get("x");
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
        self.b.cast(a, Format { frac_bits, ..format }, false, name, "with zeros")
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

    /// `x = (N.L + N.V) / sqrt(2 + 2 L.V)`. With `s = 2 + 2 L.V = m 4^-k`, m from 1 to 4, it is `min(2, a 2^k) / sqrt(m)`.
    fn root(&mut self, [nl, nv, lv]: [NodeId; 3], light: usize, memory: usize) -> NodeId {
        let l = light + 1;
        let a = self.b.add(nl, nv, &format!("a{l}_exact"), "N.L + N.V");
        let d = self.b.format(a).frac_bits;
        let mut a = self.b.clamp(a, 0, 2 << d, &format!("a{l}"), "N.L + N.V, taken into [0, 2]");
        let twice = self.b.scale(lv, None, 1, &[1], &format!("lv{l}_twice"), "2 L.V");
        let two = self.b.constant(2, Format::unsigned(2, 0), "two");
        let s = self.b.add(twice, two, &format!("s{l}_exact"), "s = 2 + 2 L.V");
        let ds = self.b.format(s).frac_bits;
        let mut s = self.b.clamp(s, 0, (4 << ds) - 1, &format!("s{l}"), "s = 2 + 2 L.V, kept below 4");
        for amount in [16, 8, 4, 2].into_iter().filter(|&amount| amount < ds + 2) {
            let name = |what: &str| format!("{what}{l}_{amount}");
            let high = self.b.reaches(s, 2 - amount, &name("high"), &format!("the first {amount} bits of s"));
            let high = high.expect("s has these bits");
            let low = self.b.cast(s, Format::unsigned(2 - amount, ds), true, &name("s_low"), "without them");
            let up = self.b.scale(low, None, amount, &[amount], &name("s_up"), &format!("s 2^{amount}"));
            s = self.b.select(high, [s, up], |_| None, &name("s"), &format!("s, times 2^{amount} if it is so small"));
            let up = self.b.scale(a, None, amount / 2, &[amount / 2], &name("a_up"), &format!("a 2^{}", amount / 2));
            let two = 2i128 << self.b.format(up).frac_bits;
            let up = self.b.clamp(up, 0, two, &name("a_kept"), "at most 2");
            a = self.b.select(high, [a, up], |_| None, &name("a"), "a, times the root of the same");
        }
        let bits = self.widths.get("root");
        let s = self.b.floor(s, bits, &format!("m{l}"), "m = s 4^k, rounded down");
        let a = self.b.floor(a, bits, &format!("a{l}_scaled"), "a 2^k, rounded down");
        let ds = self.b.format(s).frac_bits;
        let j = root_index_bits(self.interface);
        let row = self.b.cast(s, Format::unsigned(2, j), false, &format!("m{l}_high"), "the segment of m");
        let row = self.b.scale(row, None, j, &[j], &format!("segment{l}"), "its number");
        let [root, slope] = root_fields(light).map(|name| self.b.field(memory, row, name));
        let offset =
            self.b.cast(s, Format::unsigned(-j, ds), true, &format!("offset{l}"), "m from the segment's start");
        let fall = self.b.mul(slope, offset, &format!("fall{l}_exact"), "slope times offset");
        let fall = self.b.floor(fall, bits, &format!("fall{l}"), "rounded down");
        let root = self.b.sub(root, fall, &format!("root{l}"), "1/sqrt(m)");
        let x = self.b.mul(a, root, &format!("x{l}_exact"), "a 2^k / sqrt(m)");
        self.operand(x, &format!("x{l}"), "x = (N.L + N.V) / sqrt(2 + 2 L.V), taken into [0, 1]")
    }
}

/// The shader around `lobe`, or `None` if a value would be too wide for this crate.
///
/// The inputs are `in_material`, N, V where it is used, and for each light L, H where it is given, and its colour where that comes from
/// ports. The outputs are the codes of the three channels.
#[must_use]
pub fn build(interface: &Interface, shader: &Shader, lobe: &Datapath) -> Option<Datapath> {
    let widths = shader.widths(interface);
    let lights = shader.lights as usize;
    let mut tables = Vec::new();
    let memories = lobe_memories(lobe, lights, &mut tables);
    let colour_memory = tables.len();
    tables.push(colours(interface, shader, widths.get("k")));
    if shader.cosine == Cosine::Sqrt {
        tables.extend((0..lights).map(|light| roots(interface, light, widths.get("root"))));
    }
    let shininess = interface.shininess.values().into_iter().fold(1.0, f64::max);
    let case = Case { active: Interval::UNIT, shininess, rows: vec![None; tables.len()] };
    let mut b = Builder::new(&tables, vec![case]);
    let material = material_port(&mut b, &interface.shininess);
    let mut shading = Shading { b, interface, shader, widths: widths.clone(), normal: [0; 3] };
    shading.normal = shading.vector("n");
    let viewer = (shader.cosine != Cosine::Half).then(|| shading.vector("v"));
    let channel = Format::unsigned(0, shader.channel_bits as i32);
    let whole = Interval::new(0.0, channel.value(channel.max_code()));
    let ports: Vec<_> = (1..=lights)
        .map(|light| {
            let direction = shading.vector(&format!("l{light}"));
            let half = (shader.cosine == Cosine::Half).then(|| shading.vector(&format!("h{light}")));
            let colour = (shader.light_colours == LightColours::Ports).then(|| {
                let bound = Bound { range: whole, error: Interval::ZERO, grid: channel.frac_bits };
                CHANNELS.map(|c| shading.b.input(channel, &format!("in_l{light}{c}"), |_| bound))
            });
            (direction, half, colour)
        })
        .collect();

    let nv = viewer.map(|viewer| shading.cosine(shading.normal, viewer, "nv", "N.V"));
    let mut sums: [Option<NodeId>; 3] = [None; 3];
    for (light, (direction, half, colour)) in ports.into_iter().enumerate() {
        let l = light + 1;
        let (nl, dark) = shading.incidence(direction, light);
        let cosines = viewer.zip(nv).map(|(viewer, nv)| {
            let lv = shading.cosine(direction, viewer, &format!("lv{l}"), "L.V");
            [nl, nv, lv]
        });
        let operand = match (shader.cosine, cosines, half) {
            (Cosine::Half, _, Some(half)) => shading.half_vector(half, light),
            (Cosine::Mirror, Some(cosines), _) => shading.mirror(cosines, light),
            (Cosine::Sqrt, Some(cosines), _) => shading.root(cosines, light, colour_memory + 1 + light),
            _ => unreachable!("the ports of this cosine"),
        };
        let b = &mut shading.b;
        let given = [(lobe.graph.index(), material), (operand_clamp(&lobe.graph), operand)];
        let spec = b.graft(&lobe.graph, &memories[light], &given, &format!("lobe{l}"));
        let spec = b.zero_if(dark, spec, &format!("spec{l}"), "no highlight from a light behind the surface");
        let psi = b.floor(nl, widths.get("cos"), &format!("psi{l}"), "N.L for the diffuse term, rounded down");
        for (channel, sum) in sums.iter_mut().enumerate() {
            let c = CHANNELS[channel];
            let [_, diffuse, specular] = colour_names(shader, channel, light);
            let mut term = |factor: &'static str, cosine: NodeId, name: &str| {
                let k = b.field(colour_memory, material, factor);
                let product = b.mul(k, cosine, &format!("{name}_exact"), "colour times cosine");
                b.floor(product, widths.get("term"), name, "rounded down")
            };
            let diffuse = term(diffuse, psi, &format!("dif{l}_{c}"));
            let specular = term(specular, spec, &format!("spc{l}_{c}"));
            let mut both = b.add(diffuse, specular, &format!("both{l}_{c}"), "diffuse and specular");
            if let Some(colour) = colour {
                let lit = b.mul(both, colour[channel], &format!("lit{l}_{c}_exact"), "times the light's colour");
                both = b.floor(lit, widths.get("term"), &format!("lit{l}_{c}"), "rounded down");
            }
            *sum = Some(match *sum {
                None => both,
                Some(before) => b.add(before, both, &format!("lights{l}_{c}"), "the lights so far"),
            });
        }
    }
    let bits = shader.channel_bits as i32;
    let mut outputs = Vec::new();
    for (channel, lights) in sums.into_iter().enumerate() {
        let c = CHANNELS[channel];
        let b = &mut shading.b;
        let ambient = b.field(colour_memory, material, colour_names(shader, channel, 0)[0]);
        let sum =
            lights.map_or(ambient, |lights| b.add(lights, ambient, &format!("sum_{c}"), "with the ambient light"));
        let half = b.half_ulp(bits);
        let sum = b.add(sum, half, &format!("sum_half_{c}"), "plus half a code");
        let code = b.floor(sum, bits, &format!("cut_{c}"), "rounded to the nearest code");
        let most = shader.full_scale().into();
        let code = b.clamp(code, 0, most, &format!("kept_{c}"), "at most full scale");
        outputs.push(b.scale(code, None, bits, &[bits], &format!("code_{c}"), "as a whole number"));
    }
    let names = ["out_r", "out_g", "out_b"];
    let outputs: Vec<(&str, NodeId)> = names.into_iter().zip(outputs).collect();
    let graph = shading.b.finish(&outputs)?;
    Some(Datapath { graph, tables, errors: lobe.errors.clone(), constants: lobe.constants.clone() })
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

/// The joints of each light of a graph that [`build`] made for this shader.
///
/// # Panics
/// If the graph is another.
#[must_use]
pub fn joints(shader: &Shader, graph: &Graph) -> Vec<Joints> {
    let find = |name: String| graph.nodes.iter().position(|node| node.name == name).expect("the shader's own names");
    let of_light = |l: u32| {
        let highlight = &graph.nodes[find(format!("spec{l}"))].args;
        Joints {
            root: (shader.cosine == Cosine::Sqrt).then(|| ["s", "a"].map(|name| find(format!("{name}{l}")))),
            operand: find(format!("{}{l}", if shader.cosine == Cosine::Half { "u" } else { "x" })),
            dark: highlight[0],
            lobe: highlight[1],
            // Where it needs no rounding it has no name of its own.
            psi: graph.nodes[find(format!("dif{l}_{}_exact", CHANNELS[0]))].args[1],
        }
    };
    (1..=shader.lights).map(of_light).collect()
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
