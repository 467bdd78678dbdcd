//! Pipeline registers, the chain of valid bits, and the table ROM.

use rust_hdl::prelude::*;

/// A change of the number of fraction bits by wiring alone: low bits are dropped (which rounds
/// down) or zeros are appended.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rescale {
    drop: usize,
    pad: usize,
}

impl Rescale {
    /// From `from` to `to` fraction bits.
    pub(super) fn new(from: usize, to: usize) -> Self {
        Self::through(from, to, to)
    }

    /// From `from` to `to` fraction bits of which at most the upper `kept` are taken from the
    /// value; the others are zero.
    pub(super) fn through(from: usize, kept: usize, to: usize) -> Self {
        let kept = kept.min(from);
        assert!(kept <= to, "{kept} fraction bits do not fit into {to}");
        Self { drop: from - kept, pad: to - kept }
    }

    /// The rescaled value, modulo `2^width`.
    pub(super) fn apply(self, value: u64, width: usize) -> u64 {
        let dropped = value.checked_shr(self.drop as u32).unwrap_or(0);
        dropped.checked_shl(self.pad as u32).unwrap_or(0) & low_ones(width)
    }

    /// The same as a Verilog expression over the vector `name` of `from` bits, exactly `to` bits
    /// wide so that no implicit extension or truncation is left to the reader.
    pub(super) fn verilog(self, name: &str, from: usize, to: usize) -> String {
        let taken = from.saturating_sub(self.drop).min(to.saturating_sub(self.pad));
        let pad = self.pad.min(to);
        let zeros = to - taken - pad;
        let mut parts = Vec::new();
        if zeros > 0 {
            parts.push(format!("{zeros}'d0"));
        }
        if taken > 0 {
            // A one-bit port is a scalar, which must not be indexed.
            parts.push(match from {
                1 => name.to_string(),
                _ => format!("{name}[{}:{}]", self.drop + taken - 1, self.drop),
            });
        }
        if pad > 0 {
            parts.push(format!("{pad}'d0"));
        }
        format!("{{{}}}", parts.join(", "))
    }
}

/// A word of `width` ones, for `width` up to 64.
pub(super) fn low_ones(width: usize) -> u64 {
    match width {
        0 => 0,
        _ => u64::MAX >> (64 - width),
    }
}

/// A pipeline register with a clock enable and without reset.
///
/// It may change the number of fraction bits on the way in, which costs wires only. It may be several in a row.
#[derive(LogicBlock)]
pub(super) struct Register<const D: usize, const Q: usize> {
    pub clock: Signal<In, Clock>,
    pub enable: Signal<In, Bit>,
    pub d: Signal<In, Bits<D>>,
    pub q: Signal<Out, Bits<Q>>,
    _rescale: Rescale,
    /// What those before the last hold, the first one's last.
    _before: Vec<u64>,
}

impl<const D: usize, const Q: usize> Register<D, Q> {
    pub(super) fn new(rescale: Rescale) -> Self {
        assert!(D <= 64 && Q <= 64, "a register of more than 64 bits");
        Self {
            clock: Signal::default(),
            enable: Signal::default(),
            d: Signal::default(),
            q: Signal::default(),
            _rescale: rescale,
            _before: Vec::new(),
        }
    }

    /// It, as so many in a row.
    pub(super) fn levels(self, levels: usize) -> Self {
        Self { _before: vec![0; levels - 1], ..self }
    }
}

impl<const W: usize> Default for Register<W, W> {
    fn default() -> Self {
        Self::new(Rescale::new(0, 0))
    }
}

impl<const D: usize, const Q: usize> Logic for Register<D, Q> {
    fn update(&mut self) {
        if self.clock.pos_edge() && self.enable.val() {
            self._before.push(self._rescale.apply(self.d.val().to_u64(), Q));
            self.q.next = self._before.remove(0).into();
        }
    }

    fn connect(&mut self) {
        self.q.connect();
    }

    fn hdl(&self) -> Verilog {
        let taken = self._rescale.verilog("d", D, Q);
        let mut declared = String::new();
        let mut moved = String::new();
        let mut from = taken;
        for level in 0..self._before.len() {
            declared += &format!("reg [{}:0] level_{level};\n\n", Q - 1);
            moved += &format!("      level_{level} <= {from};\n");
            from = format!("level_{level}");
        }
        Verilog::Custom(format!(
            "{declared}always @(posedge clock) begin\n   if (enable) begin\n{moved}      q <= {from};\n   end\nend\n"
        ))
    }
}

/// The chain of valid bits that accompanies a pipeline of as many register levels.
///
/// `reset` clears it on a rising edge whether or not `enable` is set.
#[derive(LogicBlock)]
pub(super) struct ValidChain {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub enable: Signal<In, Bit>,
    pub d: Signal<In, Bit>,
    pub q: Signal<Out, Bit>,
    _bits: u64,
    _levels: usize,
}

impl ValidChain {
    /// Of so many levels.
    pub(super) fn new(levels: usize) -> Self {
        assert!((2..=64).contains(&levels), "a chain of {levels} valid bits");
        Self {
            clock: Signal::default(),
            reset: Signal::default(),
            enable: Signal::default(),
            d: Signal::default(),
            q: Signal::default(),
            _bits: 0,
            _levels: levels,
        }
    }

    pub(super) fn levels(&self) -> usize {
        self._levels
    }
}

impl Logic for ValidChain {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            if self.reset.val() {
                self._bits = 0;
            } else if self.enable.val() {
                self._bits = (self._bits << 1) | u64::from(self.d.val());
            }
            self.q.next = (self._bits >> (self._levels - 1)) & 1 == 1;
        }
    }

    fn connect(&mut self) {
        self.q.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(format!(
            "reg [{top}:0] levels;\n\n\
             initial levels = {count}'d0;\n\n\
             always @(posedge clock) begin\n   \
                if (reset) levels <= {count}'d0;\n   \
                else if (enable) levels <= {{levels[{below}:0], d}};\n\
             end\n\n\
             always @(*) q = levels[{top}];\n",
            count = self._levels,
            top = self._levels - 1,
            below = self._levels - 2,
        ))
    }
}

/// One field of the table: `2^A` words of `D` bits with a registered, enabled read port.
///
/// Each field is a ROM of its own, which keeps every word short enough for fast simulation.
#[derive(LogicBlock)]
pub(super) struct Rom<const A: usize, const D: usize> {
    pub clock: Signal<In, Clock>,
    pub enable: Signal<In, Bit>,
    pub address: Signal<In, Bits<A>>,
    pub data: Signal<Out, Bits<D>>,
    _words: Box<[Bits<D>]>,
}

impl<const A: usize, const D: usize> Rom<A, D> {
    /// Panics unless there are `2^A` words of at most `D` bits.
    pub(super) fn new(field: &str, words: &[u64]) -> Self {
        assert_eq!(words.len(), 1 << A, "rows of the table field {field}");
        let fits = |word: &&u64| **word <= low_ones(D);
        if let Some(word) = words.iter().find(|word| !fits(word)) {
            panic!("the table field {field} holds {word}, which has more than {D} bits");
        }
        Self {
            clock: Signal::default(),
            enable: Signal::default(),
            address: Signal::default(),
            data: Signal::default(),
            _words: words.iter().map(|&word| word.into()).collect(),
        }
    }
}

impl<const A: usize, const D: usize> Logic for Rom<A, D> {
    fn update(&mut self) {
        if self.clock.pos_edge() && self.enable.val() {
            self.data.next = self._words[self.address.val().index()];
        }
    }

    fn connect(&mut self) {
        self.data.connect();
    }

    // A `case` synthesises several times faster than the `initial` lines of the library's ROM.
    fn hdl(&self) -> Verilog {
        let rows: String = (self._words.iter().enumerate())
            .map(|(row, word)| format!("      {A}'d{row}: data <= {D}'d{};\n", word.to_u64()))
            .collect();
        Verilog::Custom(format!(
            "always @(posedge clock) begin\n   \
                if (enable) case (address)\n{rows}   endcase\n\
             end\n"
        ))
    }
}
