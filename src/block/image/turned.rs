//! The operations that turn the normal to the images of the form paper; see [`super::turn`].

use super::StepJoints;
use super::datapath::{Imaging, LightPorts, Pair};
use super::turn::{ANGLE, HALF_TURN, ROOT, ROOT_AXIS, ROOT_OPERAND, ROOT_WEIGHT, SINE, STEPS, TILT};
use crate::datapath::builder::HighBits;
use crate::datapath::graph::{NodeId, Op};
use crate::fixed::Format;

/// A normal that is turned back by γ: its component across y and that towards the viewer.
struct Turnable {
    x: NodeId,
    z: NodeId,
}

impl Imaging<'_, '_> {
    /// Both factors' product, rounded down to the bits of places.
    fn place_product(&mut self, a: NodeId, c: NodeId, name: &str, what: &str) -> NodeId {
        let product = self.b.mul(a, c, &format!("{name}_exact"), what);
        self.b.floor(product, self.widths.place, name, "rounded down")
    }

    /// Where the texels of both images lie along x, in the even one and in the odd one, of a normal whose y is there.
    pub(super) fn turned(&mut self, ports: &LightPorts, y: NodeId, l: usize) -> [Pair; 2] {
        let turns = ports.turns.as_ref().expect("a turn for each image");
        let first = self.place_product(self.normal[0], ports.frame[1][1], &format!("x{l}_x"), "x, turned back");
        let second = self.place_product(self.normal[1], ports.frame[1][0], &format!("x{l}_y"), "x, turned back");
        let x = self.b.sub(first, second, &format!("x{l}_exact"), "the component across y of the normal, turned back");
        let one = 1i128 << self.widths.place;
        let x = self.b.clamp(x, -one, one, &format!("x{l}"), "of a unit vector it is at most 1");
        let tilt = self.tilt(&ports.frame[0], y, l);
        let half = self.b.constant(1 << (TILT - 1), Format::unsigned(1, TILT), "half_tilt");
        // A flag of its own: in VHDL a port is a vector.
        let alone = self.b.flag(Op::NonZero, &[turns.alone], &format!("alone{l}"), "whether one image is alone");
        let tilt = self.b.select(
            alone,
            [half, tilt],
            |_| None,
            &format!("tilt{l}"),
            "the sine of the angle to h; 1/2, which makes k = 3/4, where one image is alone",
        );
        let normal = Turnable { x, z: self.normal[2] };
        let halves = turns.halves;
        [0, 1].map(|parity| self.turned_to(&normal, halves[parity], tilt, parity, l))
    }

    /// sin αh = |n·(cos φ/2, 0, -sin φ/2)| / √(1 - y²), at most 1.
    fn tilt(&mut self, across: &[NodeId], y: NodeId, l: usize) -> NodeId {
        let d = self.across(across, "u", l);
        let none = self.b.constant(0, self.b.format(d), "none");
        let below = self.b.greater(none, d, &format!("u{l}_below"), "whether it is below 0");
        let minus = self.b.sub(none, d, &format!("u{l}_minus"), "its opposite");
        let d = self.b.select(below, [minus, d], |_| None, &format!("u{l}_either"), "on either side of h");
        let kept = self.widths.place;
        let d = self.b.clamp(d, 0, 1 << kept, &format!("u{l}_kept"), "of a unit vector it is at most 1");
        let y = self.b.clamp(y, -1 << kept, 1 << kept, &format!("v{l}_unit"), "y of a unit vector");
        let square = self.b.mul(y, y, &format!("v{l}_square"), "y^2");
        let one = self.b.constant(1, Format::unsigned(1, 0), "one");
        let rest = self.b.sub(one, square, &format!("rr{l}_exact"), "r^2 = 1 - y^2");
        let rest = self.b.floor(rest, ROOT_OPERAND, &format!("rr{l}_cut"), "rounded down");
        let rest = self.b.clamp(rest, 0, (1 << ROOT_OPERAND) - 1, &format!("rr{l}"), "r^2, below 1");
        let row = self.octave_column(rest, ROOT_AXIS, ROOT_WEIGHT as i32, "rr", &l.to_string());
        self.joints.steps.push(StepJoints { from: vec![rest], to: vec![row.texel, row.weight], row: None });
        let [root, fall] = self.fields(0, row.texel, l);
        let part = self.b.mul(fall, row.weight, &format!("fall_part{l}"), "its part");
        let root = self.b.sub(root, part, &format!("root_at{l}"), "1/r");
        let root = self.b.floor(root, ROOT, &format!("root_cut{l}"), "rounded down");
        let tilt = self.b.mul(d, root, &format!("tilt{l}_exact"), "the sine of the angle to h");
        let tilt = self.b.floor(tilt, TILT, &format!("tilt{l}_cut"), "rounded down");
        self.b.clamp(tilt, 0, 1 << TILT, &format!("tilt{l}_kept"), "at most 1")
    }

    /// The texels along x of one image: those of the row's end where the turned normal is behind the rim.
    fn turned_to(&mut self, normal: &Turnable, half: NodeId, tilt: NodeId, parity: usize, l: usize) -> Pair {
        let name = |what: &str| format!("{what}{l}_{}", ["even", "odd"][parity]);
        let more = self.b.mul(half, tilt, &name("turn_more_exact"), "its part by the tilt");
        let more = self.b.floor(more, ANGLE, &name("turn_more"), "rounded down");
        let turn = self.b.add(half, more, &name("turn_exact"), "the turn k (phi_i - phi), in right angles");
        let right = 1i128 << ANGLE;
        let turn = self.b.clamp(turn, -right, right - 1, &name("turn"), "less than a right angle");
        let one = self.b.constant(1, Format::unsigned(1, 0), "one");
        let up = self.b.add(turn, one, &name("turn_up"), "from minus a right angle");
        let up = self.b.cast(up, Format::unsigned(1, ANGLE), HighBits::Unused, &name("turn_from"), "not below 0");
        let row = self.b.cast(up, Format::unsigned(1, STEPS), HighBits::Unused, &name("step"), "the table's row");
        let row = self.b.scale(row, None, STEPS, &[STEPS], &name("step_number"), "its number");
        let past = Format::unsigned(-STEPS, ANGLE);
        let past = self.b.cast(up, past, HighBits::Guarded, &name("past"), "the angle past it");
        let past = self.b.scale(past, None, STEPS, &[STEPS], &name("past_part"), "as a part of the way to the next");
        let [sine, sine_rise, cosine, cosine_rise] = self.fields(1 + parity, row, l);
        let [sine, cosine] = [(sine, sine_rise, "sin"), (cosine, cosine_rise, "cos")].map(|(at, rise, what)| {
            let part = self.b.mul(rise, past, &name(&format!("{what}_part")), "its part of the rise");
            let sum = self.b.add(at, part, &name(&format!("{what}_exact")), "between two rows");
            self.b.floor(sum, SINE, &name(what), "rounded down")
        });
        let Turnable { x, z } = *normal;
        let xc = self.place_product(x, cosine, &name("xc"), "x cos");
        let zs = self.place_product(z, sine, &name("zs"), "z sin");
        let across = self.b.add(xc, zs, &name("across"), "x of the turned normal");
        let zc = self.place_product(z, cosine, &name("zc"), "z cos");
        let xs = self.place_product(x, sine, &name("xs"), "x sin");
        let behind = self.b.greater(xs, zc, &name("behind"), "whether it is behind the rim, z < 0");
        let place = self.along(across, &name("u"));
        let none = self.b.constant(0, HALF_TURN, "none");
        let back = self.b.greater(none, half, &name("back"), "whether it turns to negative x");
        let format = self.b.format(place);
        let last = self.b.constant((i128::from(self.image.size) - 1) << self.image.weight_bits, format, "last");
        let first = self.b.constant(0, format, "first");
        let end = self.b.select(back, [first, last], |_| None, &name("end"), "the end of the row on that side");
        let place = self.b.select(behind, [end, place], |_| None, &name("u_at"), "that end from behind the rim");
        let place = self.split(place, &name("u"));
        self.pair(place, self.image.size, &name("u"))
    }
}
