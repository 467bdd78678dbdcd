//! The shader: scalar products, the cosine of the highlight, the lobe, the sum of the lights' colours.

use super::{Cosine, LightColours, Shader, ShaderWidths};
use crate::fixed::Table;
use crate::fixed::wide::{self, Wide};
use crate::method::{Interface, Model};

/// The function of a shader core for one interface.
#[derive(Clone, Debug)]
pub struct ShaderModel<'a> {
    lobe: Model<'a>,
    interface: &'a Interface,
    shader: &'a Shader,
    widths: ShaderWidths,
    tables: &'a [Table],
}

/// The cosines of a light, as the hardware has them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cosines {
    /// N.L in [0, 1], for the diffuse term.
    pub diffuse: Wide,
    /// The lobe's operand in [0, 1]: the cosine x, or the versine u where H is given.
    pub operand: Wide,
    /// Whether N.L is above 0.
    pub lit: bool,
}

type Vector = [Wide; 3];

fn dot(a: Vector, b: Vector) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl<'a> ShaderModel<'a> {
    /// The model of a shader around `lobe` with these ROM words.
    #[must_use]
    pub fn new(interface: &'a Interface, shader: &'a Shader, lobe: Model<'a>, tables: &'a [Table]) -> Self {
        Self { lobe, interface, shader, widths: shader.widths(interface), tables }
    }

    /// The codes of `out_r`, `out_g` and `out_b` for the codes of the input ports in their order; where lights come in
    /// sequence, of `out_sum_r` and so on, and of `out_ambient_r` and so on.
    #[must_use]
    pub fn evaluate(&self, inputs: &[i64]) -> Vec<i64> {
        let (index, cosines, colours) = self.taken_apart(inputs);
        let row = self.interface.shininess.row_of_index(index);
        let bits = self.shader.channel_bits;
        let highlights: Vec<Wide> = cosines.iter().map(|light| self.highlight(index, light)).collect();
        let ambient = |channel: usize| self.colour(row, "ambient", channel, None);
        let of_lights = |channel: usize| {
            let mut sum = Wide::ZERO;
            for (light, (cosines, &highlight)) in cosines.iter().zip(&highlights).enumerate() {
                let diffuse = self.term(self.colour(row, "diffuse", channel, Some(light)) * cosines.diffuse);
                let specular = self.term(self.colour(row, "specular", channel, Some(light)) * highlight);
                sum += match &colours {
                    None => diffuse + specular,
                    Some(colours) => self.term((diffuse + specular) * colours[light][channel]),
                };
            }
            sum
        };
        if self.shader.most_lights.is_some() {
            let ShaderWidths { term, k, .. } = self.widths;
            let sums = (0..3).map(|channel| wide::to_code(of_lights(channel).min(Wide::ONE), term as u32) as i64);
            return sums.chain((0..3).map(|channel| wide::to_code(ambient(channel), k as u32) as i64)).collect();
        }
        let code = |channel: usize| {
            let sum = ambient(channel) + of_lights(channel);
            let nearest = wide::to_code(sum + wide::from_code(1, bits + 1), bits) as i64;
            nearest.min(self.shader.full_scale())
        };
        (0..3).map(code).collect()
    }

    /// The cosines of each light.
    #[must_use]
    pub fn cosines(&self, inputs: &[i64]) -> Vec<Cosines> {
        self.taken_apart(inputs).1
    }

    /// The lobe of a light as a number, 0 where the light is behind the surface.
    #[must_use]
    pub fn highlight(&self, index: u32, light: &Cosines) -> Wide {
        if !light.lit {
            return Wide::ZERO;
        }
        let operand = wide::to_code(light.operand, self.interface.input_fraction) as i64;
        wide::from_code(self.lobe.evaluate(index, operand).into(), self.interface.output_fraction)
    }

    /// The material's code, the cosines of each light, and the lights' colours where they come from ports.
    fn taken_apart(&self, inputs: &[i64]) -> (u32, Vec<Cosines>, Option<Vec<Vector>>) {
        let mut codes = inputs.iter().copied();
        let mut next = || i128::from(codes.next().expect("a code for every port"));
        let index = next() as u32;
        let mut vector = |frac_bits: u32| [(); 3].map(|()| wide::from_code(next(), frac_bits));
        let f = self.shader.vector_fraction;
        let normal = vector(f);
        let viewer = (self.shader.cosine != Cosine::Half).then(|| vector(f));
        let (mut cosines, mut colours) = (Vec::new(), Vec::new());
        for light in 0..self.shader.lights as usize {
            let direction = vector(f);
            // Behind the light stands its half vector, where it is given; else the viewer serves every light.
            let other = viewer.unwrap_or_else(|| vector(f));
            cosines.push(self.light(light, normal, direction, other));
            if self.shader.light_colours == LightColours::Ports {
                colours.push(vector(self.shader.channel_bits));
            }
        }
        (index, cosines, (!colours.is_empty()).then_some(colours))
    }

    /// `other` is the viewer, or the half vector where that is given.
    fn light(&self, light: usize, normal: Vector, direction: Vector, other: Vector) -> Cosines {
        let floor = |value: Wide, bits: i32| wide::floor_to(value, bits as u32);
        let ShaderWidths { dot: dot_bits, x: bits, cos, .. } = self.widths;
        let (zero, one) = (Wide::ZERO, Wide::ONE);
        let incidence = dot(normal, direction);
        let nl = floor(incidence, dot_bits).clamp(zero, one);
        let cosine = |a: Vector, b: Vector| floor(dot(a, b), dot_bits).clamp(-one, one);
        let exact = match self.shader.cosine {
            Cosine::Half => {
                let d = [0, 1, 2].map(|axis| normal[axis] - other[axis]);
                dot(d, d) / 2
            }
            Cosine::Mirror => 2 * nl * cosine(normal, other) - cosine(direction, other),
            Cosine::Sqrt => self.root(light, nl + cosine(normal, other), cosine(direction, other)),
        };
        let bits = bits as u32;
        let operand = wide::floor_to(exact + wide::from_code(1, bits + 1), bits).clamp(zero, one);
        Cosines { diffuse: floor(nl, cos), operand, lit: incidence > 0 }
    }

    /// `a / sqrt(s)` with `s = 2 + 2 L.V`: with `s = m 4^-k`, m from 1 to 4, `min(2, a 2^k)` times the straight line
    /// for `1/sqrt(m)`.
    fn root(&self, light: usize, a: Wide, lv: Wide) -> Wide {
        let two = Wide::from_num(2);
        let last = wide::from_code(1, self.widths.dot as u32 - 1);
        let mut m = (two + 2 * lv).min(2 * two - last);
        let mut a = a.max(Wide::ZERO);
        // For s = 0 as often as the circuit can shift; the line for m = 0 is 1.
        let mut shifts = 0;
        let most: u32 = [16, 8, 4, 2].into_iter().filter(|&shift| shift <= self.widths.dot as u32).sum();
        while m < 1 && shifts < most / 2 {
            (m, a, shifts) = (m * 4, (a * 2).min(two), shifts + 1);
        }
        let bits = self.widths.root as u32;
        let (m, a) = (wide::floor_to(m, bits), wide::floor_to(a.min(two), bits));
        let memory = format!("root_{}", light + 1);
        let table = self.tables.iter().find(|table| table.name == memory).expect("a table of roots");
        let entry = |name: &str, row: usize| {
            let field = table.field(&format!("{name}_{}", light + 1));
            wide::from_code(field.codes[row], field.format.frac_bits as u32)
        };
        let segments = table.rows() as u32 / 4;
        let row = (m * Wide::from_num(segments)).to_num::<usize>();
        let offset = m - Wide::from_num(row) / Wide::from_num(segments);
        let fall = wide::floor_to(entry("slope", row) * offset, bits);
        a * (entry("start", row) - fall)
    }

    /// A colour in the ROM; those of a light are its own where the lights' colours are constants.
    fn colour(&self, row: usize, what: &str, channel: usize, light: Option<usize>) -> Wide {
        let of_light = match (&self.shader.light_colours, light) {
            (LightColours::Fixed(_), Some(light)) => format!("_{}", light + 1),
            _ => String::new(),
        };
        let name = format!("{what}_{}{of_light}", ["r", "g", "b"][channel]);
        let table = self.tables.iter().find(|table| table.name == "colours").expect("a table of colours");
        let field = table.field(&name);
        wide::from_code(field.codes[row], field.format.frac_bits as u32)
    }

    fn term(&self, value: Wide) -> Wide {
        wide::floor_to(value, self.widths.term as u32)
    }
}
