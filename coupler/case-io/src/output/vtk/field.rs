//! Named values on points or cells.

/// Width of the numbers of a field on disk. Positions are always f64.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Precision {
    /// f32: enough for pictures, half the size.
    #[default]
    Single,
    /// f64: the values of the run, bit for bit.
    Double,
}

/// One named field, borrowed from the solver: a value per point or per cell.
#[derive(Debug, Clone, Copy)]
pub struct Field<'a> {
    pub(super) name: &'a str,
    pub(super) values: Values<'a>,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Values<'a> {
    /// Row-major rows of `components` numbers each.
    Real {
        flat: &'a [f64],
        components: usize,
    },
    Whole(&'a [u64]),
}

impl<'a> Field<'a> {
    /// A number per point or cell.
    pub fn scalar(name: &'a str, values: &'a [f64]) -> Self {
        Self { name, values: Values::Real { flat: values, components: 1 } }
    }

    /// A vector per point or cell; in 2D a zero third component is added on disk, as VTK wants three.
    pub fn vector<const D: usize>(name: &'a str, values: &'a [[f64; D]]) -> Self {
        const { assert!(D == 2 || D == 3) }
        Self { name, values: Values::Real { flat: values.as_flattened(), components: D } }
    }

    /// An identity or a count per point or cell.
    pub fn whole(name: &'a str, values: &'a [u64]) -> Self {
        Self { name, values: Values::Whole(values) }
    }

    /// Number of rows.
    pub(super) fn len(&self) -> usize {
        match self.values {
            Values::Real { flat, components } => flat.len() / components,
            Values::Whole(values) => values.len(),
        }
    }

    /// Components of a row on disk: 1 or 3.
    pub(super) fn components_on_disk(&self) -> usize {
        match self.values {
            Values::Real { components: 2.., .. } => 3,
            _ => 1,
        }
    }

    /// VTK's name for the number type on disk.
    pub(super) fn type_on_disk(&self, precision: Precision) -> &'static str {
        match (self.values, precision) {
            (Values::Whole(_), _) => "UInt64",
            (_, Precision::Single) => "Float32",
            (_, Precision::Double) => "Float64",
        }
    }

    /// The bytes on disk, uncompressed.
    pub(super) fn bytes(&self, precision: Precision) -> Vec<u8> {
        match self.values {
            Values::Whole(values) => bytemuck::cast_slice(values).to_vec(),
            Values::Real { flat, components } => match precision {
                Precision::Double => real_bytes(flat, components, f64::to_le_bytes),
                Precision::Single => real_bytes(flat, components, |value| (value as f32).to_le_bytes()),
            },
        }
    }
}

/// Positions of points: f64, three components.
pub(super) fn position_bytes<const D: usize>(points: &[[f64; D]]) -> Vec<u8> {
    real_bytes(points.as_flattened(), D, f64::to_le_bytes)
}

fn real_bytes<const WIDTH: usize>(
    flat: &[f64],
    components: usize,
    encode: impl Fn(f64) -> [u8; WIDTH],
) -> Vec<u8> {
    let padding = usize::from(components == 2);
    let rows = flat.len() / components;
    let mut bytes = Vec::with_capacity(rows * (components + padding) * WIDTH);
    for row in flat.chunks_exact(components) {
        for &value in row {
            bytes.extend_from_slice(&encode(value));
        }
        for _ in 0..padding {
            bytes.extend_from_slice(&encode(0.0));
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_vector_gets_a_zero_third_component() {
        let field = Field::vector("velocity", &[[1.0, 2.0], [3.0, 4.0]]);
        let bytes = field.bytes(Precision::Double);
        let values: Vec<f64> = bytes.as_chunks().0.iter().copied().map(f64::from_le_bytes).collect();
        assert_eq!(values, [1.0, 2.0, 0.0, 3.0, 4.0, 0.0]);
        assert_eq!((field.len(), field.components_on_disk()), (2, 3));
    }

    #[test]
    fn whole_numbers_keep_all_their_bits() {
        let field = Field::whole("id", &[u64::MAX, (1 << 53) + 1]);
        let bytes = field.bytes(Precision::Single);
        let values: Vec<u64> = bytes.as_chunks().0.iter().copied().map(u64::from_le_bytes).collect();
        assert_eq!(values, [u64::MAX, (1 << 53) + 1]);
    }
}
