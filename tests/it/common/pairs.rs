//! Covering arrays: few rows of choices in which every two values of two choices that go together do so in some row.

use std::collections::BTreeSet;

/// Something to choose, and its values. The first is the plainest: as a rule, nothing.
pub struct Choice {
    /// What it is.
    pub name: &'static str,
    /// What it may be.
    pub values: Vec<&'static str>,
}

/// A value of a choice: the places of both.
pub type Pick = (usize, usize);

/// Rows with a value for each choice.
pub struct Covering {
    /// The place of each choice's value.
    pub rows: Vec<Vec<usize>>,
    /// The pairs of values that go together, and so are in some row, the lower choice first.
    pub pairs: BTreeSet<(Pick, Pick)>,
    /// The pairs that do not go together, whatever else is chosen.
    pub impossible: Vec<(Pick, Pick)>,
}

/// The pairs of a row, the lower choice first.
pub fn pairs_of(row: &[usize]) -> impl Iterator<Item = (Pick, Pick)> + '_ {
    (0..row.len()).flat_map(move |a| (a + 1..row.len()).map(move |b| ((a, row[a]), (b, row[b]))))
}

/// Covers every pair of values that goes together, greedily and always in the same way: a row begins with a pair that
/// none has yet, and takes for each other choice the value that makes most new pairs with what is chosen already.
///
/// `valid` says whether a row goes. What a value needs of other choices must be found among those of `helpers`, with
/// the plainest of all others; and leaving any other choice at its plainest must spoil no row.
pub fn covering(choices: &[Choice], helpers: &[usize], valid: &dyn Fn(&[usize]) -> bool) -> Covering {
    let mut open: BTreeSet<(Pick, Pick)> = BTreeSet::new();
    for a in 0..choices.len() {
        for b in a + 1..choices.len() {
            let values = |choice: usize| 0..choices[choice].values.len();
            open.extend(values(a).flat_map(|va| values(b).map(move |vb| ((a, va), (b, vb)))));
        }
    }
    let mut covering = Covering { rows: Vec::new(), pairs: BTreeSet::new(), impossible: Vec::new() };
    while let Some(&pair) = open.first() {
        let turn = covering.rows.len();
        let Some(mut row) = completed(choices, helpers, pair, turn, valid) else {
            open.remove(&pair);
            covering.impossible.push(pair);
            continue;
        };
        let mut chosen = vec![pair.0.0, pair.1.0];
        // What was taken to make the pair go counts as chosen.
        chosen
            .extend((0..row.len()).filter(|choice| !chosen.contains(choice) && row[*choice] != 0).collect::<Vec<_>>());
        for step in 0..choices.len() {
            let choice = (step + turn) % choices.len();
            if chosen.contains(&choice) {
                continue;
            }
            let gain = |value: usize| {
                let pair = |&other: &usize| {
                    let (own, other) = ((choice, value), (other, row[other]));
                    if own < other { (own, other) } else { (other, own) }
                };
                chosen.iter().map(pair).filter(|pair| open.contains(pair)).count()
            };
            let count = choices[choice].values.len();
            // Where several are as good, not always the same.
            let mut values: Vec<(usize, usize, usize)> =
                (0..count).map(|value| (gain(value), (value + count - turn % count) % count, value)).collect();
            values.sort_unstable_by(|a, b| b.cmp(a));
            let fits = |&value: &usize| {
                let mut with = row.clone();
                with[choice] = value;
                valid(&with)
            };
            row[choice] = values.into_iter().map(|(_, _, value)| value).find(fits).expect("the plainest value goes");
            chosen.push(choice);
        }
        for pair in pairs_of(&row) {
            open.remove(&pair);
            covering.pairs.insert(pair);
        }
        covering.rows.push(row);
    }
    covering
}

/// A row with a pair in it and with what that needs of the helpers; else of the plainest values.
fn completed(
    choices: &[Choice],
    helpers: &[usize],
    pair: (Pick, Pick),
    turn: usize,
    valid: &dyn Fn(&[usize]) -> bool,
) -> Option<Vec<usize>> {
    let helpers: Vec<usize> =
        helpers.iter().copied().filter(|&helper| helper != pair.0.0 && helper != pair.1.0).collect();
    let total: usize = helpers.iter().map(|&helper| choices[helper].values.len()).product();
    // The plainest of the later helpers first.
    (0..total).find_map(|place| {
        let mut row = vec![0; choices.len()];
        row[pair.0.0] = pair.0.1;
        row[pair.1.0] = pair.1.1;
        let mut rest = place;
        for (number, &helper) in helpers.iter().enumerate() {
            let count = choices[helper].values.len();
            // The first helper is one that always has to be chosen: each row begins with another of its values.
            row[helper] = if number == 0 { (rest + turn) % count } else { rest % count };
            rest /= count;
        }
        valid(&row).then_some(row)
    })
}
