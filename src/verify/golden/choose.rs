//! Which inputs become vectors.

use rayon::prelude::*;

use super::Vector;
use super::detection::{self, Candidates};
use crate::core::LobeDesign;
use crate::datapath::evaluate::Evaluator;
use crate::datapath::graph::{Graph, Node, Op};
use crate::fixed::{Rng, Table, exp2};
use crate::lobe::Lobe;
use crate::verify::faults::simulation::blocks;

/// Rows beyond which not every row has vectors of its own.
const MOST_ROWS: usize = 1024;
/// Inputs among which those are sought that detect wrong entries of function tables.
const MOST_CANDIDATES: usize = 1 << 17;
/// Random vectors of each of the two kinds.
const RANDOM: usize = 512;
/// Inputs among which those are sought that detect mutants, as a power of two, and those of one task.
const MOST_CANDIDATE_BITS: u32 = 21;
const TASK_BITS: u32 = 15;

/// An input, and for each function table the entry that it reads and a bit for each flipped bit of it that changes the
/// output.
struct Candidate {
    index: u32,
    versine: i64,
    reads: Vec<(usize, u128)>,
}

/// A memory with one bit of every word flipped.
struct Flip {
    /// The place of the memory among the function tables.
    table: usize,
    /// The bit for it in [`Candidate::reads`].
    mask: u128,
    tables: Vec<Table>,
}

struct Chooser<'a> {
    design: LobeDesign<'a>,
    lobes: &'a [Box<dyn Lobe>],
    rng: Rng,
    one: i64,
}

/// The vectors of a design, in groups with a heading.
pub(super) fn vectors(design: LobeDesign<'_>) -> Vec<(String, Vec<Vector>)> {
    let mut chooser =
        Chooser { design, lobes: design.lobes, rng: Rng::new(0), one: 1 << design.interface.input_fraction };
    let mut groups = vec![
        ("corners of the port codes".to_owned(), chooser.port_corners()),
        ("corners of the lobe: 0, 1, the cusp, where it ends, each with its neighbours".to_owned(), chooser.corners()),
        ("codes of in_n, all or evenly spaced, at the cusp".to_owned(), chooser.indices()),
    ];
    groups.push(("rows told from rows with any bit of the ROM word flipped".to_owned(), chooser.rom_bits()));
    let entries = chooser.entry_bits();
    if !entries.is_empty() {
        groups.push(("entries of function tables told from entries with any bit flipped".to_owned(), entries));
    }
    groups.push(("random, all codes".to_owned(), chooser.random_codes()));
    groups.push(("random, on the highlight".to_owned(), chooser.random_highlight()));
    let known: Vec<&Vector> = groups.iter().flat_map(|(_, vectors)| vectors).collect();
    let mutants = chooser.mutants(&known);
    if !mutants.is_empty() {
        groups.push(("mutants that no vector above tells from the core".to_owned(), mutants));
    }
    let known: Vec<&Vector> = groups.iter().flat_map(|(_, vectors)| vectors).collect();
    let pausing = detection::pausing(&design, &known, &|task| chooser.candidates(task));
    if !pausing.is_empty() {
        groups.push(("mutants of registers that no vector above tells from the core".to_owned(), pausing));
    }
    groups
}

impl<'a> Chooser<'a> {
    fn vector(&mut self, index: u32, operand: i64) -> Vector {
        let (idle, stall) = (super::pause(&mut self.rng), super::pause(&mut self.rng));
        let inputs = vec![index.into(), operand];
        Vector { outputs: self.design.evaluate(&inputs), inputs, idle, stall }
    }

    /// A few rows that matter: the first and last, small ones, powers of two and their neighbours.
    fn marked_rows(&self) -> Vec<usize> {
        let rows = self.design.interface.shininess.rows();
        let mut marked: Vec<usize> = (0..rows.min(4)).chain(rows.saturating_sub(2)..rows).collect();
        for power in 2..17u32 {
            for near in [-1i64, 0, 1] {
                let row = (1i64 << power) + near - 1;
                marked.extend(usize::try_from(row).ok().filter(|&row| row < rows));
            }
        }
        marked.sort_unstable();
        marked.dedup();
        marked
    }

    fn port_corners(&mut self) -> Vec<Vector> {
        let design = self.design;
        let (first, count) = super::all_codes(design.operand_format());
        let last = first + count as i64 - 1;
        let mut operands = vec![first, first + 1, -2, -1, 0, 1, self.one - 1, self.one, self.one + 1, last - 1, last];
        operands.extend([first / 2, last / 2, -self.one, self.one / 2, -self.one / 2]);
        operands.retain(|code| (first..=last).contains(code));
        operands.sort_unstable();
        operands.dedup();
        let last_index = (1u64 << design.index_format().width()) as u32 - 1;
        let rows = design.interface.shininess.rows();
        let set = &design.interface.shininess;
        let mut indices = vec![0, 1.min(last_index), set.index_of_row(0), set.index_of_row(rows / 2)];
        indices.extend([set.index_of_row(rows - 1), last_index]);
        indices.sort_unstable();
        indices.dedup();
        let pairs = indices.iter().flat_map(|&index| operands.iter().map(move |&operand| (index, operand)));
        pairs.collect::<Vec<_>>().into_iter().map(|(index, operand)| self.vector(index, operand)).collect()
    }

    /// Versine codes around a real versine, kept inside [0, 1].
    fn around(&self, u: f64) -> impl Iterator<Item = i64> + use<> {
        let (centre, one) = ((u * self.one as f64) as i64, self.one);
        (centre - 1..=centre + 2).filter(move |code| (0..=one).contains(code))
    }

    /// The first versine code from which the real lobe of a row stays 0 or the value that it is held at, by bisection:
    /// it never rises again from there.
    fn end(&self, row: usize) -> i64 {
        let at = |code: i64| self.lobes[row].at(code as f64 / self.one as f64);
        let held = at(self.one - 1) == at(self.one - 2);
        self.falls_to(row, if held { at(self.one - 1) } else { 0.0 })
    }

    /// The first versine code at which the real lobe of a row, which falls, is not above `level`.
    fn falls_to(&self, row: usize, level: f64) -> i64 {
        let lobe = &self.lobes[row];
        let (mut low, mut high) = (0, self.one);
        while high - low > 1 {
            let middle = (low + high) / 2;
            if lobe.at(middle as f64 / self.one as f64) > level { low = middle } else { high = middle }
        }
        high
    }

    fn corners(&mut self) -> Vec<Vector> {
        let mut result = Vec::new();
        for row in self.marked_rows() {
            let n = self.design.interface.shininess.value(row);
            let cusp = -libm::expm1(-std::f64::consts::LN_2 / n);
            let mut codes: Vec<i64> = [0, 1, 2, self.one - 1, self.one].into();
            codes.extend(self.around(cusp));
            codes.extend(self.around(self.end(row) as f64 / self.one as f64));
            // The powers of two at which a scaled versine changes its leading bit.
            for shift in 1..=self.design.interface.input_fraction as i32 {
                codes.extend(self.around(exp2(-shift)).filter(|_| exp2(-shift) * n < 8.0 && exp2(-shift) * n > 0.5));
            }
            codes.sort_unstable();
            codes.dedup();
            let index = self.design.interface.shininess.index_of_row(row);
            for code in codes {
                result.push(self.vector(index, self.design.operand_of_versine(code)));
            }
        }
        result
    }

    /// Every code of `in_n`, those outside the set included (evenly spaced ones where there are many).
    fn indices(&mut self) -> Vec<Vector> {
        let design = self.design;
        let count = 1usize << design.index_format().width();
        // Odd, so that every bit of in_n varies.
        let step = count.div_ceil(MOST_ROWS) | 1;
        let indices = (0..count).step_by(step).map(|index| index as u32);
        indices
            .map(|index| {
                let n = design.interface.shininess.value(design.interface.shininess.row_of_index(index));
                let cusp = -libm::expm1(-std::f64::consts::LN_2 / n);
                self.vector(index, design.operand_of_versine((cusp * self.one as f64) as i64))
            })
            .collect()
    }

    /// For each code of in_n the fewest inputs that a greedy search finds to detect every bit of its ROM word that is
    /// flipped, as far as any candidate does.
    fn rom_bits(&mut self) -> Vec<Vector> {
        let design = self.design;
        let set = &design.interface.shininess;
        let count = set.of_knots().rows();
        let mut flipped: Vec<Vec<Table>> = Vec::new();
        for (memory, table) in design.tables().iter().enumerate().filter(|(_, table)| table.key == "shininess") {
            // A memory may hold several words a shininess, one a segment, side by side.
            let parts = (table.rows() / count).max(1);
            for (field, bit, part) in (0..table.fields.len())
                .flat_map(|field| (0..table.fields[field].format.width()).map(move |bit| (field, bit)))
                .flat_map(|(field, bit)| (0..parts).map(move |part| (field, bit, part)))
            {
                let mut tables = design.tables().to_vec();
                let format = table.fields[field].format;
                for code in tables[memory].fields[field].codes.iter_mut().skip(part).step_by(parts) {
                    *code = format.wrap(*code ^ (1 << bit));
                }
                flipped.push(tables);
            }
        }
        // Made once, as an evaluator lays out what is looked up at computed addresses.
        let flipped: Vec<Evaluator> = flipped.iter().map(|tables| Evaluator::new(design.graph(), tables)).collect();
        // Every code of in_n, as words stand behind those outside the set too. Where coefficients are interpolated at
        // too many places: at each row of the ROM, and the last before the next.
        let most = set.rows() - 1;
        let port_codes = 1usize << design.index_format().width();
        let indices: Vec<u32> = if port_codes <= MOST_ROWS {
            (0..port_codes as u32).collect()
        } else if most < MOST_ROWS {
            (0..=most).map(|row| set.index_of_row(row)).collect()
        } else {
            let knots = (0..count).step_by(count.div_ceil(MOST_ROWS));
            let ends = knots.flat_map(|knot| [knot << set.frac_bits(), ((knot + 1) << set.frac_bits()) - 1]);
            let mut places: Vec<usize> = ends.map(|place| place.min(most)).collect();
            places.dedup();
            places.into_iter().map(|row| set.index_of_row(row)).collect()
        };
        let chosen: Vec<Vec<i64>> = indices.par_iter().map(|&index| self.detecting(index, &flipped)).collect();
        let mut result = Vec::new();
        for (index, codes) in indices.into_iter().zip(chosen) {
            result.extend(codes.into_iter().map(|code| self.vector(index, design.operand_of_versine(code))));
        }
        result
    }

    /// Versine codes that detect as many of the `flipped` words of a code of in_n as possible.
    fn detecting(&self, index: u32, flipped: &[Evaluator]) -> Vec<i64> {
        let design = self.design;
        let row = design.interface.shininess.row_of_index(index);
        let end = self.end(row);
        let cuts = design.datapath.coefficients().and_then(|table| table.find("cut"));
        let cut = cuts.map_or(end, |field| field.codes[design.interface.shininess.knot(row).0] as i64);
        // First blocks about the end of the lobe, where a coefficient weighs most, and about the cut, which lies past
        // it where a tail is held, and combs over the lobe and over all; then, for what these do not detect, a fine
        // comb over the lobe.
        let block = |about: i64| ((about - 183).clamp(0, self.one), 1, 192);
        let comb = |last: i64, count: i64| (0, (last / count).max(1), count);
        let steps = [vec![block(end), comb(end, 192), comb(self.one, 192), block(cut)], vec![comb(end, 2048)]];
        let mut open: Vec<usize> = (0..flipped.len()).collect();
        let mut chosen = Vec::new();
        for combs in steps {
            self.detect(index, &combs, flipped, &mut open, &mut chosen);
        }
        chosen
    }

    /// Moves from `open` what any code of the combs (first code, stride, and how many at most) detects; the codes go to
    /// `chosen`.
    fn detect(
        &self,
        index: u32,
        combs: &[(i64, i64, i64)],
        flipped: &[Evaluator],
        open: &mut Vec<usize>,
        chosen: &mut Vec<i64>,
    ) {
        let design = self.design;
        let combs =
            combs.iter().map(|&(first, stride, most)| (first, stride, ((self.one - first) / stride + 1).min(most)));
        let combs: Vec<(i64, i64, i64)> = combs.collect();
        let codes: Vec<i64> = combs
            .iter()
            .flat_map(|&(first, stride, count)| (0..count).map(move |step| first + stride * step))
            .collect();
        let outputs = |evaluator: &Evaluator| -> Vec<u32> {
            combs.iter().flat_map(|&comb| outputs(design, evaluator, index, comb)).collect()
        };
        let right = outputs(&design.evaluator());
        let detects = |&flip: &usize| outputs(&flipped[flip]).iter().zip(&right).map(|(a, b)| a != b).collect();
        let detects: Vec<Vec<bool>> = open.iter().map(detects).collect();
        chosen.extend(super::greedy(codes.len(), &detects).into_iter().map(|place| codes[place]));
        let mut detects = detects.iter();
        open.retain(|_| detects.next().is_some_and(|detects| !detects.contains(&true)));
    }

    /// For each entry of each function table inputs that detect each of its bits that is flipped, as far as any
    /// candidate does: all inputs of a small core, else combs over the lobes of the marked rows, or of all where each
    /// row has entries of its own.
    fn entry_bits(&mut self) -> Vec<Vector> {
        let design = self.design;
        let (graph, tables) = (design.graph(), design.tables());
        let memories: Vec<usize> = (0..tables.len()).filter(|&memory| tables[memory].key == "entry").collect();
        // The same memory read by a graph that shows the address.
        let address = |&memory: &usize| {
            let reads = |node: &&Node| matches!(node.op, Op::Field { memory: of, .. } if of == memory);
            let node = graph.nodes.iter().find(reads)?.args[0];
            Some(Graph { outputs: vec![("address".to_owned(), node)], ..graph.clone() })
        };
        let addresses: Vec<Graph> = memories.iter().filter_map(address).collect();
        let flips: Vec<Flip> =
            memories.iter().enumerate().flat_map(|(table, &memory)| flips(tables, memory, table)).collect();
        if flips.is_empty() {
            return Vec::new();
        }

        let set = &design.interface.shininess;
        // A table of the power itself has entries for each row: every row is gone through, those that only codes
        // outside the set read too, and in it every cell, as also a word that is 0 shows when it is not.
        let table_bits = design.method.options().table_bits;
        let of_rows = table_bits.is_some();
        let all = set.rows().saturating_mul(self.one as usize + 1) <= MOST_CANDIDATES;
        let indices: Vec<u32> = if of_rows && tables[memories[0]].first_index == 0 {
            (0..1 << design.index_format().width()).collect()
        } else {
            let rows = if all || of_rows { (0..set.rows()).collect() } else { self.marked_rows() };
            rows.into_iter().map(|row| set.index_of_row(row)).collect()
        };
        let codes = if all { self.one + 1 } else { (MOST_CANDIDATES / indices.len()).max(1) as i64 };
        let least = exp2(-(design.interface.output_fraction as i32) - 2);
        // Made once, as an evaluator lays out what is looked up at computed addresses.
        let addresses: Vec<Evaluator> = addresses.iter().map(|graph| Evaluator::new(graph, tables)).collect();
        let flipped: Vec<Evaluator> = flips.iter().map(|flip| Evaluator::new(graph, &flip.tables)).collect();
        let evaluator = Evaluator::new(graph, tables);
        let of_index = |&index: &u32| -> Vec<Candidate> {
            let end = if all || of_rows { self.one } else { self.falls_to(set.row_of_index(index), least) };
            // An odd stride, so that the low bits vary; of a table one code a cell, the first.
            let cells = table_bits.filter(|_| !all);
            let stride = cells.map_or((end / codes) | 1, |bits| (self.one >> bits).max(1));
            let count = end / stride + 1;
            let outputs = |evaluator: &Evaluator| outputs(design, evaluator, index, (0, stride, count));
            let read: Vec<Vec<u32>> = addresses.iter().map(outputs).collect();
            let mut candidates: Vec<Candidate> = (0..count as usize)
                .map(|step| Candidate {
                    index,
                    versine: stride * step as i64,
                    reads: read.iter().map(|entries| (entries[step] as usize, 0)).collect(),
                })
                .collect();
            let right = outputs(&evaluator);
            for (flip, flipped) in flips.iter().zip(&flipped) {
                for ((candidate, right), wrong) in candidates.iter_mut().zip(&right).zip(outputs(flipped)) {
                    if *right != wrong {
                        candidate.reads[flip.table].1 |= flip.mask;
                    }
                }
            }
            candidates.retain(|candidate| candidate.reads.iter().any(|&(_, detected)| detected != 0));
            candidates
        };
        let candidates: Vec<Candidate> =
            indices.par_iter().map(of_index).collect::<Vec<_>>().into_iter().flatten().collect();

        let chosen =
            greedy_entries(&memories.iter().map(|&memory| tables[memory].depth()).collect::<Vec<_>>(), &candidates);
        chosen.into_iter().map(|(index, versine)| self.vector(index, design.operand_of_versine(versine))).collect()
    }

    /// Bits of the ports, or fewer where not all inputs are candidates.
    fn candidate_bits(&self) -> u32 {
        (self.design.index_format().width() + self.design.operand_format().width()).min(MOST_CANDIDATE_BITS)
    }

    /// A task's candidates among which inputs are sought that detect mutants: all inputs of a small core, else random
    /// ones, most of them on the highlight and many at the least shininesses.
    fn candidates(&self, task: u64) -> Candidates<'a> {
        let (design, one, bits) = (self.design, self.one, self.candidate_bits());
        let (index_bits, operand) = (design.index_format().width(), design.operand_format());
        let all = index_bits + operand.width() == bits;
        let (first, operands) = super::all_codes(operand);
        let rows = design.interface.shininess.rows() as u64;
        let mut rng = Rng::new((5 << 40) + task);
        let places = task << TASK_BITS..((task + 1) << TASK_BITS).min(1 << bits);
        blocks(places.map(move |place| {
            let (index, operand) = if all {
                (place >> operand.width(), first + (place & (operands - 1)) as i64)
            } else if place % 4 == 0 {
                (rng.below(1 << index_bits), first + rng.below(operands) as i64)
            } else {
                // Every other row from the lower ones, where more of a lobe's inputs give anything.
                let most = if place % 4 == 1 { rows.min(2 << rng.below(index_bits.into())) } else { rows };
                let row = rng.below(most) as usize;
                let widest = (3.0 / design.interface.shininess.value(row)).min(1.0) * one as f64;
                let versine = rng.below(widest as u64 + 1) as i64;
                (design.interface.shininess.index_of_row(row).into(), design.operand_of_versine(versine))
            };
            [index as i64, operand]
        }))
    }

    /// Inputs that detect mutants which no known vector does.
    fn mutants(&mut self, known: &[&Vector]) -> Vec<Vector> {
        let tasks = (1u64 << self.candidate_bits()).div_ceil(1 << TASK_BITS);
        let chosen = detection::detecting(&self.design, known, tasks, &|task| self.candidates(task));
        chosen.into_iter().map(|inputs| self.vector(inputs[0] as u32, inputs[1])).collect()
    }

    fn random_codes(&mut self) -> Vec<Vector> {
        let (first, count) = super::all_codes(self.design.operand_format());
        let indices = 1u64 << self.design.index_format().width();
        (0..RANDOM)
            .map(|_| {
                let (index, operand) = (self.rng.below(indices) as u32, first + self.rng.below(count) as i64);
                self.vector(index, operand)
            })
            .collect()
    }

    fn random_highlight(&mut self) -> Vec<Vector> {
        let design = self.design;
        let rows = design.interface.shininess.rows() as u64;
        (0..RANDOM)
            .map(|_| {
                let row = self.rng.below(rows) as usize;
                let widest = (3.0 / design.interface.shininess.value(row)).min(1.0) * self.one as f64;
                let code = self.rng.below(widest as u64 + 1) as i64;
                self.vector(design.interface.shininess.index_of_row(row), design.operand_of_versine(code))
            })
            .collect()
    }
}

/// The results for versine codes (the first, the stride and how many), in their order, whichever way the operand runs.
fn outputs(
    design: LobeDesign<'_>,
    evaluator: &Evaluator,
    index: u32,
    (first, stride, count): (i64, i64, i64),
) -> Vec<u32> {
    let [a, b] = [first, first + stride * (count - 1)].map(|versine| design.operand_of_versine(versine));
    let mut outputs = vec![0; count as usize];
    evaluator.evaluate(index, a.min(b), stride, &mut outputs);
    if b < a {
        outputs.reverse();
    }
    outputs
}

/// Candidates, their indices and versines, that together detect each flipped bit of each entry of function tables of
/// these depths that any of the candidates detects: always the one that detects most of what is left of an entry.
fn greedy_entries(depths: &[usize], candidates: &[Candidate]) -> Vec<(u32, i64)> {
    let mut detected: Vec<Vec<u128>> = depths.iter().map(|&depth| vec![0; depth]).collect();
    let mut chosen = Vec::new();
    for (table, &depth) in depths.iter().enumerate() {
        let mut of_entry: Vec<Vec<&Candidate>> = vec![Vec::new(); depth];
        for candidate in candidates {
            of_entry[candidate.reads[table].0].push(candidate);
        }
        for (entry, candidates) in of_entry.iter().enumerate() {
            loop {
                let more = |candidate: &&&Candidate| (candidate.reads[table].1 & !detected[table][entry]).count_ones();
                // The first of the best: `max_by_key` would take the last.
                let best = candidates.iter().rev().max_by_key(more).filter(|candidate| more(candidate) > 0);
                let Some(best) = best else { break };
                chosen.push((best.index, best.versine));
                for (detected, &(entry, bits)) in detected.iter_mut().zip(&best.reads) {
                    detected[entry] |= bits;
                }
            }
        }
    }
    chosen
}

/// A memory, the function table number `table`, with each bit of its words flipped in turn: one bit of all words at
/// once, since an input reads one of them.
fn flips(tables: &[Table], memory: usize, table: usize) -> Vec<Flip> {
    let mut result = Vec::new();
    for (field, of) in tables[memory].fields.iter().enumerate() {
        for bit in 0..of.format.width() {
            let mut flipped = tables.to_vec();
            for code in &mut flipped[memory].fields[field].codes {
                *code = of.format.wrap(*code ^ (1 << bit));
            }
            // A word is narrower than 128 bits: its fields enter products that are.
            result.push(Flip { table, mask: 1 << (tables[memory].field_low_bit(field) + bit), tables: flipped });
        }
    }
    result
}
