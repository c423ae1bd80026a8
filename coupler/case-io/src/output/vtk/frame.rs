//! Reads back the VTU and VTP files this module writes, for pictures and checks.

use std::path::Path;

use super::collection::attribute;
use super::document::unescape;
use crate::output::{OutputError, read_file};

/// A frame as it lies on disk: points, simplices and fields.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Frame {
    /// Positions \[m\].
    pub points: Vec<[f64; 3]>,
    /// Node numbers of the triangles.
    pub triangles: Vec<[u32; 3]>,
    /// Node numbers of the tetrahedra.
    pub tetrahedra: Vec<[u32; 4]>,
    /// Fields with one row per point.
    pub point_fields: Vec<FrameField>,
    /// Fields with one row per cell.
    pub cell_fields: Vec<FrameField>,
}

/// One field of a [`Frame`].
#[derive(Debug, Clone, PartialEq)]
pub struct FrameField {
    /// Its name.
    pub name: String,
    /// Numbers per row.
    pub components: usize,
    /// Row-major rows.
    pub values: Vec<f64>,
}

impl FrameField {
    /// Euclidean norm of every row: the absolute value of a scalar, the length of a vector.
    pub fn magnitudes(&self) -> Vec<f64> {
        let norm = |row: &[f64]| row.iter().map(|x| x * x).sum::<f64>().sqrt();
        self.values.chunks_exact(self.components).map(norm).collect()
    }
}

impl Frame {
    /// Reads a `.vtu` or `.vtp` file written by this crate.
    ///
    /// # Errors
    /// The file cannot be read, is cut off, or is not in the raw appended form.
    pub fn read(path: &Path) -> Result<Self, OutputError> {
        let bytes = read_file(path)?;
        parse(&bytes).map_err(|fault| OutputError::Malformed {
            place: path.display().to_string(),
            what: fault.what,
            found: fault.found,
            expected: fault.expected,
            advice: "delete the frame; the run or `coupler resume` writes it anew",
        })
    }

    /// The point field of that name.
    pub fn point_field(&self, name: &str) -> Option<&FrameField> {
        self.point_fields.iter().find(|field| field.name == name)
    }
}

struct Fault {
    what: String,
    found: String,
    expected: String,
}

fn fault(what: impl Into<String>, found: impl ToString, expected: impl ToString) -> Fault {
    Fault { what: what.into(), found: found.to_string(), expected: expected.to_string() }
}

/// The number types this crate writes.
#[derive(Clone, Copy)]
enum Number {
    F32,
    F64,
    U64,
    I64,
    U8,
}

fn parse(bytes: &[u8]) -> Result<Frame, Fault> {
    const MARK: &[u8] = b"<AppendedData encoding=\"raw\">\n_";
    let head = bytes
        .windows(MARK.len())
        .position(|window| window == MARK)
        .ok_or_else(|| fault("appended data", "none", "<AppendedData encoding=\"raw\">"))?;
    let appended = &bytes[head + MARK.len()..];
    let text = String::from_utf8_lossy(&bytes[..head]);
    let compressed = text.contains("compressor=\"vtkLZ4DataCompressor\"");

    let mut frame = Frame::default();
    let (mut connectivity, mut ends, mut types) = (Vec::new(), Vec::new(), Vec::new());
    let mut section = "";
    for line in text.lines() {
        if !line.starts_with("<DataArray ") {
            section = line.trim_matches(['<', '>']);
            continue;
        }
        let name = attribute(line, "Name").map(unescape).unwrap_or_default();
        let (values, components) = array(line, &name, appended, compressed)?;
        match (section, name.as_str()) {
            ("Points", _) => frame.points = values.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect(),
            ("Cells", "connectivity") => connectivity = values,
            ("Cells", "offsets") => ends = values,
            ("Cells", "types") => types = values,
            ("PointData", _) => frame.point_fields.push(FrameField { name, components, values }),
            ("CellData", _) => frame.cell_fields.push(FrameField { name, components, values }),
            _ => {}
        }
    }
    for field in &frame.point_fields {
        let rows = field.values.len() / field.components;
        if rows != frame.points.len() {
            return Err(fault(format!("rows of the field {:?}", field.name), rows, frame.points.len()));
        }
    }
    sort_cells(&mut frame, &connectivity, &ends, &types)?;
    Ok(frame)
}

fn sort_cells(frame: &mut Frame, connectivity: &[f64], ends: &[f64], types: &[f64]) -> Result<(), Fault> {
    let nodes = frame.points.len();
    if let Some(node) = connectivity.iter().find(|&&node| !(0.0..nodes as f64).contains(&node)) {
        return Err(fault("node number of a cell", node, format!("0 to {nodes}, excluded")));
    }
    let mut begin = 0;
    for (&end, &kind) in ends.iter().zip(types) {
        let row = connectivity.get(begin..end as usize).ok_or_else(|| {
            fault("offsets of the cells", end, format!("{begin} to {}", connectivity.len()))
        })?;
        match *row {
            [a, b, c] if kind == 5.0 => frame.triangles.push([a, b, c].map(|node| node as u32)),
            [a, b, c, d] if kind == 10.0 => frame.tetrahedra.push([a, b, c, d].map(|node| node as u32)),
            _ => {}
        }
        begin = end as usize;
    }
    Ok(())
}

/// The values of one array and its numbers per row.
fn array(line: &str, name: &str, appended: &[u8], compressed: bool) -> Result<(Vec<f64>, usize), Fault> {
    let number = match attribute(line, "type") {
        Some("Float32") => Number::F32,
        Some("Float64") => Number::F64,
        Some("UInt64") => Number::U64,
        Some("Int64") => Number::I64,
        Some("UInt8") => Number::U8,
        other => {
            return Err(fault(
                format!("type of the array {name:?}"),
                other.unwrap_or("none"),
                "Float32, Float64, Int64, UInt64 or UInt8",
            ));
        }
    };
    let components = attribute(line, "NumberOfComponents").and_then(|count| count.parse().ok()).unwrap_or(0);
    let values = attribute(line, "offset")
        .and_then(|offset| appended.get(offset.parse::<usize>().ok()?..))
        .and_then(|data| if compressed { unpack(data) } else { raw(data).map(<[u8]>::to_vec) })
        .map(|data| numbers(&data, number))
        .ok_or_else(|| fault(format!("data of the array {name:?}"), "cut off or damaged", "a whole array"))?;
    if components == 0 || values.len() % components != 0 {
        return Err(fault(
            format!("size of the array {name:?}"),
            values.len(),
            format!("whole rows of {components}"),
        ));
    }
    Ok((values, components))
}

fn word(data: &[u8], index: usize) -> Option<usize> {
    let bytes = data.get(8 * index..8 * index + 8)?;
    usize::try_from(u64::from_le_bytes(bytes.try_into().ok()?)).ok()
}

fn raw(data: &[u8]) -> Option<&[u8]> {
    data.get(8..)?.get(..word(data, 0)?)
}

fn unpack(data: &[u8]) -> Option<Vec<u8>> {
    let (blocks, size, partial) = (word(data, 0)?, word(data, 1)?, word(data, 2)?);
    let mut begin = blocks.checked_add(3)?.checked_mul(8)?;
    let mut values = Vec::new();
    for block in 0..blocks {
        let packed = data.get(begin..begin.checked_add(word(data, 3 + block)?)?)?;
        let expected = if block + 1 == blocks && partial > 0 { partial } else { size };
        // LZ4 cannot pack 255 bytes into less than one: refuse a damaged size before it is allocated.
        if expected > 255 * (packed.len() + 1) {
            return None;
        }
        values.extend(
            lz4_flex::block::decompress(packed, expected).ok().filter(|block| block.len() == expected)?,
        );
        begin += packed.len();
    }
    Some(values)
}

fn numbers(data: &[u8], number: Number) -> Vec<f64> {
    fn each<const WIDTH: usize>(data: &[u8], decode: impl Fn([u8; WIDTH]) -> f64) -> Vec<f64> {
        data.as_chunks::<WIDTH>().0.iter().map(|&bytes| decode(bytes)).collect()
    }
    match number {
        Number::F32 => each(data, |bytes| f64::from(f32::from_le_bytes(bytes))),
        Number::F64 => each(data, f64::from_le_bytes),
        Number::U64 => each(data, |bytes| u64::from_le_bytes(bytes) as f64),
        Number::I64 => each(data, |bytes| i64::from_le_bytes(bytes) as f64),
        Number::U8 => each(data, |[byte]| f64::from(byte)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Compression, Field, Format, GrainPoints, Precision, UnstructuredGrid};
    use super::*;
    use crate::output::test_directory::TestDirectory;
    use std::fs;

    const FORMATS: [Format; 4] = [
        Format { precision: Precision::Double, compression: Compression::None },
        Format { precision: Precision::Double, compression: Compression::Lz4 },
        Format { precision: Precision::Single, compression: Compression::None },
        Format { precision: Precision::Single, compression: Compression::Lz4 },
    ];

    #[test]
    fn a_small_file_is_written_byte_for_byte_as_the_format_says() {
        let directory = TestDirectory::new();
        let path = directory.path("one.vtp");
        let format = FORMATS[0];
        GrainPoints { centres: &[[1.0, 2.0]], fields: &[Field::whole("id", &[9])] }
            .write(&path, format)
            .unwrap();
        let head = "<?xml version=\"1.0\"?>\n\
            <VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
            <PolyData>\n\
            <Piece NumberOfPoints=\"1\" NumberOfVerts=\"1\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n\
            <Points>\n\
            <DataArray type=\"Float64\" Name=\"points\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/>\n\
            </Points>\n\
            <Verts>\n\
            <DataArray type=\"Int64\" Name=\"connectivity\" NumberOfComponents=\"1\" format=\"appended\" offset=\"32\"/>\n\
            <DataArray type=\"Int64\" Name=\"offsets\" NumberOfComponents=\"1\" format=\"appended\" offset=\"48\"/>\n\
            </Verts>\n\
            <PointData>\n\
            <DataArray type=\"UInt64\" Name=\"id\" NumberOfComponents=\"1\" format=\"appended\" offset=\"64\"/>\n\
            </PointData>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
        let mut expected = head.as_bytes().to_vec();
        expected.extend(24u64.to_le_bytes());
        [1.0f64, 2.0, 0.0].iter().for_each(|x| expected.extend(x.to_le_bytes()));
        for value in [0u64, 1, 9] {
            expected.extend(8u64.to_le_bytes());
            expected.extend(value.to_le_bytes());
        }
        expected.extend(b"\n</AppendedData>\n</VTKFile>\n");
        assert_eq!(fs::read(&path).unwrap(), expected);
    }

    #[test]
    fn a_tetrahedral_grid_reads_back_in_every_format() {
        let directory = TestDirectory::new();
        let path = directory.path("fluid.vtu");
        // Many nodes, so that several LZ4 blocks and a partial last one are written.
        let points: Vec<[f64; 3]> = (0..50_001).map(|i| [f64::from(i), 0.5, -f64::from(i)]).collect();
        let cells: Vec<[u32; 4]> = (0..49_998).map(|i| [i, i + 1, i + 2, i + 3]).collect();
        let pressure: Vec<f64> = (0..points.len()).map(|i| 0.25 * i as f64).collect();
        let volume = vec![1.5; cells.len()];
        for format in FORMATS {
            UnstructuredGrid {
                points: &points,
                cells: &cells,
                point_fields: &[Field::scalar("pressure", &pressure), Field::vector("velocity", &points)],
                cell_fields: &[Field::scalar("volume", &volume)],
            }
            .write(&path, format)
            .unwrap();
            let frame = Frame::read(&path).unwrap();
            assert!(frame.points == points && frame.tetrahedra == cells, "{format:?}");
            assert!(frame.point_field("pressure").unwrap().values == pressure, "{format:?}");
            assert!(frame.point_field("velocity").unwrap().values == points.as_flattened(), "{format:?}");
            assert!(frame.cell_fields[0].values == volume, "{format:?}");
        }
    }

    #[test]
    fn plane_triangles_and_non_finite_values_read_back() {
        let directory = TestDirectory::new();
        let path = directory.path("fluid.vtu");
        let field = [f64::NAN, f64::INFINITY, -0.0];
        UnstructuredGrid {
            points: &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            cells: &[[0, 1, 2]],
            point_fields: &[Field::scalar("a<b", &field)],
            cell_fields: &[],
        }
        .write(&path, Format::default())
        .unwrap();
        let frame = Frame::read(&path).unwrap();
        assert_eq!(frame.points[1], [1.0, 0.0, 0.0]);
        assert_eq!(frame.triangles, [[0, 1, 2]]);
        let values = &frame.point_field("a<b").unwrap().values;
        assert!(values[0].is_nan() && values[1] == f64::INFINITY && values[2] == 0.0);
    }

    #[test]
    fn no_grains_make_a_valid_empty_frame() {
        let directory = TestDirectory::new();
        let path = directory.path("grains.vtp");
        for format in FORMATS {
            GrainPoints::<3> { centres: &[], fields: &[Field::scalar("radius", &[])] }
                .write(&path, format)
                .unwrap();
            let frame = Frame::read(&path).unwrap();
            assert!(frame.points.is_empty() && frame.point_field("radius").unwrap().values.is_empty());
        }
    }

    #[test]
    fn data_that_do_not_belong_together_are_refused() {
        let directory = TestDirectory::new();
        let path = directory.path("bad.vtu");
        let write = |cells: &[[u32; 3]], fields: &[Field]| {
            let points = &[[0.0, 0.0]; 3];
            UnstructuredGrid { points, cells, point_fields: fields, cell_fields: &[] }
                .write(&path, Format::default())
                .unwrap_err()
                .to_string()
        };
        let error = write(&[[0, 1, 2], [0, 3, 1]], &[]);
        assert!(error.contains("cell 1") && error.contains("found 3"), "{error}");
        let error = write(&[[0, 1, 2]], &[Field::scalar("p", &[1.0])]);
        assert!(error.contains("\"p\"") && error.contains("found 1, expected 3"), "{error}");
        let error = write(&[], &[Field::scalar("p", &[1.0; 3]), Field::scalar("p", &[1.0; 3])]);
        assert!(error.contains("twice"), "{error}");
        assert!(!path.exists());
    }

    #[test]
    fn a_frame_cut_anywhere_is_refused_without_a_panic() {
        let directory = TestDirectory::new();
        let path = directory.path("grains.vtp");
        for format in FORMATS {
            GrainPoints { centres: &[[1.0, 2.0, 3.0]; 20], fields: &[] }.write(&path, format).unwrap();
            let whole = fs::read(&path).unwrap();
            let tail = "\n</AppendedData>\n</VTKFile>\n".len();
            for length in (0..whole.len() - tail).step_by(7) {
                fs::write(&path, &whole[..length]).unwrap();
                assert!(Frame::read(&path).is_err(), "{length} of {} bytes", whole.len());
            }
        }
    }

    #[test]
    fn a_flipped_bit_never_panics() {
        let directory = TestDirectory::new();
        let path = directory.path("fluid.vtu");
        UnstructuredGrid {
            points: &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            cells: &[[0, 1, 2]],
            point_fields: &[Field::scalar("p", &[1.0, 2.0, 3.0])],
            cell_fields: &[],
        }
        .write(&path, Format::default())
        .unwrap();
        let whole = fs::read(&path).unwrap();
        let mut refused = 0;
        for bit in (0..whole.len() * 8).step_by(5) {
            let mut damaged = whole.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            refused += usize::from(parse(&damaged).is_err());
        }
        assert!(refused > 0);
    }
}
