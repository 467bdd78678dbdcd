//! The cubic core, `y = x (1 - u (A - a u))` with `u = 1 - x`, and 0 beyond a threshold of u.

use super::Ports;
use super::multiplier::Multiplier;
use super::register::{Register, Rescale, Rom, ValidChain};
use rust_hdl::prelude::*;

/// Register levels, which is the latency in enabled clocks.
const LEVELS: usize = 9;

/// The widths of a cubic core, in bits. UQm.n is unsigned with m integer and n fraction bits.
///
/// Where a value passes to fewer fraction bits it is rounded down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CubicWidths {
    /// F: fraction bits of `in_cos`, which has `F + 2` bits, two's complement.
    pub f: usize,
    /// G: fraction bits of `out_spec`, which has `G + 1` bits, unsigned, range `[0, 1]`.
    pub g: usize,
    /// Bits of `in_n`; the table has `2^n` rows.
    pub n: usize,
    /// Bits of the table field k.
    pub kw: usize,
    /// FV: fraction bits of `v = u 2^k`, UQIV.FV.
    pub fv: usize,
    /// IV: integer bits of v; a larger value wraps.
    pub iv: usize,
    /// CL: fraction bits of the table field a.
    pub cl: usize,
    /// Bits of the table field a, at most CL: the missing upper ones are zero.
    pub wl: usize,
    /// CA: fraction bits of the table field A.
    pub ca: usize,
    /// Bits of the table field A.
    pub wa: usize,
    /// FR: fraction bits kept of `r = a v`.
    pub fr: usize,
    /// FQ: fraction bits kept of `q = A - r`.
    pub fq: usize,
    /// Bits of q, which wraps.
    pub wq: usize,
    /// FP: fraction bits kept of `p = v q`, UQ0.FP.
    pub fp: usize,
    /// XB: fraction bits of x in `x p` and in the last subtraction, UQ1.XB.
    pub xb: usize,
    /// FT: fraction bits kept of `x p`.
    pub ft: usize,
}

impl CubicWidths {
    /// Fraction bits of the subtraction `A - r`.
    pub(super) const fn inner(&self) -> usize {
        if self.ca > self.fr { self.ca } else { self.fr }
    }

    /// Bits of the subtraction `A - r`: with the integer bits of q, to which it wraps.
    pub(super) const fn inner_width(&self) -> usize {
        self.inner() + self.wq - self.fq
    }

    /// Bits of p before the integer bits are tested.
    pub(super) const fn p_width(&self) -> usize {
        self.fp + self.iv + self.wq - self.fq
    }

    /// Fraction bits of the last subtraction.
    pub(super) const fn difference(&self) -> usize {
        if self.xb > self.ft { self.xb } else { self.ft }
    }
}

/// The table of a cubic core, one slice of `2^n` words for each field.
#[derive(Clone, Copy, Debug)]
pub struct CubicRom<'a> {
    /// The left shift that brings u to v.
    pub k: &'a [u64],
    /// The coefficient of v, with CL fraction bits.
    pub a: &'a [u64],
    /// The constant term of q, A, with CA fraction bits.
    pub constant: &'a [u64],
    /// The threshold T, UQ1.F: the result is 0 where u exceeds it.
    pub threshold: &'a [u64],
}

/// The core. The parameters are widths in bits, all of which follow from [`CubicWidths`]: of the
/// address, the fields k, a and A, `in_cos`, x, the shifted u, v, the difference A - r, q, the
/// shortened x, p, p with its integer bits, the last difference, and `out_spec`.
#[derive(LogicBlock)]
pub(super) struct Cubic<
    const N: usize,
    const KW: usize,
    const WL: usize,
    const WA: usize,
    const C: usize,
    const X: usize,
    const SHIFTED: usize,
    const V: usize,
    const SQ: usize,
    const WQ: usize,
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
    a0: Rom<N, WL>,
    c0: Rom<N, WA>,
    t0: Rom<N, X>,
    x1: Register<X, X>,
    xw: Register<X, X>,
    u1: Register<X, X>,
    uw: Register<X, X>,
    k1: Register<KW, KW>,
    kw: Register<KW, KW>,
    a1: Register<WL, WL>,
    aw: Register<WL, WL>,
    c1: Register<WA, WA>,
    cw: Register<WA, WA>,
    t1: Register<X, X>,
    tw: Register<X, X>,
    x2: Register<X, XB>,
    v2: Register<SHIFTED, V>,
    a2: Register<WL, WL>,
    c2: Register<WA, SQ>,
    cut2: Register<1, 1>,
    x3: Register<XB, XB>,
    v3: Register<V, V>,
    r3: Multiplier<WL, V, SQ>,
    c3: Register<SQ, SQ>,
    cut3: Register<1, 1>,
    x4: Register<XB, XB>,
    v4: Register<V, V>,
    q4: Register<SQ, WQ>,
    cut4: Register<1, 1>,
    x5: Register<XB, XB>,
    p5: Multiplier<V, WQ, PO>,
    cut5: Register<1, 1>,
    x6: Register<XB, S>,
    t6: Multiplier<XB, P, S>,
    zero6: Register<1, 1>,
    y7: Register<S, Y>,

    shifted: Signal<Local, Bits<SHIFTED>>,

    cos_negative: Constant<Bits<C>>,
    cos_one: Constant<Bits<C>>,
    x_one: Constant<Bits<X>>,
    p_one: Constant<Bits<PO>>,
}

impl<
    const N: usize,
    const KW: usize,
    const WL: usize,
    const WA: usize,
    const C: usize,
    const X: usize,
    const SHIFTED: usize,
    const V: usize,
    const SQ: usize,
    const WQ: usize,
    const XB: usize,
    const P: usize,
    const PO: usize,
    const S: usize,
    const Y: usize,
> Cubic<N, KW, WL, WA, C, X, SHIFTED, V, SQ, WQ, XB, P, PO, S, Y>
{
    /// Panics if the table does not have the shape `w` asks for.
    pub(super) fn new(w: &CubicWidths, rom: CubicRom) -> Self {
        let inner = w.inner();
        let difference = w.difference();
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
            c0: Rom::new("A", rom.constant),
            t0: Rom::new("T", rom.threshold),
            x1: Register::default(),
            xw: Register::default(),
            u1: Register::default(),
            uw: Register::default(),
            k1: Register::default(),
            kw: Register::default(),
            a1: Register::default(),
            aw: Register::default(),
            c1: Register::default(),
            cw: Register::default(),
            t1: Register::default(),
            tw: Register::default(),
            x2: Register::new(Rescale::new(w.f, w.xb)),
            v2: Register::new(Rescale::new(w.f, w.fv)),
            a2: Register::default(),
            c2: Register::new(Rescale::new(w.ca, inner)),
            cut2: Register::default(),
            x3: Register::default(),
            v3: Register::default(),
            r3: Multiplier::new(Rescale::through(w.cl + w.fv, w.fr, inner)),
            c3: Register::default(),
            cut3: Register::default(),
            x4: Register::default(),
            v4: Register::default(),
            q4: Register::new(Rescale::new(inner, w.fq)),
            cut4: Register::default(),
            x5: Register::default(),
            p5: Multiplier::new(Rescale::new(w.fv + w.fq, w.fp)),
            cut5: Register::default(),
            x6: Register::new(Rescale::new(w.xb, difference)),
            t6: Multiplier::new(Rescale::through(w.xb + w.fp, w.ft, difference)),
            zero6: Register::default(),
            y7: Register::new(Rescale::new(difference, w.g)),
            shifted: Signal::default(),
            cos_negative: Constant::new((1 << (w.f + 1)).into()),
            cos_one: Constant::new((1 << w.f).into()),
            x_one: Constant::new((1 << w.f).into()),
            p_one: Constant::new((1 << w.fp).into()),
        };
        core.connect_all();
        core
    }
}

impl<
    const N: usize,
    const KW: usize,
    const WL: usize,
    const WA: usize,
    const C: usize,
    const X: usize,
    const SHIFTED: usize,
    const V: usize,
    const SQ: usize,
    const WQ: usize,
    const XB: usize,
    const P: usize,
    const PO: usize,
    const S: usize,
    const Y: usize,
> Logic for Cubic<N, KW, WL, WA, C, X, SHIFTED, V, SQ, WQ, XB, P, PO, S, Y>
{
    #[hdl_gen]
    fn update(&mut self) {
        clock!(self, clock, valid, x0, k0, a0, c0, t0, x1, u1, k1, a1, c1, t1);
        clock!(self, clock, xw, uw, kw, aw, cw, tw);
        clock!(self, clock, x2, v2, a2, c2, cut2, x3, v3, r3, c3, cut3, x4, v4);
        clock!(self, clock, q4, cut4, x5, p5, cut5, x6, t6, zero6, y7);
        self.valid.enable.next = self.ce.val();
        self.x0.enable.next = self.ce.val();
        self.k0.enable.next = self.ce.val();
        self.a0.enable.next = self.ce.val();
        self.c0.enable.next = self.ce.val();
        self.t0.enable.next = self.ce.val();
        self.x1.enable.next = self.ce.val();
        self.xw.enable.next = self.ce.val();
        self.u1.enable.next = self.ce.val();
        self.uw.enable.next = self.ce.val();
        self.k1.enable.next = self.ce.val();
        self.kw.enable.next = self.ce.val();
        self.a1.enable.next = self.ce.val();
        self.aw.enable.next = self.ce.val();
        self.c1.enable.next = self.ce.val();
        self.cw.enable.next = self.ce.val();
        self.t1.enable.next = self.ce.val();
        self.tw.enable.next = self.ce.val();
        self.x2.enable.next = self.ce.val();
        self.v2.enable.next = self.ce.val();
        self.a2.enable.next = self.ce.val();
        self.c2.enable.next = self.ce.val();
        self.cut2.enable.next = self.ce.val();
        self.x3.enable.next = self.ce.val();
        self.v3.enable.next = self.ce.val();
        self.r3.enable.next = self.ce.val();
        self.c3.enable.next = self.ce.val();
        self.cut3.enable.next = self.ce.val();
        self.x4.enable.next = self.ce.val();
        self.v4.enable.next = self.ce.val();
        self.q4.enable.next = self.ce.val();
        self.cut4.enable.next = self.ce.val();
        self.x5.enable.next = self.ce.val();
        self.p5.enable.next = self.ce.val();
        self.cut5.enable.next = self.ce.val();
        self.x6.enable.next = self.ce.val();
        self.t6.enable.next = self.ce.val();
        self.zero6.enable.next = self.ce.val();
        self.y7.enable.next = self.ce.val();

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
        self.c0.address.next = self.in_n.val();
        self.t0.address.next = self.in_n.val();

        // Stage 1: u = 1 - x.
        self.u1.d.next = self.x_one.val() - self.x0.q.val();
        self.x1.d.next = self.x0.q.val();
        self.k1.d.next = self.k0.data.val();
        self.a1.d.next = self.a0.data.val();
        self.c1.d.next = self.c0.data.val();
        self.t1.d.next = self.t0.data.val();

        // The words of the table cross the chip; all else waits for them.
        self.xw.d.next = self.x1.q.val();
        self.uw.d.next = self.u1.q.val();
        self.kw.d.next = self.k1.q.val();
        self.aw.d.next = self.a1.q.val();
        self.cw.d.next = self.c1.q.val();
        self.tw.d.next = self.t1.q.val();

        // Stage 2: v = u 2^k; the result is 0 where u exceeds the threshold.
        self.shifted.next = bit_cast::<SHIFTED, X>(self.uw.q.val()) << self.kw.q.val();
        self.v2.d.next = self.shifted.val();
        self.cut2.d.next = 0.into();
        if self.uw.q.val() > self.tw.q.val() {
            self.cut2.d.next = 1.into();
        }
        self.x2.d.next = self.xw.q.val();
        self.a2.d.next = self.aw.q.val();
        self.c2.d.next = self.cw.q.val();

        // Stage 3: r = a v.
        self.r3.left.next = self.a2.q.val();
        self.r3.right.next = self.v2.q.val();
        self.x3.d.next = self.x2.q.val();
        self.v3.d.next = self.v2.q.val();
        self.c3.d.next = self.c2.q.val();
        self.cut3.d.next = self.cut2.q.val();

        // Stage 4: q = A - r.
        self.q4.d.next = self.c3.q.val() - self.r3.product.val();
        self.x4.d.next = self.x3.q.val();
        self.v4.d.next = self.v3.q.val();
        self.cut4.d.next = self.cut3.q.val();

        // Stage 5: p = v q.
        self.p5.left.next = self.v4.q.val();
        self.p5.right.next = self.q4.q.val();
        self.x5.d.next = self.x4.q.val();
        self.cut5.d.next = self.cut4.q.val();

        // Stage 6: t = x p; the result is 0 where p is 1 or more.
        self.t6.left.next = self.x5.q.val();
        self.t6.right.next = bit_cast::<P, PO>(self.p5.product.val());
        self.zero6.d.next = self.cut5.q.val();
        if self.p5.product.val() >= self.p_one.val() {
            self.zero6.d.next = 1.into();
        }
        self.x6.d.next = self.x5.q.val();

        // Stage 7: y = x - t.
        self.y7.d.next = self.x6.q.val() - self.t6.product.val();
        if self.zero6.q.val().any() {
            self.y7.d.next = 0.into();
        }

        self.out_valid.next = self.valid.q.val();
        self.out_spec.next = self.y7.q.val();
    }
}

impl<
    const N: usize,
    const KW: usize,
    const WL: usize,
    const WA: usize,
    const C: usize,
    const X: usize,
    const SHIFTED: usize,
    const V: usize,
    const SQ: usize,
    const WQ: usize,
    const XB: usize,
    const P: usize,
    const PO: usize,
    const S: usize,
    const Y: usize,
> Ports for Cubic<N, KW, WL, WA, C, X, SHIFTED, V, SQ, WQ, XB, P, PO, S, Y>
{
    const LEVELS: usize = LEVELS;

    super::ports!(N, C);
}
