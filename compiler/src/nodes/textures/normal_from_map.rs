use crate::emit::functions::bent_normal::mapped;
use crate::emit::{Mask, Real};
use crate::nodes::{node, state};
use crate::state::Field;

node! {
    /// The normal of a map in tangent space: `tangent x + bitangent y + normal z` at unit length, where x, y and z are `2 map -
    /// 1`, x and y times `scale`. A map of nothing, all zero, is flat. The frame is taken as it is: it should be of unit vectors.
    /// `normal_map` evaluates a graph under such a normal, and keeps it above the surface.
    normal_from_map in textures,
    source "MaterialX 1.39, normalmap",
    inputs {
        /// The map, its numbers as they are in the file: 0 to 1.
        map: vector = [0.5, 0.5, 1.0], in -1e9..=1e9;
        /// Factor on the parts along the surface.
        scale: scalar = 1.0, in -1e9..=1e9, soft 0.0..=2.0;
        /// The way of u.
        tangent: vector = node("frame_from_derivatives"), in -1e9..=1e9;
        /// The way of v; where it is zero, normal × tangent.
        bitangent: vector = [0.0; 3], in -1e9..=1e9;
        /// The normal outside.
        normal: vector = state(Field::Normal), in -1e9..=1e9;
    }
    outputs {
        /// The bent normal; zero if the frame is.
        normal: vector, in -1.0..=1.0;
    }
    body |e, i| {
        let implied = i.bitangent.largest().equal(e.real(0.0));
        let bitangent = implied.select(i.normal.cross(i.tangent), i.bitangent);
        Outputs { normal: mapped(i.map, i.scale, (i.tangent, bitangent, i.normal)).normalized() }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    /// Computed with MaterialX 1.39.5, in frames that are none.
    #[test]
    fn is_the_normal_of_materialx() {
        let normal = numbers!(
            map = [-2.45658, 0.43431, 1.89075], scale = -0.880952,
            normal = [-2.04058, -0.317274, -0.0227918], tangent = [0.00732961, 2.92199, 0.00771332],
            bitangent = [-1.20251, 1.41321, 2.81811] => normal
        );
        assert_close(&normal, &[-0.369_991_869, 0.928_832_293, 0.019_403_033], 2e-6, 2e-7);
        let normal = numbers!(
            map = [-0.16764, -1.15107, -1.30638], scale = 0.473472,
            normal = [-1.85509, -2.36318, -2.79529], tangent = [-2.2392, 1.01425, -1.91138],
            bitangent = [-2.2154, -2.1139, -2.20639] => normal
        );
        assert_close(&normal, &[0.530_074, 0.512_682_796, 0.675_409_496], 2e-6, 2e-7);
    }

    #[test]
    fn nothing_is_flat_and_the_bitangent_may_be_left_out() {
        let (normal, tangent) = ([0.0, 0.6, 0.8], [1.0, 0.0, 0.0]);
        let flat = numbers!(map = [0.0; 3], normal = normal, tangent = tangent => normal);
        assert_close(&flat, &[0.0, 0.6, 0.8], 1e-6, 0.0);
        let bent = numbers!(map = [0.5, 0.8, 0.9], normal = normal, tangent = tangent => normal);
        assert_close(&bent, &[0.0, 0.48 + 0.48, 0.64 - 0.36], 1e-6, 1e-6);
        assert_eq!(numbers!(normal = [0.0; 3], tangent = [0.0; 3] => normal), [0.0; 3]);
    }
}
