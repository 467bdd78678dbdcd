//! The registered multiplier.

use super::register::Rescale;
use rust_hdl::prelude::*;

/// An unsigned multiplier followed by a register with a clock enable and without reset.
///
/// The register holds the product with the wanted number of fraction bits, modulo `2^P`.
#[derive(LogicBlock)]
pub(super) struct Multiplier<const L: usize, const R: usize, const P: usize> {
    pub clock: Signal<In, Clock>,
    pub enable: Signal<In, Bit>,
    pub left: Signal<In, Bits<L>>,
    pub right: Signal<In, Bits<R>>,
    pub product: Signal<Out, Bits<P>>,
    _rescale: Rescale,
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
        }
    }
}

impl<const L: usize, const R: usize, const P: usize> Logic for Multiplier<L, R, P> {
    fn update(&mut self) {
        if self.clock.pos_edge() && self.enable.val() {
            let product = self.left.val().to_u64() * self.right.val().to_u64();
            self.product.next = self._rescale.apply(product, P).into();
        }
    }

    fn connect(&mut self) {
        self.product.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(format!(
            "wire [{}:0] full = left * right;\n\n\
             always @(posedge clock) begin\n   if (enable) product <= {};\nend\n",
            L + R - 1,
            self._rescale.verilog("full", L + R, P)
        ))
    }
}
