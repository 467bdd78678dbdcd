//! The two cores described in Rust and built with rust-hdl: stepped in process, or emitted as Verilog.
//!
//! This is a second description of the same arithmetic. Hardware needs its widths when it is compiled, so there is one
//! instance for each entry in the lists below, and [`quadratic()`] and [`cubic()`] look an instance up by its widths.
//!
//! Both cores have the ports `clock`, `rst`, `ce`, `in_valid`, `in_n`, `in_cos`, `out_valid` and
//! `out_spec`. The cosine is limited to `[0, 1]`, so negative ones give 0. `ce = 0` freezes the
//! whole pipeline; `rst` is synchronous, acts also while `ce = 0`, and clears the valid bits only.

mod cubic;
mod multiplier;
mod quadratic;
mod register;
mod select;

pub use cubic::{CubicRom, CubicWidths};
pub use quadratic::{QuadraticRom, QuadraticWidths};
pub use select::of_design;

use rust_hdl::prelude::{Block, generate_verilog};

/// A pipelined core that is stepped one clock at a time.
pub trait Kernel {
    /// One rising edge of the clock with these inputs; returns `out_valid` and `out_spec` after it.
    ///
    /// `in_n` is the row of the table. `in_cos` holds the two's complement word of `F + 2` bits;
    /// bits of both above their port's width are ignored. `out_spec` has `G` fraction bits, range
    /// `[0, 1]`, and means something only while `out_valid` is set.
    fn clock(&mut self, rst: bool, ce: bool, in_valid: bool, in_n: u64, in_cos: u64) -> (bool, u64);

    /// The core in Verilog, with the contents of its table; the top module is called `top`.
    fn verilog(&self) -> String;

    /// Register levels between input and output: an input taken at one enabled edge is at the
    /// output after this many enabled edges, that one included.
    fn latency(&self) -> u32;
}

/// The ports common to the cores, for [`Pipeline`].
trait Ports: Block {
    /// Register levels, which is the latency in enabled clocks.
    fn levels(&self) -> usize;
    fn set_clock(&mut self, level: bool);
    fn set_inputs(&mut self, rst: bool, ce: bool, in_valid: bool, in_n: u64, in_cos: u64);
    fn outputs(&self) -> (bool, u64);
}

/// A core: its ports and its blocks, how they are made, and what all cores connect alike. The blocks are registers,
/// multipliers and ROMs, each with a clock and an enable; what has no value here is made by default, and a register
/// `of` a value takes just that. `ports` are the widths of `in_n`, `in_cos` and `out_spec`.
macro_rules! core {
    (
        $(#[$about:meta])*
        struct $core:ident<$($width:ident),+>, levels $levels:expr, ports $n:ident, $cos:ident, $spec:ident;

        fn new($widths:ident: $of_core:ty, $rom:ident: $table:ty) { $($before:tt)* }

        blocks { $($block:ident: $kind:ty $(= $made:expr)? $(, of $source:ident.$out:ident)?;)+ }

        signals { $($signal:ident: $type:ty $(= $value:expr)?;)+ }

        // Taken as tokens, as `self` is to be the one that the logic says.
        $hash:tt $attribute:tt
        fn update(&mut $this:ident) { $($logic:tt)* }
    ) => {
        $(#[$about])*
        #[derive(LogicBlock)]
        pub(super) struct $core<$(const $width: usize),+> {
            pub clock: Signal<In, Clock>,
            pub rst: Signal<In, Bit>,
            pub ce: Signal<In, Bit>,
            pub in_valid: Signal<In, Bit>,
            pub in_n: Signal<In, Bits<$n>>,
            pub in_cos: Signal<In, Bits<$cos>>,
            pub out_valid: Signal<Out, Bit>,
            pub out_spec: Signal<Out, Bits<$spec>>,
            valid: super::register::ValidChain,
            $($block: $kind,)+
            $($signal: $type,)+
        }

        impl<$(const $width: usize),+> $core<$($width),+> {
            /// Panics if the table does not have the shape that the widths ask for.
            pub(super) fn new($widths: $of_core, $rom: $table) -> Self {
                $($before)*
                let mut core = Self {
                    clock: Signal::default(),
                    rst: Signal::default(),
                    ce: Signal::default(),
                    in_valid: Signal::default(),
                    in_n: Signal::default(),
                    in_cos: Signal::default(),
                    out_valid: Signal::default(),
                    out_spec: Signal::default(),
                    valid: super::register::ValidChain::new($levels),
                    $($block: super::made!($($made)?),)+
                    $($signal: super::made!($($value)?),)+
                };
                core.connect_all();
                core
            }
        }

        impl<$(const $width: usize),+> Logic for $core<$($width),+> {
            $hash $attribute
            fn update(&mut $this) {
                clock!($this, clock, valid $(, $block)+);
                $this.valid.enable.next = $this.ce.val();
                $(
                    $this.$block.enable.next = $this.ce.val();
                    $($this.$block.d.next = $this.$source.$out.val();)?
                )+
                $this.valid.reset.next = $this.rst.val();
                $this.valid.d.next = $this.in_valid.val();
                $this.out_valid.next = $this.valid.q.val();
                $($logic)*
            }
        }

        impl<$(const $width: usize),+> super::Ports for $core<$($width),+> {
            fn levels(&self) -> usize {
                self.valid.levels()
            }

            fn set_clock(&mut self, level: bool) {
                self.clock.next = level.into();
            }

            fn set_inputs(&mut self, rst: bool, ce: bool, in_valid: bool, in_n: u64, in_cos: u64) {
                use super::register::low_ones;
                self.rst.next = rst;
                self.ce.next = ce;
                self.in_valid.next = in_valid;
                self.in_n.next = (in_n & low_ones($n)).into();
                self.in_cos.next = (in_cos & low_ones($cos)).into();
            }

            fn outputs(&self) -> (bool, u64) {
                (self.out_valid.val(), self.out_spec.val().to_u64())
            }
        }
    };
}
use core;

/// The value that is given, or the default.
macro_rules! made {
    () => {
        Default::default()
    };
    ($value:expr) => {
        $value
    };
}
use made;

/// A core under direct stepping.
struct Pipeline<C>(C);

impl<C: Ports> Kernel for Pipeline<C> {
    fn clock(&mut self, rst: bool, ce: bool, in_valid: bool, in_n: u64, in_cos: u64) -> (bool, u64) {
        // A fixed number of passes instead of a search for the settled state, which takes about twice as many. It
        // suffices because every block lies directly below the core and all logic between them is in the core's own
        // update. In these passes (1) the inputs and the rising clock reach the core, and the falling one of the
        // previous call the blocks; (2) both reach the blocks; (3) the registers change; (4) the outputs follow.
        let core = &mut self.0;
        core.set_inputs(rst, ce, in_valid, in_n, in_cos);
        core.set_clock(true);
        core.update_all();
        core.update_all();
        core.update_all();
        core.set_clock(false);
        core.update_all();
        core.outputs()
    }

    fn verilog(&self) -> String {
        generate_verilog(&self.0)
    }

    fn latency(&self) -> u32 {
        self.0.levels() as u32
    }
}

/// Makes the list of quadratic width sets and the look-up in it.
macro_rules! quadratic_sets {
    ($({ $($field:ident: $bits:expr),+ })+) => {
        /// The widths for which [`quadratic()`] has an instance.
        pub const QUADRATIC_SETS: &[QuadraticWidths] = &[$(QuadraticWidths { $($field: $bits),+ }),+];

        /// The quadratic core with exactly these widths and this table, if there is an instance.
        ///
        /// # Panics
        ///
        /// If a field of the table has not `2^n` words or holds a word outside its range.
        pub fn quadratic(widths: &QuadraticWidths, rom: QuadraticRom) -> Option<Box<dyn Kernel>> {
            $({
                const W: QuadraticWidths = QuadraticWidths { $($field: $bits),+ };
                if *widths == W {
                    return Some(Box::new(Pipeline(quadratic::Quadratic::<
                        { W.n },
                        { W.kw },
                        { W.ca },
                        { W.f + 2 },
                        { W.f + 1 },
                        { W.shifted() },
                        { W.fv + 1 },
                        { W.xb + 1 },
                        { W.fp },
                        { W.fp + 1 },
                        { W.difference() + 1 },
                        { W.g + 1 },
                    >::new(&W, rom))));
                }
            })+
            None
        }
    };
}

/// Makes the list of cubic width sets and the look-up in it.
macro_rules! cubic_sets {
    ($({ $($field:ident: $bits:expr),+ })+) => {
        /// The widths for which [`cubic()`] has an instance.
        pub const CUBIC_SETS: &[CubicWidths] = &[$(CubicWidths { $($field: $bits),+ }),+];

        /// The cubic core with exactly these widths and this table, if there is an instance.
        ///
        /// # Panics
        ///
        /// If a field of the table has not `2^n` words or holds a word outside its range.
        pub fn cubic(widths: &CubicWidths, rom: CubicRom) -> Option<Box<dyn Kernel>> {
            $({
                const W: CubicWidths = CubicWidths { $($field: $bits),+ };
                if *widths == W {
                    return Some(Box::new(Pipeline(cubic::Cubic::<
                        { W.n },
                        { W.kw },
                        { W.wl },
                        { W.wa },
                        { W.f + 2 },
                        { W.f + 1 },
                        { W.f + W.iv },
                        { W.fv + W.iv },
                        { W.inner_width() },
                        { W.wq },
                        { W.xb + 1 },
                        { W.fp },
                        { W.p_width() },
                        { W.difference() + 1 },
                        { W.g + 1 },
                    >::new(&W, rom))));
                }
            })+
            None
        }
    };
}

// The widths that the error analysis gives for n = 1..=1000 with 16 bits, 1..=256 with 12 and 1..=64 with 8.
quadratic_sets! {
    { f: 16, g: 16, n: 10, kw: 4, kmax: 10, ca: 18, fv: 15, fp: 17, xb: 16, ft: 18 }
    { f: 12, g: 12, n: 9, kw: 4, kmax: 8, ca: 14, fv: 11, fp: 13, xb: 12, ft: 14 }
    { f: 8, g: 8, n: 7, kw: 3, kmax: 6, ca: 9, fv: 7, fp: 11, xb: 8, ft: 9 }
}

cubic_sets! {
    { f: 16, g: 16, n: 10, kw: 4, fv: 15, iv: 2, cl: 18, wl: 17,
      ca: 20, wa: 20, fr: 20, fq: 20, wq: 20, lq: Some(18), fp: 18, xb: 16, ft: 17 }
    { f: 12, g: 12, n: 9, kw: 4, fv: 11, iv: 2, cl: 13, wl: 12,
      ca: 16, wa: 16, fr: 16, fq: 16, wq: 16, lq: None, fp: 15, xb: 12, ft: 13 }
    { f: 8, g: 8, n: 7, kw: 3, fv: 7, iv: 2, cl: 10, wl: 9,
      ca: 11, wa: 11, fr: 11, fq: 11, wq: 11, lq: None, fp: 10, xb: 8, ft: 9 }
}
