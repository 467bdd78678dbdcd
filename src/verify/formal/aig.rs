//! And-inverter graphs: the circuits that are compared, built side by side in one graph, so that what is written alike
//! is one node.

use std::collections::HashMap;

/// A node or its complement: twice the node's number, plus 1 for the complement. Node 0 is the constant 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Literal(u32);

impl Literal {
    /// The constant 0.
    pub(super) const FALSE: Self = Self(0);
    /// The constant 1.
    pub(super) const TRUE: Self = Self(1);

    fn node(self) -> usize {
        (self.0 >> 1) as usize
    }
}

impl std::ops::Not for Literal {
    type Output = Self;

    fn not(self) -> Self {
        Self(self.0 ^ 1)
    }
}

impl From<bool> for Literal {
    fn from(value: bool) -> Self {
        if value { Self::TRUE } else { Self::FALSE }
    }
}

#[derive(Clone, Copy, Debug)]
enum Node {
    /// The constant 0.
    Zero,
    /// An input, by its number.
    Input(u32),
    And(Literal, Literal),
}

/// The graph. The arguments of a node come before it.
#[derive(Clone, Debug)]
pub(super) struct Aig {
    nodes: Vec<Node>,
    inputs: u32,
    known: HashMap<(Literal, Literal), Literal>,
}

impl Aig {
    /// A graph of the constant alone.
    pub(super) fn new() -> Self {
        Self { nodes: vec![Node::Zero], inputs: 0, known: HashMap::new() }
    }

    /// How many inputs there are.
    pub(super) fn inputs(&self) -> usize {
        self.inputs as usize
    }

    /// A new input.
    pub(super) fn input(&mut self) -> Literal {
        self.nodes.push(Node::Input(self.inputs));
        self.inputs += 1;
        Literal(2 * (self.nodes.len() as u32 - 1))
    }

    /// `a & b`.
    pub(super) fn and(&mut self, a: Literal, b: Literal) -> Literal {
        let (a, b) = (a.min(b), a.max(b));
        if a == Literal::FALSE || a == !b {
            return Literal::FALSE;
        }
        if a == Literal::TRUE || a == b {
            return b;
        }
        if let Some(&known) = self.known.get(&(a, b)) {
            return known;
        }
        self.nodes.push(Node::And(a, b));
        let made = Literal(2 * (self.nodes.len() as u32 - 1));
        self.known.insert((a, b), made);
        made
    }

    /// `a | b`.
    pub(super) fn or(&mut self, a: Literal, b: Literal) -> Literal {
        !self.and(!a, !b)
    }

    /// `a ^ b`.
    pub(super) fn xor(&mut self, a: Literal, b: Literal) -> Literal {
        let (one, other) = (self.and(a, !b), self.and(!a, b));
        self.or(one, other)
    }

    /// `select ? a : b`.
    pub(super) fn choose(&mut self, select: Literal, a: Literal, b: Literal) -> Literal {
        if a == b {
            return a;
        }
        let (one, other) = (self.and(select, a), self.and(!select, b));
        self.or(one, other)
    }

    /// The sum and the carry of three bits.
    fn add(&mut self, a: Literal, b: Literal, c: Literal) -> (Literal, Literal) {
        let half = self.xor(a, b);
        let sum = self.xor(half, c);
        let (one, other) = (self.and(a, b), self.and(half, c));
        (sum, self.or(one, other))
    }

    /// The low `width` bits of a product, lowest first: of numbers in two's complement if `signed`, else of whole
    /// numbers.
    ///
    /// Products of the same operands are the same nodes, in whichever order and with however many bits that only repeat
    /// the sign the operands were written.
    pub(super) fn product(&mut self, a: &[Literal], b: &[Literal], signed: bool, width: usize) -> Vec<Literal> {
        let bare = |bits: &[Literal]| -> Vec<Literal> {
            let mut bits = bits.to_vec();
            while match (signed, bits.as_slice()) {
                (false, [.., high]) => *high == Literal::FALSE,
                (true, [.., second, high]) => high == second,
                _ => false,
            } {
                bits.pop();
            }
            bits
        };
        let (a, b) = (bare(a), bare(b));
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        // In two's complement modulo 2^width, an operand that is extended to the whole width is a whole number.
        let extended = |bits: &[Literal], index: usize| match bits.get(index) {
            Some(&bit) => bit,
            None if signed => bits.last().copied().unwrap_or(Literal::FALSE),
            None => Literal::FALSE,
        };
        let mut sum = vec![Literal::FALSE; width];
        for row in 0..width {
            let multiplier = extended(&a, row);
            let mut carry = Literal::FALSE;
            for (column, bit) in sum[row..].iter_mut().enumerate() {
                let partial = self.and(multiplier, extended(&b, column));
                (*bit, carry) = self.add(*bit, partial, carry);
            }
        }
        sum
    }

    /// A word of a memory without a write port, lowest bit first; `address` lowest bit first, of as many bits as there
    /// are words.
    pub(super) fn word(&mut self, words: &[Vec<bool>], address: &[Literal]) -> Vec<Literal> {
        let width = words.first().map_or(0, Vec::len);
        (0..width)
            .map(|bit| {
                let mut level: Vec<Literal> = words.iter().map(|word| word[bit].into()).collect();
                for &select in address {
                    level = level.chunks(2).map(|pair| self.choose(select, pair[1], pair[0])).collect();
                }
                level[0]
            })
            .collect()
    }

    /// The values of all nodes: 64 runs at once, a bit each, for each input a word.
    pub(super) fn simulate(&self, inputs: &[u64]) -> Values {
        let mut values: Vec<u64> = Vec::with_capacity(self.nodes.len());
        let of =
            |values: &[u64], literal: Literal| values[literal.node()] ^ 0u64.wrapping_sub(u64::from(literal.0 & 1));
        for node in &self.nodes {
            values.push(match *node {
                Node::Zero => 0,
                Node::Input(index) => inputs[index as usize],
                Node::And(a, b) => of(&values, a) & of(&values, b),
            });
        }
        Values(values)
    }

    /// What a constant or an input is in a run.
    ///
    /// # Panics
    /// For any other literal.
    pub(super) fn value(&self, literal: Literal, run: &[bool]) -> bool {
        let value = match self.nodes[literal.node()] {
            Node::Zero => false,
            Node::Input(index) => run[index as usize],
            Node::And(..) => panic!("a literal that must be computed"),
        };
        value != (literal.0 & 1 == 1)
    }

    /// Which nodes these literals depend on.
    fn cone(&self, outputs: impl Iterator<Item = Literal>) -> Vec<bool> {
        let mut used = vec![false; self.nodes.len()];
        for output in outputs {
            used[output.node()] = true;
        }
        for index in (0..self.nodes.len()).rev() {
            if let (true, Node::And(a, b)) = (used[index], self.nodes[index]) {
                used[a.node()] = true;
                used[b.node()] = true;
            }
        }
        used
    }

    /// Runs through all values of the inputs on which the pairs depend, and returns values of all inputs for which the
    /// literals of a pair differ, if there are such; the inputs on which they do not depend are 0.
    /// Errors: if they depend on more than `most` inputs, at most 63: how many.
    pub(super) fn difference(&self, pairs: &[(Literal, Literal)], most: usize) -> Result<Option<Vec<bool>>, usize> {
        Ok(self.differences(&[pairs.to_vec()], most)?.pop().flatten())
    }

    /// As [`Self::difference`], for several groups of pairs at once: for each the first values for which the literals
    /// of one of its pairs differ. Errors: as there, of all groups together.
    pub(super) fn differences(
        &self,
        groups: &[Vec<(Literal, Literal)>],
        most: usize,
    ) -> Result<Vec<Option<Vec<bool>>>, usize> {
        // The nodes that count, one after the other, so that their values stay near each other: a graph holds many that
        // do not.
        let used = self.cone(groups.iter().flatten().flat_map(|&(one, other)| [one, other]));
        let mut places = vec![0u32; self.nodes.len()];
        let mut kept: Vec<Node> = Vec::new();
        let mut inputs: Vec<u32> = Vec::new();
        for (index, node) in self.nodes.iter().enumerate().filter(|(index, _)| used[*index]) {
            places[index] = kept.len() as u32;
            let moved = |literal: Literal| Literal(2 * places[literal.node()] + (literal.0 & 1));
            kept.push(match *node {
                Node::Zero => Node::Zero,
                Node::And(a, b) => Node::And(moved(a), moved(b)),
                Node::Input(input) => {
                    inputs.push(input);
                    Node::Input(inputs.len() as u32 - 1)
                }
            });
        }
        if inputs.len() > most {
            return Err(inputs.len());
        }
        let moved = |literal: Literal| Literal(2 * places[literal.node()] + (literal.0 & 1));
        let pair = |&(one, other): &(Literal, Literal)| [moved(one), moved(other)];
        let groups: Vec<Vec<[Literal; 2]>> = groups.iter().map(|pairs| pairs.iter().map(pair).collect()).collect();
        let values = |run: u64| {
            let mut shown = vec![false; self.inputs()];
            for (place, &input) in inputs.iter().enumerate() {
                shown[input as usize] = run >> place & 1 == 1;
            }
            shown
        };
        Ok(first_runs(&kept, inputs.len(), &groups).into_iter().map(|run| run.map(values)).collect())
    }

    /// The graph of these outputs in the binary AIGER format (Biere, "The AIGER And-Inverter Graph format", 2007); all
    /// inputs are kept, in their order.
    pub(super) fn aiger(&self, outputs: &[Literal]) -> Vec<u8> {
        let used = self.cone(outputs.iter().copied());
        let mut number = vec![0u32; self.nodes.len()];
        let mut next = self.inputs + 1;
        for (index, node) in self.nodes.iter().enumerate() {
            match node {
                Node::Input(input) => number[index] = input + 1,
                Node::And(..) if used[index] => {
                    number[index] = next;
                    next += 1;
                }
                _ => {}
            }
        }
        let coded = |literal: Literal| 2 * number[literal.node()] + (literal.0 & 1);
        let ands = next - 1 - self.inputs;
        let mut bytes = format!("aig {} {} 0 {} {ands}\n", next - 1, self.inputs, outputs.len()).into_bytes();
        for &output in outputs {
            bytes.extend(format!("{}\n", coded(output)).into_bytes());
        }
        for (index, node) in self.nodes.iter().enumerate() {
            if let (true, Node::And(a, b)) = (used[index], *node) {
                let (low, high) = (coded(a).min(coded(b)), coded(a).max(coded(b)));
                for mut delta in [2 * number[index] - high, high - low] {
                    while delta >= 0x80 {
                        bytes.push((delta & 0x7f) as u8 | 0x80);
                        delta >>= 7;
                    }
                    bytes.push(delta as u8);
                }
            }
        }
        bytes
    }
}

/// The values of nodes in 64 runs.
pub(super) struct Values(Vec<u64>);

impl Values {
    /// Those of a literal, a bit a run.
    pub(super) fn of(&self, literal: Literal) -> u64 {
        self.0[literal.node()] ^ 0u64.wrapping_sub(u64::from(literal.0 & 1))
    }
}

/// For each group of pairs the first of all values of so many inputs, a bit each, for which the literals of one of its
/// pairs differ.
fn first_runs(nodes: &[Node], inputs: usize, groups: &[Vec<[Literal; 2]>]) -> Vec<Option<u64>> {
    /// The values of the six lowest inputs in the runs of a word.
    const LOWEST: [u64; 6] = [
        0xaaaa_aaaa_aaaa_aaaa,
        0xcccc_cccc_cccc_cccc,
        0xf0f0_f0f0_f0f0_f0f0,
        0xff00_ff00_ff00_ff00,
        0xffff_0000_ffff_0000,
        0xffff_ffff_0000_0000,
    ];
    /// Words that are computed together, whose number in a block is the next three inputs.
    const LANES: usize = 8;
    type Block = [u64; LANES];
    let of = |values: &[Block], literal: Literal| -> Block {
        let flip = 0u64.wrapping_sub(u64::from(literal.0 & 1));
        values[literal.node()].map(|word| word ^ flip)
    };
    let mut values: Vec<Block> = vec![[0; LANES]; nodes.len()];
    let runs_of_block = 64 * LANES as u64;
    let mut found: Vec<Option<u64>> = vec![None; groups.len()];
    for first in (0..1u64 << inputs).step_by(64 * LANES) {
        for (place, node) in nodes.iter().enumerate() {
            values[place] = match *node {
                Node::Zero => [0; LANES],
                Node::Input(index) => std::array::from_fn(|lane| match LOWEST.get(index as usize) {
                    Some(word) => *word,
                    None => 0u64.wrapping_sub((first + 64 * lane as u64) >> index & 1),
                }),
                Node::And(a, b) => {
                    let (a, b) = (of(&values, a), of(&values, b));
                    std::array::from_fn(|lane| a[lane] & b[lane])
                }
            };
        }
        for (pairs, found) in groups.iter().zip(&mut found).filter(|(_, found)| found.is_none()) {
            let mut differs: Block = [0; LANES];
            for [one, other] in pairs {
                let (one, other) = (of(&values, *one), of(&values, *other));
                differs = std::array::from_fn(|lane| differs[lane] | (one[lane] ^ other[lane]));
            }
            let run = (0..runs_of_block).find(|run| differs[(run / 64) as usize] >> (run % 64) & 1 == 1);
            // Of fewer inputs than make a block the runs repeat themselves, the least come first.
            *found = run.map(|run| first + run);
        }
        if found.iter().all(Option::is_some) {
            break;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_one_value_that_differs_is_found_and_none_where_there_is_none() {
        for inputs in [3usize, 9, 13] {
            let mut aig = Aig::new();
            let bits: Vec<Literal> = (0..inputs).map(|_| aig.input()).collect();
            let sum = bits.iter().fold(Literal::FALSE, |sum, &bit| aig.xor(sum, bit));
            let again = bits.iter().rev().fold(Literal::FALSE, |sum, &bit| aig.xor(sum, bit));
            assert_ne!(sum, again);
            assert_eq!(aig.difference(&[(sum, again)], inputs), Ok(None));
            assert_eq!(aig.difference(&[(sum, again)], inputs - 1), Err(inputs));
            for run in [0, 5, (1u64 << inputs) - 1] {
                let hit = bits.iter().enumerate().fold(Literal::TRUE, |hit, (place, &bit)| {
                    let wanted = if run >> place & 1 == 1 { bit } else { !bit };
                    aig.and(hit, wanted)
                });
                let wrong = aig.xor(again, hit);
                let found = aig.difference(&[(again, again), (sum, wrong)], inputs).expect("few inputs").expect("one");
                let shown = bits.iter().enumerate().map(|(place, bit)| u64::from(aig.value(*bit, &found)) << place);
                assert_eq!(shown.sum::<u64>(), run);
            }
        }
    }

    /// Runs through all values of up to `bits` inputs, 64 at a time.
    fn all(aig: &Aig, bits: usize) -> Vec<Values> {
        let word = |first: u64, bit: usize| (0..64).map(|run| ((first + run) >> bit & 1) << run).sum::<u64>();
        (0..1u64 << bits)
            .step_by(64)
            .map(|first| aig.simulate(&(0..bits).map(|bit| word(first, bit)).collect::<Vec<_>>()))
            .collect()
    }

    fn number(values: &Values, run: usize, bits: &[Literal]) -> u64 {
        bits.iter().enumerate().map(|(place, &bit)| (values.of(bit) >> run & 1) << place).sum()
    }

    #[test]
    fn a_product_is_that_of_the_numbers_whatever_signs_and_widths() {
        for (signed, (wide_a, wide_b)) in
            [false, true].into_iter().flat_map(|s| [(4, 4), (3, 5), (1, 6)].map(|w| (s, w)))
        {
            for width in [3, 6, 8, 12] {
                let mut aig = Aig::new();
                let a: Vec<Literal> = (0..wide_a).map(|_| aig.input()).collect();
                let b: Vec<Literal> = (0..wide_b).map(|_| aig.input()).collect();
                let product = aig.product(&a, &b, signed, width);
                let of = |value: u64, bits: usize| {
                    let value = value as i64;
                    if signed && value >> (bits - 1) & 1 == 1 { value - (1 << bits) } else { value }
                };
                for (block, values) in all(&aig, wide_a + wide_b).iter().enumerate() {
                    for run in 0..64 {
                        let (x, y) = (number(values, run, &a), number(values, run, &b));
                        let want = (of(x, wide_a) * of(y, wide_b)) as u64 & ((1 << width) - 1);
                        assert_eq!(number(values, run, &product), want, "{x} * {y}, signed {signed}, block {block}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_same_product_is_the_same_nodes() {
        let mut aig = Aig::new();
        let a: Vec<Literal> = (0..5).map(|_| aig.input()).collect();
        let b: Vec<Literal> = (0..4).map(|_| aig.input()).collect();
        let wider = |bits: &[Literal], high: Literal| [bits, &[high; 3]].concat();
        let plain = aig.product(&a, &b, false, 9);
        let nodes = aig.nodes.len();
        assert_eq!(plain, aig.product(&wider(&b, Literal::FALSE), &wider(&a, Literal::FALSE), false, 9));
        assert_eq!(aig.nodes.len(), nodes);
        let signed = aig.product(&a, &b, true, 9);
        assert_ne!(signed, plain);
        assert_eq!(signed, aig.product(&wider(&b, b[3]), &wider(&a, a[4]), true, 9));
    }

    #[test]
    fn a_word_is_that_at_the_address() {
        let words: Vec<Vec<bool>> =
            (0..8u32).map(|row| (0..5).map(|bit| (row * 11 + 3) >> bit & 1 == 1).collect()).collect();
        let mut aig = Aig::new();
        let address: Vec<Literal> = (0..3).map(|_| aig.input()).collect();
        let word = aig.word(&words, &address);
        let values = &aig.simulate(&[0xaa, 0xcc, 0xf0]);
        for row in 0..8 {
            assert_eq!(number(values, row, &word), (row as u64 * 11 + 3) & 31);
        }
    }
}
