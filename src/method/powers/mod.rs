//! The lobes that end in a power by squarings, for the methods that do.

pub(super) mod datapath;
pub(super) mod model;
