//! The quadratic core, `y = x (1 - a u)` with `u = 1 - x`, and 0 where that is negative.

use super::Ports;
use super::multiplier::Multiplier;
use super::register::{Register, Rescale, Rom, ValidChain};
use rust_hdl::prelude::*;

/// Register levels, which is the latency in enabled clocks.
const LEVELS: usize = 7;

/// The widths of a quadratic core, in bits. UQm.n is unsigned with m integer and n fraction bits.
///
/// Where a value passes to fewer fraction bits it is rounded down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuadraticWidths {
    /// F: fraction bits of `in_cos`, which has `F + 2` bits, two's complement.
    pub f: usize,
    /// G: fraction bits of `out_spec`, which has `G + 1` bits, unsigned, range `[0, 1]`.
    pub g: usize,
    /// Bits of `in_n`; the table has `2^n` rows.
    pub n: usize,
    /// Bits of the table field k.
    pub kw: usize,
    /// The largest k in the table, at least 1.
    pub kmax: usize,
    /// CA: bits of the table field a, all of them fraction: UQ0.CA.
    pub ca: usize,
    /// FV: fraction bits of `v = u 2^k`, UQ1.FV.
    pub fv: usize,
    /// FP: fraction bits kept of `p = a v`, UQ0.FP.
    pub fp: usize,
    /// XB: fraction bits of x in `x p` and in the last subtraction, UQ1.XB.
    pub xb: usize,
    /// FT: fraction bits kept of `x p`.
    pub ft: usize,
}

impl QuadraticWidths {
    /// Bits of `u 2^k`, which holds every product without wrapping.
    pub(super) const fn shifted(&self) -> usize {
        self.f + 1 + self.kmax
    }

    /// Fraction bits of the last subtraction.
    pub(super) const fn difference(&self) -> usize {
        if self.xb > self.ft { self.xb } else { self.ft }
    }
}

/// The table of a quadratic core, one slice of `2^n` words for each field.
#[derive(Clone, Copy, Debug)]
pub struct QuadraticRom<'a> {
    /// The left shift that brings u to v, at most `kmax`.
    pub k: &'a [u64],
    /// The coefficient of v, UQ0.CA.
    pub a: &'a [u64],
}

/// The core. The parameters are widths in bits, all of which follow from [`QuadraticWidths`]: of
/// the address, the fields k and a, `in_cos`, x, the shifted u, v, the shortened x, p, p with its
/// overflow bit, the last difference, and `out_spec`.
#[derive(LogicBlock)]
pub(super) struct Quadratic<
    const N: usize,
    const KW: usize,
    const CA: usize,
    const C: usize,
    const X: usize,
    const SHIFTED: usize,
    const V: usize,
    const XB: usize,
    const P: usize,
    const PO: usize,
    const S: usize,
    const Y: usize,
> {
    pub clock: Signal<In, Clock>,
    pub rst: Signal<In, Bit>,
    pub ce: Signal<In, Bit>,
    pub in_valid: Signal<In, Bit>,
    pub in_n: Signal<In, Bits<N>>,
    pub in_cos: Signal<In, Bits<C>>,
    pub out_valid: Signal<Out, Bit>,
    pub out_spec: Signal<Out, Bits<Y>>,

    valid: ValidChain<LEVELS>,
    x0: Register<X, X>,
    k0: Rom<N, KW>,
    a0: Rom<N, CA>,
    x1: Register<X, X>,
    xw: Register<X, X>,
    u1: Register<X, X>,
    uw: Register<X, X>,
    k1: Register<KW, KW>,
    kw: Register<KW, KW>,
    a1: Register<CA, CA>,
    aw: Register<CA, CA>,
    x2: Register<X, XB>,
    v2: Register<SHIFTED, V>,
    a2: Register<CA, CA>,
    beyond2: Register<1, 1>,
    x3: Register<XB, XB>,
    p3: Multiplier<CA, V, PO>,
    beyond3: Register<1, 1>,
    x4: Register<XB, S>,
    t4: Multiplier<XB, P, S>,
    zero4: Register<1, 1>,
    y5: Register<S, Y>,

    shifted: Signal<Local, Bits<SHIFTED>>,

    cos_negative: Constant<Bits<C>>,
    cos_one: Constant<Bits<C>>,
    x_one: Constant<Bits<X>>,
    v_two: Constant<Bits<SHIFTED>>,
    p_one: Constant<Bits<PO>>,
}

impl<
    const N: usize,
    const KW: usize,
    const CA: usize,
    const C: usize,
    const X: usize,
    const SHIFTED: usize,
    const V: usize,
    const XB: usize,
    const P: usize,
    const PO: usize,
    const S: usize,
    const Y: usize,
> Quadratic<N, KW, CA, C, X, SHIFTED, V, XB, P, PO, S, Y>
{
    /// Panics if the table does not have the shape `w` asks for.
    pub(super) fn new(w: &QuadraticWidths, rom: QuadraticRom) -> Self {
        assert!(w.kmax >= 1, "kmax must be at least 1");
        assert!(rom.k.iter().all(|&k| k <= w.kmax as u64), "the table field k exceeds kmax");
        let difference = w.difference();
        let product = Rescale::new(w.ca + w.fv, w.fp);
        let correction = Rescale::through(w.xb + w.fp, w.ft, difference);
        let mut core = Self {
            clock: Signal::default(),
            rst: Signal::default(),
            ce: Signal::default(),
            in_valid: Signal::default(),
            in_n: Signal::default(),
            in_cos: Signal::default(),
            out_valid: Signal::default(),
            out_spec: Signal::default(),
            valid: ValidChain::default(),
            x0: Register::default(),
            k0: Rom::new("k", rom.k),
            a0: Rom::new("a", rom.a),
            x1: Register::default(),
            xw: Register::default(),
            u1: Register::default(),
            uw: Register::default(),
            k1: Register::default(),
            kw: Register::default(),
            a1: Register::default(),
            aw: Register::default(),
            x2: Register::new(Rescale::new(w.f, w.xb)),
            v2: Register::new(Rescale::new(w.f, w.fv)),
            a2: Register::default(),
            beyond2: Register::default(),
            x3: Register::default(),
            p3: Multiplier::new(product),
            beyond3: Register::default(),
            x4: Register::new(Rescale::new(w.xb, difference)),
            t4: Multiplier::new(correction),
            zero4: Register::default(),
            y5: Register::new(Rescale::new(difference, w.g)),
            shifted: Signal::default(),
            cos_negative: Constant::new((1 << (w.f + 1)).into()),
            cos_one: Constant::new((1 << w.f).into()),
            x_one: Constant::new((1 << w.f).into()),
            v_two: Constant::new((1 << (w.f + 1)).into()),
            p_one: Constant::new((1 << w.fp).into()),
        };
        core.connect_all();
        core
    }
}

impl<
    const N: usize,
    const KW: usize,
    const CA: usize,
    const C: usize,
    const X: usize,
    const SHIFTED: usize,
    const V: usize,
    const XB: usize,
    const P: usize,
    const PO: usize,
    const S: usize,
    const Y: usize,
> Logic for Quadratic<N, KW, CA, C, X, SHIFTED, V, XB, P, PO, S, Y>
{
    #[hdl_gen]
    fn update(&mut self) {
        clock!(self, clock, valid, x0, k0, a0, x1, u1, k1, a1, x2, v2, a2, beyond2);
        clock!(self, clock, xw, uw, kw, aw);
        clock!(self, clock, x3, p3, beyond3, x4, t4, zero4, y5);
        self.valid.enable.next = self.ce.val();
        self.x0.enable.next = self.ce.val();
        self.k0.enable.next = self.ce.val();
        self.a0.enable.next = self.ce.val();
        self.x1.enable.next = self.ce.val();
        self.xw.enable.next = self.ce.val();
        self.u1.enable.next = self.ce.val();
        self.uw.enable.next = self.ce.val();
        self.k1.enable.next = self.ce.val();
        self.kw.enable.next = self.ce.val();
        self.a1.enable.next = self.ce.val();
        self.aw.enable.next = self.ce.val();
        self.x2.enable.next = self.ce.val();
        self.v2.enable.next = self.ce.val();
        self.a2.enable.next = self.ce.val();
        self.beyond2.enable.next = self.ce.val();
        self.x3.enable.next = self.ce.val();
        self.p3.enable.next = self.ce.val();
        self.beyond3.enable.next = self.ce.val();
        self.x4.enable.next = self.ce.val();
        self.t4.enable.next = self.ce.val();
        self.zero4.enable.next = self.ce.val();
        self.y5.enable.next = self.ce.val();

        self.valid.reset.next = self.rst.val();
        self.valid.d.next = self.in_valid.val();

        // Stage 0: x is in_cos limited to 0..1; the table is read.
        // As an unsigned word, a negative in_cos is at least 2^(F+1).
        self.x0.d.next = bit_cast::<X, C>(self.in_cos.val());
        if self.in_cos.val() > self.cos_one.val() {
            self.x0.d.next = self.x_one.val();
        }
        if self.in_cos.val() >= self.cos_negative.val() {
            self.x0.d.next = 0.into();
        }
        self.k0.address.next = self.in_n.val();
        self.a0.address.next = self.in_n.val();

        // Stage 1: u = 1 - x.
        self.u1.d.next = self.x_one.val() - self.x0.q.val();
        self.x1.d.next = self.x0.q.val();
        self.k1.d.next = self.k0.data.val();
        self.a1.d.next = self.a0.data.val();

        // The words of the table cross the chip; all else waits for them.
        self.xw.d.next = self.x1.q.val();
        self.uw.d.next = self.u1.q.val();
        self.kw.d.next = self.k1.q.val();
        self.aw.d.next = self.a1.q.val();

        // Stage 2: v = u 2^k; the result is 0 where v does not fit.
        self.shifted.next = bit_cast::<SHIFTED, X>(self.uw.q.val()) << self.kw.q.val();
        self.v2.d.next = self.shifted.val();
        self.beyond2.d.next = 0.into();
        if self.shifted.val() >= self.v_two.val() {
            self.beyond2.d.next = 1.into();
        }
        self.x2.d.next = self.xw.q.val();
        self.a2.d.next = self.aw.q.val();

        // Stage 3: p = a v.
        self.p3.left.next = self.a2.q.val();
        self.p3.right.next = self.v2.q.val();
        self.x3.d.next = self.x2.q.val();
        self.beyond3.d.next = self.beyond2.q.val();

        // Stage 4: t = x p; the result is 0 where p is 1 or more.
        self.t4.left.next = self.x3.q.val();
        self.t4.right.next = bit_cast::<P, PO>(self.p3.product.val());
        self.zero4.d.next = self.beyond3.q.val();
        if self.p3.product.val() >= self.p_one.val() {
            self.zero4.d.next = 1.into();
        }
        self.x4.d.next = self.x3.q.val();

        // Stage 5: y = x - t.
        self.y5.d.next = self.x4.q.val() - self.t4.product.val();
        if self.zero4.q.val().any() {
            self.y5.d.next = 0.into();
        }

        self.out_valid.next = self.valid.q.val();
        self.out_spec.next = self.y5.q.val();
    }
}

impl<
    const N: usize,
    const KW: usize,
    const CA: usize,
    const C: usize,
    const X: usize,
    const SHIFTED: usize,
    const V: usize,
    const XB: usize,
    const P: usize,
    const PO: usize,
    const S: usize,
    const Y: usize,
> Ports for Quadratic<N, KW, CA, C, X, SHIFTED, V, XB, P, PO, S, Y>
{
    const LEVELS: usize = LEVELS;

    super::ports!(N, C);
}
