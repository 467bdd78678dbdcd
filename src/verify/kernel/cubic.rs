//! The cubic core, `y = x (1 - u (A - a u))` with `u = 1 - x`, and 0 beyond a threshold of u.

use super::multiplier::Multiplier;
use super::register::{Register, Rescale, Rom};
use rust_hdl::prelude::*;

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
    /// The low bits of q that a DSP block takes, if it does not take all.
    pub lq: Option<usize>,
    /// FP: fraction bits kept of `p = v q`, UQ0.FP.
    pub fp: usize,
    /// XB: fraction bits of x in `x p` and in the last subtraction, UQ1.XB.
    pub xb: usize,
    /// FT: fraction bits kept of `x p`.
    pub ft: usize,
}

impl CubicWidths {
    /// Register levels.
    pub(super) const fn levels(&self) -> usize {
        9 + self.product_levels()
    }

    /// Register levels of `v q`, of which a product that is built of blocks takes more.
    pub(super) const fn product_levels(&self) -> usize {
        if self.lq.is_some() { 3 } else { 1 }
    }

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

super::core! {
    /// The core. The parameters are widths in bits, all of which follow from [`CubicWidths`]: of the
    /// address, the fields k, a and A, `in_cos`, x, the shifted u, v, the difference A - r, q, the
    /// shortened x, p, p with its integer bits, the last difference, and `out_spec`.
    struct Cubic<N, KW, WL, WA, C, X, SHIFTED, V, SQ, WQ, XB, P, PO, S, Y>, levels w.levels(), ports N, C, Y;

    fn new(w: &CubicWidths, rom: CubicRom) {
        let inner = w.inner();
        let difference = w.difference();
    }

    blocks {
        // The words of the table cross the chip, to the registers with a w; all else waits for them.
        x0: Register<X, X>;
        k0: Rom<N, KW> = Rom::new("k", rom.k);
        a0: Rom<N, WL> = Rom::new("a", rom.a);
        c0: Rom<N, WA> = Rom::new("A", rom.constant);
        t0: Rom<N, X> = Rom::new("T", rom.threshold);
        x1: Register<X, X>, of x0.q;
        xw: Register<X, X>, of x1.q;
        u1: Register<X, X>;
        uw: Register<X, X>, of u1.q;
        k1: Register<KW, KW>, of k0.data;
        kw: Register<KW, KW>, of k1.q;
        a1: Register<WL, WL>, of a0.data;
        aw: Register<WL, WL>, of a1.q;
        c1: Register<WA, WA>, of c0.data;
        cw: Register<WA, WA>, of c1.q;
        t1: Register<X, X>, of t0.data;
        tw: Register<X, X>, of t1.q;
        x2: Register<X, XB> = Register::new(Rescale::new(w.f, w.xb)), of xw.q;
        v2: Register<SHIFTED, V> = Register::new(Rescale::new(w.f, w.fv));
        a2: Register<WL, WL>, of aw.q;
        c2: Register<WA, SQ> = Register::new(Rescale::new(w.ca, inner)), of cw.q;
        cut2: Register<1, 1>;
        // The way from the shift to a DSP block is long.
        x3: Register<XB, XB>, of x2.q;
        v3: Register<V, V>, of v2.q;
        a3: Register<WL, WL>, of a2.q;
        c3: Register<SQ, SQ>, of c2.q;
        cut3: Register<1, 1>, of cut2.q;
        x4: Register<XB, XB>, of x3.q;
        v4: Register<V, V>, of v3.q;
        r4: Multiplier<WL, V, SQ> = Multiplier::new(Rescale::through(w.cl + w.fv, w.fr, inner));
        c4: Register<SQ, SQ>, of c3.q;
        cut4: Register<1, 1>, of cut3.q;
        x5: Register<XB, XB>, of x4.q;
        v5: Register<V, V>, of v4.q;
        q5: Register<SQ, WQ> = Register::new(Rescale::new(inner, w.fq));
        cut5: Register<1, 1>, of cut4.q;
        x6: Register<XB, XB> = Register::default().levels(w.product_levels()), of x5.q;
        p6: Multiplier<V, WQ, PO> = Multiplier::new(Rescale::new(w.fv + w.fq, w.fp)).of_blocks(w.lq.unwrap_or(w.wq));
        cut6: Register<1, 1> = Register::default().levels(w.product_levels()), of cut5.q;
        x7: Register<XB, S> = Register::new(Rescale::new(w.xb, difference)), of x6.q;
        t7: Multiplier<XB, P, S> = Multiplier::new(Rescale::through(w.xb + w.fp, w.ft, difference));
        zero7: Register<1, 1>;
        y8: Register<S, Y> = Register::new(Rescale::new(difference, w.g));
    }

    signals {
        shifted: Signal<Local, Bits<SHIFTED>>;
        cos_negative: Constant<Bits<C>> = Constant::new((1 << (w.f + 1)).into());
        cos_one: Constant<Bits<C>> = Constant::new((1 << w.f).into());
        x_one: Constant<Bits<X>> = Constant::new((1 << w.f).into());
        p_one: Constant<Bits<PO>> = Constant::new((1 << w.fp).into());
    }

    #[hdl_gen]
    fn update(&mut self) {
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

        // Stage 2: v = u 2^k; the result is 0 where u exceeds the threshold.
        self.shifted.next = bit_cast::<SHIFTED, X>(self.uw.q.val()) << self.kw.q.val();
        self.v2.d.next = self.shifted.val();
        self.cut2.d.next = 0.into();
        if self.uw.q.val() > self.tw.q.val() {
            self.cut2.d.next = 1.into();
        }

        // Stage 4: r = a v.
        self.r4.left.next = self.a3.q.val();
        self.r4.right.next = self.v3.q.val();

        // Stage 5: q = A - r.
        self.q5.d.next = self.c4.q.val() - self.r4.product.val();

        // Stage 6: p = v q.
        self.p6.left.next = self.v5.q.val();
        self.p6.right.next = self.q5.q.val();

        // Stage 7: t = x p; the result is 0 where p is 1 or more.
        self.t7.left.next = self.x6.q.val();
        self.t7.right.next = bit_cast::<P, PO>(self.p6.product.val());
        self.zero7.d.next = self.cut6.q.val();
        if self.p6.product.val() >= self.p_one.val() {
            self.zero7.d.next = 1.into();
        }

        // Stage 8: y = x - t.
        self.y8.d.next = self.x7.q.val() - self.t7.product.val();
        if self.zero7.q.val().any() {
            self.y8.d.next = 0.into();
        }

        self.out_spec.next = self.y8.q.val();
    }
}
