//! The sections of MSH 2.2. Counts are text even in binary files.

use super::content::{Content, Element, element_type};
use super::source::Source;
use crate::mesh::MeshError;

fn count(source: &mut Source) -> Result<usize, MeshError> {
    let count = source.text("a count")?;
    if source.is_binary() {
        source.end_line()?;
    }
    Ok(count)
}

fn tag(source: &mut Source) -> Result<u64, MeshError> {
    let tag = source.int()?;
    u64::try_from(tag)
        .map_err(|_| source.error(tag.to_string(), "a node tag, from 1", "export the file again"))
}

pub fn read_nodes(source: &mut Source, content: &mut Content) -> Result<(), MeshError> {
    for _ in 0..count(source)? {
        content.nodes.push((tag(source)?, [source.real()?, source.real()?, source.real()?]));
    }
    Ok(())
}

/// Text has one head `number type tags` per element, binary one `type count tags` per block of equal elements.
pub fn read_elements(source: &mut Source, content: &mut Content) -> Result<(), MeshError> {
    let count = count(source)?;
    let mut read = 0;
    while read < count {
        let (number, in_block) = if source.is_binary() {
            (source.int()?, source.int()?.max(1) as usize)
        } else {
            source.int()?;
            (source.int()?, 1)
        };
        let kind = element_type(source, number)?;
        let tags = source.int()?;
        for _ in 0..in_block {
            if source.is_binary() {
                source.int()?;
            }
            let mut physical = 0;
            for position in 0..tags {
                let value = source.int()?;
                if position == 0 {
                    physical = value.abs();
                }
            }
            let mut nodes = [0; 4];
            for node in &mut nodes[..kind.node_count()] {
                *node = tag(source)?;
            }
            content.elements.push(Element { kind, physical, nodes });
        }
        read += in_block;
    }
    Ok(())
}

/// Text in binary files too: per entity a head, a transformation on a line `Affine …` if any, and the pairs.
pub fn read_periodic(source: &mut Source, content: &mut Content) -> Result<(), MeshError> {
    let entities: usize = source.text("a count")?;
    for _ in 0..entities {
        for _ in 0..3 {
            source.text::<i32>("dimension, tag and master tag")?;
        }
        let mut word = source.word()?;
        if word == "Affine" {
            for _ in 0..16 {
                source.text::<f64>("a number of the transformation")?;
            }
            word = source.word()?;
        }
        let pairs: usize = word
            .parse()
            .map_err(|_| source.error(format!("\"{word}\""), "a count of pairs", "export the file again"))?;
        for _ in 0..pairs {
            content.periodic.push((source.text("a node tag")?, source.text("a node tag")?));
        }
    }
    Ok(())
}
