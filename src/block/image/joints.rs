//! Where the parts of an image-based block's datapath meet: what its checks go by.

use crate::datapath::graph::NodeId;

/// Values of a datapath that its checks go by.
#[derive(Clone, Debug, Default)]
pub struct Joints {
    /// Of the values that a light's tables of functions are read with, and of what is kept in bounds by a relation
    /// between the fields of a row: each after those that it goes on from.
    pub steps: Vec<StepJoints>,
    /// Of all lights' directions among the texels.
    pub places: Vec<PlaceJoints>,
    /// Of each light.
    pub lights: Vec<LightJoints>,
}

/// A part of a datapath in which few values go in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepJoints {
    /// What goes in.
    pub from: Vec<NodeId>,
    /// What comes out and depends on that alone.
    pub to: Vec<NodeId>,
    /// The codes of the first that lead to one row of a table, where what comes out is known row by row alone.
    pub row: Option<i128>,
}

/// The factors of what a light gives.
#[derive(Clone, Copy, Debug)]
pub struct LightJoints {
    /// n·l times two to the power of the shift; none where the texels hold n·l.
    pub incidence: Option<NodeId>,
    /// The squared blend of a channel; where the texels hold n·l, times two to the power of the shift.
    pub squares: [NodeId; 3],
    /// What a light's intensities are multiplied by for its gains, where it is told by these.
    pub full_gain: Option<NodeId>,
}

/// Where the parts of a datapath meet in which a light's texels are sought in one direction.
#[derive(Clone, Copy, Debug)]
pub struct PlaceJoints {
    /// Where the normal lies among the texels, from the first to the last of them; in the form bivariate as 1 - n·h.
    pub place: NodeId,
    /// The addresses of the even and of the odd ones of both that are blended.
    pub addresses: [NodeId; 2],
    /// Whether the one at or below the place is the odd one, and the weight of the next.
    pub weight: [NodeId; 2],
}

impl PlaceJoints {
    /// What is computed from the place.
    #[must_use]
    pub fn results(&self) -> [NodeId; 4] {
        let ([even, odd], [is_odd, weight]) = (self.addresses, self.weight);
        [even, odd, is_odd, weight]
    }
}

impl Joints {
    pub(super) fn nodes(&mut self) -> impl Iterator<Item = &mut NodeId> {
        let places = self.places.iter_mut().flat_map(|joints| {
            let PlaceJoints { place, addresses, weight } = joints;
            [place].into_iter().chain(addresses).chain(weight)
        });
        let lights = self.lights.iter_mut().flat_map(|joints| {
            let LightJoints { incidence, squares, full_gain } = joints;
            incidence.iter_mut().chain(squares).chain(full_gain)
        });
        let steps = self.steps.iter_mut().flat_map(|StepJoints { from, to, .. }| from.iter_mut().chain(to));
        steps.chain(places).chain(lights)
    }
}
