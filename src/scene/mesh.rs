//! Triangle meshes.

use crate::design::sample::Vector;

/// A triangle mesh with a normal at each corner.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The places of the vertices.
    pub positions: Vec<Vector>,
    /// The normals, unit vectors.
    pub normals: Vec<Vector>,
    /// The triangles: for each corner the place of its position and of its normal.
    pub triangles: Vec<[Corner; 3]>,
    /// How many triangles of the file were left out because they have no area.
    pub dropped: usize,
}

/// A corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Its place in [`Mesh::positions`].
    pub position: u32,
    /// Its place in [`Mesh::normals`].
    pub normal: u32,
}
