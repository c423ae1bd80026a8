//! STL, ASCII and binary.

use super::Triangle;
use crate::flaw::Flaw;

const HEADER: usize = 80;
const RECORD: usize = 50;

/// The triangles of an STL file, in its own unit.
pub(super) fn parse(bytes: &[u8]) -> Result<Vec<Triangle>, Flaw> {
    if is_ascii(bytes) { parse_ascii(bytes) } else { parse_binary(bytes) }
}

/// A binary file may begin with "solid" too; only an ASCII one has words and no zero byte after it.
fn is_ascii(bytes: &[u8]) -> bool {
    bytes.trim_ascii_start().starts_with(b"solid") && !bytes.contains(&0)
}

fn parse_ascii(bytes: &[u8]) -> Result<Vec<Triangle>, Flaw> {
    let text = std::str::from_utf8(bytes).map_err(|_| Flaw::whole("is neither text nor binary STL"))?;
    let (mut triangles, mut vertices, mut ended) = (Vec::new(), Vec::new(), false);
    for (index, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("vertex") => {
                let numbers: Vec<f64> = words.map_while(|word| word.parse().ok()).collect();
                let vertex = numbers.try_into().map_err(|_| {
                    Flaw::at(index + 1, format!("{:?} is not a vertex; write \"vertex x y z\"", line.trim()))
                })?;
                vertices.push(vertex);
            }
            Some("endfacet") => {
                let count = vertices.len();
                let triangle = std::mem::take(&mut vertices).try_into().map_err(|_| {
                    Flaw::at(index + 1, format!("a facet of {count} vertices; STL has triangles only"))
                })?;
                triangles.push(triangle);
            }
            Some("endsolid") => ended = true,
            _ => {}
        }
    }
    if ended {
        Ok(triangles)
    } else {
        Err(Flaw::whole("ends without \"endsolid\"; it was cut short, write it again"))
    }
}

fn parse_binary(bytes: &[u8]) -> Result<Vec<Triangle>, Flaw> {
    let Some(count) = bytes.get(HEADER..HEADER + 4) else {
        return Err(Flaw::whole(format!("is {} bytes long; even an empty binary STL has 84", bytes.len())));
    };
    let count = u32::from_le_bytes([count[0], count[1], count[2], count[3]]) as usize;
    let records = &bytes[HEADER + 4..];
    let (found, announced) = (records.len(), count.saturating_mul(RECORD));
    if found < announced {
        return Err(Flaw::whole(format!(
            "announces {count} triangles ({announced} bytes) and holds {found} bytes of them; it was cut short, write it again"
        )));
    }
    let number = |bytes: &[u8]| f64::from(f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]));
    let vertex = |bytes: &[u8]| std::array::from_fn(|axis| number(&bytes[4 * axis..]));
    let record = |bytes: &[u8]| std::array::from_fn(|k| vertex(&bytes[12 * (k + 1)..]));
    Ok(records[..announced].chunks_exact(RECORD).map(record).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const ASCII: &str = "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid t\n";

    fn binary(triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
        let mut bytes = b"solid by name, binary by nature".to_vec();
        bytes.resize(HEADER, 0);
        bytes.extend((triangles.len() as u32).to_le_bytes());
        for triangle in triangles {
            bytes.extend([0; 12]);
            bytes.extend(triangle.iter().flatten().flat_map(|x| x.to_le_bytes()));
            bytes.extend([0; 2]);
        }
        bytes
    }

    const UNIT: [[f32; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    #[test]
    fn both_forms_give_the_same_triangle() {
        let ascii = parse(ASCII.as_bytes()).unwrap();
        assert_eq!(ascii, parse(&binary(&[UNIT])).unwrap());
        assert_eq!(ascii, [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]]);
    }

    #[test]
    fn damaged_files_are_refused_with_the_place_of_the_damage() {
        let error = |bytes: &[u8]| format!("floor.stl{}", parse(bytes).unwrap_err());
        let whole = binary(&[UNIT, UNIT]);
        assert!(
            error(&whole[..whole.len() - 1])
                .starts_with("floor.stl: announces 2 triangles (100 bytes) and holds 99")
        );
        assert_eq!(error(b"stl"), "floor.stl: is 3 bytes long; even an empty binary STL has 84");
        assert!(error(&ASCII.as_bytes()[..51]).contains("cut short"));
        assert!(
            error(ASCII.replace("vertex 1 0 0", "vertex 1 0").as_bytes())
                .starts_with("floor.stl:5: \"vertex 1 0\"")
        );
    }
}
