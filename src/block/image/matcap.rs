//! The operations of the form matcap: a look-up where x and y of the normal say, and no light.

use super::datapath::{Imaging, bound};
use crate::block::CHANNELS;
use crate::block::parts::{self, AXES};
use crate::datapath::graph::NodeId;
use crate::fixed::exp2;

impl Imaging<'_, '_> {
    /// The outputs: a code a channel. The normal's third component has no part in it, so that one that is turned away a
    /// little, as interpolated normals are at a silhouette, is seen as the rim is and is not black.
    pub(super) fn matcap(&mut self) -> Vec<(&'static str, NodeId)> {
        let normal = self.vector("n", &AXES[..self.image.normal_axes()]);
        let pairs = [(normal[1], "v1"), (normal[0], "u1")].map(|(component, name)| [self.side(component, name); 2]);
        let texels = self.looked_up(pairs.to_vec(), 0);
        let code = |channel: usize| {
            let root = self.root(&texels, channel);
            (parts::CODES[channel], self.shown(root, channel))
        };
        (0..3).map(code).collect()
    }

    /// The nearest code of a channel to the square of a blended code.
    fn shown(&mut self, root: NodeId, channel: usize) -> NodeId {
        let c = CHANNELS[channel];
        let (channel_bits, kept, square) = (self.image.channel_bits, self.widths.code, self.widths.square);
        let mut root = root;
        for (bits, number) in self.image.fills().zip(1..) {
            let by = -(bits as i32);
            let part = self.b.scale(root, None, by, &[by], &format!("fill{number}_{c}_exact"), "its part");
            let part = self.b.floor(part, kept, &format!("fill{number}_{c}"), "rounded down");
            let what = format!("plus 2^{by} of it, so that the greatest code is nearer to 1");
            root = self.b.add(root, part, &format!("filled{number}_{c}"), &what);
        }
        let squared = self.b.mul(root, root, &format!("square_{c}_exact"), "its square");
        let squared = self.b.floor(squared, square, &format!("square_{c}"), "rounded down");
        let by = -(channel_bits as i32);
        let part = self.b.scale(squared, None, by, &[by], &format!("last_{c}_exact"), "in parts of full scale");
        let part = self.b.floor(part, square, &format!("last_{c}"), "rounded down");
        let shown = self.b.sub(squared, part, &format!("shown_{c}"), "full scale is the greatest code");
        // A part of what it is taken from.
        self.b.narrow(shown, vec![bound(0.0, 1.0 - exp2(by), square)]);
        parts::channel_code(&mut self.b, shown, channel, channel_bits)
    }
}
