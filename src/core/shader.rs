//! The shader that a core is.

use std::ops::Deref;

use super::lights::{code_meanings, sum_meanings};
use super::{Design, LobeDesign};
use crate::block::shader::ShaderModel;
use crate::block::shader::datapath::Joints;
use crate::method::Material;
use crate::spec::{Cosine, LightColours, Shader, Shininess};

/// A shader with its lobe; what is the whole core's is reached through it.
#[derive(Clone, Copy, Debug)]
pub struct ShaderDesign<'a> {
    /// Its lobe.
    pub lobe: LobeDesign<'a>,
    /// What was asked for of it.
    pub shader: &'a Shader,
    /// The joints of its lights, in their order.
    pub joints: &'a [Joints],
}

impl Deref for ShaderDesign<'_> {
    type Target = Design;

    fn deref(&self) -> &Design {
        &self.lobe
    }
}

impl<'a> ShaderDesign<'a> {
    /// The core that it is.
    #[must_use]
    pub fn core(self) -> &'a Design {
        self.lobe.core()
    }

    /// The bit-exact reference.
    #[must_use]
    pub fn model(self) -> ShaderModel<'a> {
        ShaderModel::new(self.lobe.interface, self.shader, self.lobe.model(), self.core().tables())
    }

    /// Its materials, in the order of the set.
    ///
    /// # Panics
    /// Never: a spec of a shader has materials.
    #[must_use]
    pub fn materials(self) -> &'a [Material] {
        match &self.lobe.interface.shininess {
            Shininess::Materials(materials) => materials,
            _ => unreachable!("a shader serves materials"),
        }
    }

    /// The material that a code of the first input port selects.
    #[must_use]
    pub fn material(self, index: u32) -> &'a Material {
        &self.materials()[self.lobe.interface.shininess.row_of_index(index)]
    }

    /// What each input port that carries numbers is for, in the order in which the ports are made.
    pub(super) fn input_meanings(self) -> Vec<String> {
        let vector = |of: &str| ["x", "y", "z"].map(|axis| format!("{axis} of {of}"));
        let last = self.materials().len() - 1;
        let mut meanings = vec![format!("index of the material, 0 to {last}; above: the last")];
        meanings.extend(vector("the normal N, of unit length"));
        if self.shader.cosine != Cosine::Half {
            meanings.extend(vector("the unit vector V to the viewer"));
        }
        for light in 1..=self.shader.lights {
            meanings.extend(vector(&format!("the unit vector L to light {light}")));
            if self.shader.cosine == Cosine::Half {
                meanings.extend(vector(&format!("the unit half vector H of light {light}")));
            }
            if self.shader.light_colours == LightColours::Ports {
                let full = self.shader.full_scale();
                let of = |colour| format!("{colour} of light {light}; {full} is full scale");
                meanings.extend(["red", "green", "blue"].map(of));
            }
        }
        meanings
    }

    /// What each output port that carries numbers is for, in order.
    pub(super) fn output_meanings(self) -> Vec<String> {
        match self.shader.sums(self.lobe.interface) {
            Some(sums) => sum_meanings(&sums),
            None => code_meanings(self.shader.channel_bits),
        }
    }
}
