//! Values of ports side by side, and the first of them that detects a fault.

use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::simulation::{Block, FaultSimulation};
use crate::datapath::fault::Fault;
use crate::datapath::graph::Graph;
use crate::datapath::range::Span;
use crate::fixed::Table;

/// Inputs that one task runs.
const CHUNK: u64 = 1 << 16;

/// Values of ports, side by side.
pub(super) struct Domain {
    ports: Vec<Span>,
}

impl Domain {
    pub(super) fn of(ports: Vec<Span>) -> Self {
        Self { ports }
    }

    /// Every code of every port.
    pub(super) fn whole(graph: &Graph) -> Self {
        Self::of(graph.inputs.iter().map(|&id| Span::of(graph.nodes[id].format)).collect())
    }

    /// How many there are, if a number of 64 bits can say it.
    pub(super) fn count(&self) -> Option<u64> {
        self.ports.iter().try_fold(1u64, |count, port| count.checked_mul(port.count().try_into().ok()?))
    }

    /// The codes at a place: the last port's change first.
    pub(super) fn at(&self, place: u64) -> Vec<i64> {
        let mut rest = place;
        let mut codes = vec![0; self.ports.len()];
        for (code, port) in codes.iter_mut().zip(&self.ports).rev() {
            let count = port.count() as u64;
            *code = port.low as i64 + (rest % count) as i64;
            rest /= count;
        }
        codes
    }
    /// The codes behind some.
    fn advance(&self, codes: &mut [i64]) {
        for (code, port) in codes.iter_mut().zip(&self.ports).rev() {
            if i128::from(*code) < port.high {
                *code += 1;
                return;
            }
            *code = port.low as i64;
        }
    }
}

/// For each fault the place of the first value of a domain of `total` that detects it.
pub(super) fn first_detected(
    graph: &Graph,
    tables: &[Table],
    domain: &Domain,
    total: u64,
    faults: &[&Fault],
) -> Vec<Option<u64>> {
    let simulation = FaultSimulation::new(graph, tables);
    let first: Vec<AtomicU64> = faults.iter().map(|_| AtomicU64::new(u64::MAX)).collect();
    (0..total.div_ceil(CHUNK)).into_par_iter().for_each(|chunk| {
        let start = chunk * CHUNK;
        let open = |&place: &usize| first[place].load(Ordering::Relaxed) > start;
        let places: Vec<usize> = (0..faults.len()).filter(open).collect();
        let open: Vec<&Fault> = places.iter().map(|&place| faults[place]).collect();
        let (mut codes, mut left) = (domain.at(start), CHUNK.min(total - start));
        let mut next = |block: &mut Block| {
            block.count = left.min(Block::LANES as u64) as usize;
            left -= block.count as u64;
            for lane in 0..block.count {
                block.ports.iter_mut().zip(&codes).for_each(|(port, &code)| port[lane] = code);
                domain.advance(&mut codes);
            }
            block.count > 0
        };
        // Of all tasks' the first wins.
        simulation.run(&open, &mut next, &mut |place, lanes, block| {
            let index = start + block.before + u64::from(lanes.trailing_zeros());
            first[places[place]].fetch_min(index, Ordering::Relaxed);
            false
        });
    });
    first.into_iter().map(AtomicU64::into_inner).map(|index| (index != u64::MAX).then_some(index)).collect()
}
