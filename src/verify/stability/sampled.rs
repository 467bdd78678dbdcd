//! One core that has too many inputs to run or to halve: whether a value leaves its register.
//!
//! But it falls into parts whose joints are clamped to known ranges, and the range analysis goes over each part with
//! its joints free, so that it covers every combination that the part before it could give, and more. Of a shader:
//!
//! - the *front end* of a light, from the vectors' ports, every code of them, to N.L and the highlight's cosine;
//! - where that takes a root, the *root*, from the two values that go into it;
//! - the *lobe*, from its operand, row by row of the materials, as a lobe's core is analysed;
//! - the *colours*, from N.L, the lobes' results and the lights' colours, row by row of the materials.
//!
//! Of an image-based block: from the ports to the operands of a light's tables of functions, where it has any, and from
//! these to rows and to what lies between two rows; from the ports and these to the places of the normal among the
//! texels; from each place to the addresses and the weight; from all these to the channels.
//!
//! What is found of a part's results is what the next part's ports take. Nodes that no part covers count as undecided.

use rayon::prelude::*;
use serde::Serialize;

use super::inspect::{MOST_BLOCKS, Signal, signal};
use crate::block::image::{Joints as ImageJoints, StepJoints};
use crate::block::shader::datapath::Joints;
use crate::core::{BlockDesign, Design, ImageDesign, ShaderDesign};
use crate::datapath::graph::{Graph, NodeId};
use crate::datapath::range::{Analysis, Ranges, Region, Span, by_rows};
use crate::fixed::{Rng, Table};
use crate::spec::Shininess;

/// Inputs that are run with wide registers.
const SAMPLES: u64 = 1 << 14;

/// A part of a core, as it was analysed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Part {
    /// What it is.
    pub name: String,
    /// Blocks of inputs that the range analysis looked at.
    pub blocks: u64,
}

/// What the range analysis found.
#[derive(Clone, Debug, PartialEq)]
pub struct Proof {
    /// The parts, in the order of the data.
    pub parts: Vec<Part>,
    /// Values that overflow where a part's results depend on them: their nodes, with the part and its inputs in words.
    pub overflows: Vec<(NodeId, String)>,
    /// What the nodes take, of all parts together.
    pub ranges: Ranges,
}

/// Under construction.
struct Prover<'a> {
    graph: &'a Graph,
    tables: &'a [Table],
    is_covered: Vec<bool>,
    proof: Proof,
}

impl<'a> Prover<'a> {
    fn new(graph: &'a Graph, tables: &'a [Table]) -> Self {
        let nodes = graph.nodes.len();
        let proof = Proof { parts: Vec::new(), overflows: Vec::new(), ranges: Ranges::none(nodes) };
        Self { graph, tables, is_covered: vec![false; nodes], proof }
    }

    /// What was found; nodes that no part covers count as undecided.
    fn finish(self) -> Proof {
        let Self { is_covered, mut proof, graph, .. } = self;
        for id in (0..graph.nodes.len()).filter(|id| !is_covered[*id] && !graph.inputs.contains(id)) {
            proof.ranges.undecided[id] = true;
        }
        proof
    }

    fn part(&mut self, name: String, ports: &[NodeId], results: &[NodeId], regions: &[Region]) {
        let analysis = Analysis::of_part(self.graph, self.tables, ports, results);
        analysis.computed().for_each(|id| self.is_covered[id] = true);
        let found = analysis.over(regions, MOST_BLOCKS);
        for overflow in &found.overflows {
            let what = format!(
                "{} at the inputs {:?} of the part \"{name}\"",
                self.graph.nodes[overflow.node].name, overflow.inputs
            );
            self.proof.overflows.push((overflow.node, what));
        }
        self.proof.parts.push(Part { name, blocks: found.blocks });
        let before = std::mem::replace(&mut self.proof.ranges, Ranges::none(0));
        self.proof.ranges = before.and(found);
    }

    /// What a joint takes, as the part before it found.
    fn span(&self, id: NodeId) -> Span {
        let whole = Span::of(self.graph.nodes[id].format);
        self.proof.ranges.needed[id].filter(|&span| whole.holds(span)).unwrap_or(whole)
    }
}

/// A span of codes that are not negative by stretches of so many, each from a multiple of that number on.
fn stretches(Span { low, high }: Span, codes: i128) -> impl Iterator<Item = Span> {
    (low / codes..=high / codes)
        .map(move |row| Span { low: low.max(row * codes), high: high.min((row + 1) * codes - 1) })
}

fn outputs(graph: &Graph) -> Vec<NodeId> {
    graph.outputs.iter().map(|&(_, id)| id).collect()
}

impl Proof {
    /// Analyses the graph of a shader with these materials and joints.
    #[must_use]
    pub fn of(materials: &Shininess, joints: &[Joints], graph: &Graph, tables: &[Table]) -> Self {
        let mut prover = Prover::new(graph, tables);
        let material = graph.index();
        let whole = |id: NodeId| Span::of(graph.nodes[id].format);
        let rows =
            |others: &[Span]| by_rows(graph.nodes[material].format, others, |index| materials.row_of_index(index));
        let all: Region = graph.inputs.iter().map(|&id| whole(id)).collect();
        // The ports of vectors among the rest stay unused by the colours, and cost nothing there.
        let mut colour_ports = graph.inputs.clone();
        let mut colour_spans: Vec<Span> = all[1..].to_vec();
        for (light, joints) in joints.iter().enumerate() {
            let of_light = |part: &str| format!("{part} of light {}", light + 1);
            let mut results = vec![joints.dark, joints.psi];
            results.extend(joints.root.map_or(vec![joints.operand], |root| root.to_vec()));
            prover.part(of_light("front end"), &graph.inputs, &results, std::slice::from_ref(&all));
            if let Some(root) = joints.root {
                let region = root.map(|id| prover.span(id)).to_vec();
                prover.part(of_light("root"), &root, &[joints.operand], &[region]);
            }
            let operand = prover.span(joints.operand);
            prover.part(of_light("lobe"), &[material, joints.operand], &[joints.lobe], &rows(&[operand]));
            for joint in [joints.dark, joints.psi, joints.lobe] {
                colour_ports.push(joint);
                colour_spans.push(prover.span(joint));
            }
        }
        prover.part("colours".to_owned(), &colour_ports, &outputs(graph), &rows(&colour_spans));
        prover.finish()
    }

    /// Analyses the graph of an image-based block with these joints.
    #[must_use]
    pub fn of_image(joints: &ImageJoints, graph: &Graph, tables: &[Table]) -> Self {
        let mut prover = Prover::new(graph, tables);
        let mut region: Region = graph.inputs.iter().map(|&id| Span::of(graph.nodes[id].format)).collect();
        let mut ports = graph.inputs.clone();
        let found: Vec<NodeId> = joints.steps.iter().flat_map(|step| step.to.iter().copied()).collect();
        let mut operands: Vec<NodeId> = joints.steps.iter().flat_map(|step| step.from.iter().copied()).collect();
        operands.retain(|id| !found.contains(id));
        if !operands.is_empty() {
            let name = "operands of tables of functions".to_owned();
            prover.part(name, &ports, &operands, std::slice::from_ref(&region));
        }
        for StepJoints { from, to, row } in &joints.steps {
            let whole: Region = from.iter().map(|&id| prover.span(id)).collect();
            let of_rows = match row {
                None => vec![whole],
                Some(codes) => stretches(whole[0], *codes).map(|row| [&[row], &whole[1..]].concat()).collect(),
            };
            let name = format!("step from {}", graph.nodes[from[0]].name);
            prover.part(name, from, to, &of_rows);
            ports.extend(to);
            region.extend(to.iter().map(|&id| prover.span(id)));
        }
        let places: Vec<NodeId> = joints.places.iter().map(|joint| joint.place).collect();
        prover.part("places of the normal".to_owned(), &ports, &places, std::slice::from_ref(&region));
        for joint in &joints.places {
            let of_place = vec![prover.span(joint.place)];
            let name = format!("texels at {}", graph.nodes[joint.place].name);
            prover.part(name, &[joint.place], &joint.results(), &[of_place]);
            ports.extend(joint.results());
            region.extend(joint.results().map(|id| prover.span(id)));
        }
        prover.part("colours".to_owned(), &ports, &outputs(graph), &[region]);
        prover.finish()
    }

    /// Whether it is proved that no value overflows.
    #[must_use]
    pub fn is_safe(&self) -> bool {
        self.ranges.is_safe()
    }
}

/// What was found of a core.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SampledInspection {
    /// The core's name.
    pub core: String,
    /// The materials, where it is a shader.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rows: Option<usize>,
    /// The parts that were analysed.
    pub parts: Vec<Part>,
    /// Values that overflow where they are needed, with the inputs of the first.
    pub overflows: Vec<String>,
    /// Values of which the analysis cannot tell.
    pub undecided: Vec<String>,
    /// Inputs that were run: every one cannot be.
    pub samples: u64,
    /// Those of them whose result is another one with wider registers.
    pub wide_differences: u64,
    /// The value with the largest magnitude inside; the magnitude is a bound.
    pub largest: Signal,
    /// The widest value inside.
    pub widest: Signal,
}

impl SampledInspection {
    /// Inspects a core that is no lobe alone.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        let graph = design.function();
        let (rows, proof) = match design.block() {
            BlockDesign::Shader(ShaderDesign { lobe, joints, .. }) => {
                let set = &lobe.interface.shininess;
                (Some(set.rows()), Proof::of(set, joints, graph, design.tables()))
            }
            BlockDesign::Image(ImageDesign { joints, .. }) => (None, Proof::of_image(joints, graph, design.tables())),
            BlockDesign::Lobe(_) => unreachable!("a lobe is run through all its inputs"),
        };
        let wide = Analysis::new(graph, design.tables()).with_spare_bits(&proof.ranges);
        let differs = |place: u64| {
            let mut rng = Rng::new(place);
            let codes: Vec<i128> = design.varied(&mut rng).into_iter().map(i128::from).collect();
            let outputs = |graph: &Graph| -> Vec<i128> {
                let values = graph.values(design.tables(), &codes);
                graph.outputs.iter().map(|&(_, id)| values[id]).collect()
            };
            outputs(design.graph()) != outputs(&wide)
        };
        let names = (0..graph.nodes.len()).filter(|&id| proof.ranges.undecided[id]);
        Self {
            core: design.spec.name.clone(),
            rows,
            undecided: names.map(|id| graph.nodes[id].name.clone()).collect(),
            samples: SAMPLES,
            wide_differences: (0..SAMPLES).into_par_iter().filter(|&place| differs(place)).count() as u64,
            largest: signal(graph, &proof.ranges, |signal| signal.largest),
            widest: signal(graph, &proof.ranges, |signal| f64::from(signal.width)),
            overflows: proof.overflows.into_iter().map(|(_, what)| what).collect(),
            parts: proof.parts,
        }
    }

    /// What a core must keep and this one does not, a line each.
    #[must_use]
    pub fn broken(&self) -> Vec<String> {
        let mut broken: Vec<String> = self.overflows.iter().map(|at| format!("{at} leaves its format")).collect();
        if !self.undecided.is_empty() {
            broken.push(format!("not proved to stay in their formats: {}", self.undecided.join(", ")));
        }
        if self.wide_differences > 0 {
            broken.push(format!("{} results differ with wider registers", self.wide_differences));
        }
        broken
    }
}
