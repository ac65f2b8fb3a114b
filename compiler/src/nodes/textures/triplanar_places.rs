use crate::emit::functions::placing::place;
use crate::nodes::finite::SUMMAND;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Where three pictures are read that are thrown along the three axes: as vectors whose z is 0. One lookup
    /// for each, and `triplanar_blend` of the three, wrap a surface without coordinates. With y up, the one
    /// along x is read at (z, y), along y at (x, z), along z at (x, y); with x up at (z, y), (z, x) and
    /// (-y, x); with z up at (y, z), (x, z) and (x, y).
    triplanar_places in textures,
    source "MaterialX 1.39, triplanarprojection: upaxis",
    inputs {
        /// What the pictures fall on.
        position: vector = state(Field::Point), in SUMMAND;
        /// Which axis is upwards in the pictures. MaterialX counts them from 0, and takes z where nothing is said.
        up: choice = 1, of ["x", "y", "z"];
    }
    outputs {
        /// Along the x axis.
        along_x: vector;
        /// Along the y axis.
        along_y: vector;
        /// Along the z axis.
        along_z: vector;
    }
    body |e, i| {
        let (x, y, z) = (i.position.x, i.position.y, i.position.z);
        Outputs {
            along_x: if i.up == 2 { place(y, z) } else { place(z, y) },
            along_y: if i.up == 0 { place(z, x) } else { place(x, z) },
            along_z: if i.up == 0 { place(-y, x) } else { place(x, y) },
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn each_axis_has_its_plane() {
        let at = [1.0, 2.0, 3.0];
        let places = |up: i32| {
            [
                numbers!(position = at, up = up => along_x),
                numbers!(position = at, up = up => along_y),
                numbers!(position = at, up = up => along_z),
            ]
        };
        assert_eq!(places(0), [[3.0, 2.0, 0.0], [3.0, 1.0, 0.0], [-2.0, 1.0, 0.0]]);
        assert_eq!(places(1), [[3.0, 2.0, 0.0], [1.0, 3.0, 0.0], [1.0, 2.0, 0.0]]);
        assert_eq!(places(2), [[2.0, 3.0, 0.0], [1.0, 3.0, 0.0], [1.0, 2.0, 0.0]]);
    }
}
