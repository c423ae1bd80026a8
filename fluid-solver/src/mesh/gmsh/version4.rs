//! The sections of MSH 4.1, alike in text and binary.

use super::content::{Content, Element, element_type};
use super::source::Source;
use crate::mesh::MeshError;

/// Physical tag of each entity that has one: dimension, entity, tag.
#[derive(Default)]
pub struct Entities(Vec<(i32, i32, i32)>);

impl Entities {
    pub fn read(&mut self, source: &mut Source) -> Result<(), MeshError> {
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = source.size()?;
        }
        for (dimension, count) in (0..).zip(counts) {
            for _ in 0..count {
                let entity = source.int()?;
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    source.real()?;
                }
                let physical = source.size()?;
                if physical > 1 {
                    let found =
                        format!("entity {entity} of dimension {dimension} in {physical} physical groups");
                    return Err(source.error(found, "at most one group", "keep one of the groups"));
                }
                if physical == 1 {
                    self.0.push((dimension, entity, source.int()?.abs()));
                }
                if dimension > 0 {
                    for _ in 0..source.size()? {
                        source.int()?;
                    }
                }
            }
        }
        self.0.sort_unstable();
        Ok(())
    }

    fn physical(&self, dimension: i32, entity: i32) -> i32 {
        let found = self.0.binary_search_by_key(&(dimension, entity), |entry| (entry.0, entry.1));
        found.map_or(0, |index| self.0[index].2)
    }
}

/// Reads the four counts that open a section and returns the first, the number of blocks.
fn blocks(source: &mut Source) -> Result<u64, MeshError> {
    let blocks = source.size()?;
    for _ in 0..3 {
        source.size()?;
    }
    Ok(blocks)
}

pub fn read_nodes(source: &mut Source, content: &mut Content) -> Result<(), MeshError> {
    for _ in 0..blocks(source)? {
        let (dimension, _entity, parametric) = (source.int()?, source.int()?, source.int()?);
        let count = source.size()? as usize;
        let mut tags = Vec::with_capacity(count.min(source.remaining()));
        for _ in 0..count {
            tags.push(source.size()?);
        }
        for tag in tags {
            content.nodes.push((tag, [source.real()?, source.real()?, source.real()?]));
            for _ in 0..if parametric == 0 { 0 } else { dimension } {
                source.real()?;
            }
        }
    }
    Ok(())
}

pub fn read_elements(
    source: &mut Source,
    entities: &Entities,
    content: &mut Content,
) -> Result<(), MeshError> {
    for _ in 0..blocks(source)? {
        let (dimension, entity, number) = (source.int()?, source.int()?, source.int()?);
        let kind = element_type(source, number)?;
        let physical = entities.physical(dimension, entity);
        for _ in 0..source.size()? {
            source.size()?;
            let mut nodes = [0; 4];
            for node in &mut nodes[..kind.node_count()] {
                *node = source.size()?;
            }
            content.elements.push(Element { kind, physical, nodes });
        }
    }
    Ok(())
}

pub fn read_periodic(source: &mut Source, content: &mut Content) -> Result<(), MeshError> {
    for _ in 0..source.size()? {
        for _ in 0..3 {
            source.int()?;
        }
        for _ in 0..source.size()? {
            source.real()?;
        }
        for _ in 0..source.size()? {
            content.periodic.push((source.size()?, source.size()?));
        }
    }
    Ok(())
}
