use crate::emit::functions::frames::tangent_along;
use crate::nodes::finite::SUMMAND;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// The frame of a surface that was brushed: the tangent is the direction of the brush, laid into the
    /// surface. Brushed along a direction it is that direction; around an axis, as what was turned on a
    /// lathe, it is `axis × (point - center)`; outwards it runs from the centre to the point. Where that
    /// stands on the surface, any tangent will do: that of `frame_from_normal`.
    frame_from_direction in frames,
    source "Hofmann, the shader anisoBrdf; Blender manual, Tangent Node, radial",
    inputs {
        /// How it was brushed.
        brush: choice = 0, of ["along", "around", "outwards"];
        /// The direction, or the axis; of any length.
        direction: vector = [0.0, 1.0, 0.0], when e.mask(i.brush != 2);
        /// A point of the axis, or what it was brushed outwards from; scene units.
        center: vector = [0.0; 3], in SUMMAND, when e.mask(i.brush != 0), unit "scene units";
        /// The point that is shaded, in the space of the centre.
        point: vector = state(Field::Point), in SUMMAND, when e.mask(i.brush != 0);
        /// Shading normal.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
    }
    outputs {
        /// Along the brush, at right angles to the normal, unit length.
        tangent: vector, in -1.0..=1.0;
        /// At right angles to both, unit length.
        bitangent: vector, in -1.0..=1.0;
        /// The normal at unit length.
        normal: vector, in -1.0..=1.0;
    }
    body |e, i| {
        let normal = i.normal.normalized();
        let along = match i.brush {
            0 => i.direction,
            1 => i.direction.normalized().cross((i.point - i.center).normalized()),
            _ => i.point - i.center,
        };
        let tangent = tangent_along(along, normal);
        Outputs { tangent, bitangent: normal.cross(tangent).normalized(), normal }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    const UP: [f32; 3] = [0.0, 1.0, 0.0];

    #[test]
    fn a_disc_is_brushed_in_three_ways() {
        let point = [3.0, 0.0, 4.0];
        for (brush, expected) in
            [(0, [0.6, 0.0, -0.8]), (1, [0.8, 0.0, -0.6]), (2, [0.6, 0.0, 0.8])]
        {
            let direction = if brush == 0 { [3.0, 5.0, -4.0] } else { UP };
            let tangent = numbers!(brush = brush, direction = direction, point = point, normal = UP => tangent);
            assert_close(&tangent, &expected, 3e-7, 1e-7);
        }
        let moved =
            numbers!(brush = 2, center = [3.0, 7.0, 3.0], point = point, normal = UP => tangent);
        assert_close(&moved, &[0.0, 0.0, 1.0], 3e-7, 1e-7);
    }

    #[test]
    fn on_the_axis_there_is_a_tangent_too() {
        for brush in [0, 1, 2] {
            let tangent = numbers!(brush = brush, point = [0.0; 3], normal = UP => tangent);
            let length: f32 = tangent.iter().map(|x| x * x).sum();
            assert!((length - 1.0).abs() < 1e-6 && tangent[1].abs() < 1e-7, "{tangent:?}");
        }
    }

    #[test]
    fn only_what_counts_is_asked_for() {
        for (brush, direction) in [(0, true), (1, true), (2, false)] {
            assert_eq!(demanded!(brush = brush => direction), direction);
            assert_eq!(demanded!(brush = brush => point), brush != 0);
        }
    }
}
