//! The quadratic core, `y = x (1 - a u)` with `u = 1 - x`, and 0 where that is negative.

use super::multiplier::Multiplier;
use super::register::{Register, Rescale, Rom};
use rust_hdl::prelude::*;

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

super::core! {
    /// The core. The parameters are widths in bits, all of which follow from [`QuadraticWidths`]: of
    /// the address, the fields k and a, `in_cos`, x, the shifted u, v, the shortened x, p, p with its
    /// overflow bit, the last difference, and `out_spec`.
    struct Quadratic<N, KW, CA, C, X, SHIFTED, V, XB, P, PO, S, Y>, levels 8, ports N, C, Y;

    fn new(w: &QuadraticWidths, rom: QuadraticRom) {
        assert!(w.kmax >= 1, "kmax must be at least 1");
        assert!(rom.k.iter().all(|&k| k <= w.kmax as u64), "the table field k exceeds kmax");
        let difference = w.difference();
        let product = Rescale::new(w.ca + w.fv, w.fp);
        let correction = Rescale::through(w.xb + w.fp, w.ft, difference);
    }

    blocks {
        // The words of the table cross the chip, to the registers with a w; all else waits for them.
        x0: Register<X, X>;
        k0: Rom<N, KW> = Rom::new("k", rom.k);
        a0: Rom<N, CA> = Rom::new("a", rom.a);
        x1: Register<X, X>, of x0.q;
        xw: Register<X, X>, of x1.q;
        u1: Register<X, X>;
        uw: Register<X, X>, of u1.q;
        k1: Register<KW, KW>, of k0.data;
        kw: Register<KW, KW>, of k1.q;
        a1: Register<CA, CA>, of a0.data;
        aw: Register<CA, CA>, of a1.q;
        x2: Register<X, XB> = Register::new(Rescale::new(w.f, w.xb)), of xw.q;
        v2: Register<SHIFTED, V> = Register::new(Rescale::new(w.f, w.fv));
        a2: Register<CA, CA>, of aw.q;
        beyond2: Register<1, 1>;
        // The way from the shift to a DSP block is long.
        x3: Register<XB, XB>, of x2.q;
        v3: Register<V, V>, of v2.q;
        a3: Register<CA, CA>, of a2.q;
        beyond3: Register<1, 1>, of beyond2.q;
        x4: Register<XB, XB>, of x3.q;
        p4: Multiplier<CA, V, PO> = Multiplier::new(product);
        beyond4: Register<1, 1>, of beyond3.q;
        x5: Register<XB, S> = Register::new(Rescale::new(w.xb, difference)), of x4.q;
        t5: Multiplier<XB, P, S> = Multiplier::new(correction);
        zero5: Register<1, 1>;
        y6: Register<S, Y> = Register::new(Rescale::new(difference, w.g));
    }

    signals {
        shifted: Signal<Local, Bits<SHIFTED>>;
        cos_negative: Constant<Bits<C>> = Constant::new((1 << (w.f + 1)).into());
        cos_one: Constant<Bits<C>> = Constant::new((1 << w.f).into());
        x_one: Constant<Bits<X>> = Constant::new((1 << w.f).into());
        v_two: Constant<Bits<SHIFTED>> = Constant::new((1 << (w.f + 1)).into());
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

        // Stage 1: u = 1 - x.
        self.u1.d.next = self.x_one.val() - self.x0.q.val();

        // Stage 2: v = u 2^k; the result is 0 where v does not fit.
        self.shifted.next = bit_cast::<SHIFTED, X>(self.uw.q.val()) << self.kw.q.val();
        self.v2.d.next = self.shifted.val();
        self.beyond2.d.next = 0.into();
        if self.shifted.val() >= self.v_two.val() {
            self.beyond2.d.next = 1.into();
        }

        // Stage 4: p = a v.
        self.p4.left.next = self.a3.q.val();
        self.p4.right.next = self.v3.q.val();

        // Stage 5: t = x p; the result is 0 where p is 1 or more.
        self.t5.left.next = self.x4.q.val();
        self.t5.right.next = bit_cast::<P, PO>(self.p4.product.val());
        self.zero5.d.next = self.beyond4.q.val();
        if self.p4.product.val() >= self.p_one.val() {
            self.zero5.d.next = 1.into();
        }

        // Stage 6: y = x - t.
        self.y6.d.next = self.x5.q.val() - self.t5.product.val();
        if self.zero5.q.val().any() {
            self.y6.d.next = 0.into();
        }

        self.out_spec.next = self.y6.q.val();
    }
}
