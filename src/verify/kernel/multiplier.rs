//! The registered multiplier.

use super::register::{Rescale, low_ones};
use rust_hdl::prelude::*;

/// An unsigned multiplier followed by a register with a clock enable and without reset.
///
/// The register holds the product with the wanted number of fraction bits, modulo `2^P`. Where no DSP block takes the
/// right operand, it is a sum: of the products with its low bits and with the others. Each of these and the sum have a
/// register of their own, before the one that may be far from the blocks.
#[derive(LogicBlock)]
pub(super) struct Multiplier<const L: usize, const R: usize, const P: usize> {
    pub clock: Signal<In, Clock>,
    pub enable: Signal<In, Bit>,
    pub left: Signal<In, Bits<L>>,
    pub right: Signal<In, Bits<R>>,
    pub product: Signal<Out, Bits<P>>,
    _rescale: Rescale,
    /// Bits of the right operand that a DSP block takes, if these are not all.
    _low: Option<usize>,
    /// The products with the low bits and with the others, and their sum.
    _parts: [u64; 2],
    _sum: u64,
}

impl<const L: usize, const R: usize, const P: usize> Multiplier<L, R, P> {
    pub(super) fn new(rescale: Rescale) -> Self {
        assert!(L + R <= 64 && P <= 64, "a product of more than 64 bits");
        Self {
            clock: Signal::default(),
            enable: Signal::default(),
            left: Signal::default(),
            right: Signal::default(),
            product: Signal::default(),
            _rescale: rescale,
            _low: None,
            _parts: [0; 2],
            _sum: 0,
        }
    }

    /// It, built of DSP blocks that take so many bits of the right operand: two levels more, if these are not all.
    pub(super) fn of_blocks(self, bits: usize) -> Self {
        Self { _low: (bits < R).then_some(bits), ..self }
    }
}

impl<const L: usize, const R: usize, const P: usize> Logic for Multiplier<L, R, P> {
    fn update(&mut self) {
        if self.clock.pos_edge() && self.enable.val() {
            let (left, right) = (self.left.val().to_u64(), self.right.val().to_u64());
            let product = match self._low {
                None => left * right,
                Some(bits) => {
                    let ([low, high], sum) = (self._parts, self._sum);
                    self._parts = [left * (right & low_ones(bits)), left * (right >> bits)];
                    self._sum = low + (high << bits);
                    sum
                }
            };
            self.product.next = self._rescale.apply(product, P).into();
        }
    }

    fn connect(&mut self) {
        self.product.connect();
    }

    fn hdl(&self) -> Verilog {
        let (top, result) = (L + R - 1, self._rescale.verilog("full", L + R, P));
        Verilog::Custom(match self._low {
            None => format!(
                "wire [{top}:0] full = left * right;\n\n\
                 always @(posedge clock) begin\n   if (enable) product <= {result};\nend\n"
            ),
            Some(bits) => format!(
                "reg [{low_top}:0] low;\nreg [{high_top}:0] high;\nreg [{top}:0] full;\n\n\
                 always @(posedge clock) begin\n   if (enable) begin\n      \
                    low <= left * right[{below}:0];\n      \
                    high <= left * right[{last}:{bits}];\n      \
                    full <= {{{rest}'d0, low}} + {{high, {bits}'d0}};\n      \
                    product <= {result};\n   \
                 end\nend\n",
                low_top = L + bits - 1,
                high_top = L + R - bits - 1,
                rest = R - bits,
                below = bits - 1,
                last = R - 1,
            ),
        })
    }
}
