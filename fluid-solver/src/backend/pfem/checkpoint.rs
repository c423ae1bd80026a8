//! What a fluid of moving nodes needs to go on with the same bits.

use super::cloud::Cloud;
use super::gate::{Amount, Passed};
use super::remesh::{Account, Books, EnergyBooks, VolumeBooks};
use super::state::{Counts, State};
use super::wall::Contacts;
use crate::element::simplex::Vector;
use crate::error::FluidError;
use case_io::checkpoint::{Checkpoint, CheckpointWriter};

/// Adds the state.
pub fn save<'a, const D: usize, const N: usize>(
    state: &'a State<D, N>,
    writer: CheckpointWriter<'a>,
) -> CheckpointWriter<'a> {
    let State { cloud, books, given, counts, fluid_volume, passed } = state;
    let Cloud { place, velocity, pressure, contacts, drop, birth, cells, neighbours } = cloud;
    let contacts: Vec<u32> = contacts.iter().map(|contacts| contacts.bits()).collect();
    let counts = counts.named().map(|(_, count)| count);
    writer
        .array("place", place.as_flattened())
        .array("velocity", velocity.as_flattened())
        .array("pressure", pressure)
        .made("contacts", &contacts)
        .array("drop", drop)
        .array("birth", birth)
        .array("cells", cells.as_flattened())
        .array("neighbours", neighbours.as_flattened())
        .made("books", &written(books))
        .made("given", &[*given])
        .made("fluid-volume", &[*fluid_volume])
        .made("passed", &[amount(&passed.entered), amount(&passed.left)].concat())
        .made("counts", &counts)
}

/// Goes on from a checkpoint.
///
/// # Errors
/// A damaged checkpoint, or one of another backend.
pub fn load<const D: usize, const N: usize>(checkpoint: &Checkpoint) -> Result<State<D, N>, FluidError> {
    let place: Vec<Vector<D>> = by_rows(checkpoint.array("place")?);
    let nodes = place.len();
    let cloud = Cloud {
        place,
        velocity: by_rows(checkpoint.array("velocity")?),
        pressure: checkpoint.array("pressure")?,
        contacts: checkpoint.array::<u32>("contacts")?.into_iter().map(Contacts::from_bits).collect(),
        drop: checkpoint.array("drop")?,
        birth: checkpoint.array("birth")?,
        cells: by_rows(checkpoint.array("cells")?),
        neighbours: by_rows(checkpoint.array("neighbours")?),
    };
    let found = |name: &'static str, found: usize| FluidError::OtherMesh { name, found, nodes };
    let lengths = [
        ("velocity", cloud.velocity.len()),
        ("pressure", cloud.pressure.len()),
        ("contacts", cloud.contacts.len()),
        ("drop", cloud.drop.len()),
        ("birth", cloud.birth.len()),
    ];
    if let Some((name, length)) = lengths.into_iter().find(|&(_, length)| length != nodes) {
        return Err(found(name, length));
    }
    let counts: Vec<u64> = checkpoint.array("counts")?;
    let &[closed, filled, broken, released, absorbed] = counts.as_slice() else {
        return Err(found("counts", counts.len()));
    };
    let books: Vec<f64> = checkpoint.array("books")?;
    let passed: Vec<f64> = checkpoint.array("passed")?;
    let (entered, left) = passed.split_at(passed.len() / 2);
    let amounts = amount_of(entered).zip(amount_of(left));
    let (entered, left) = amounts.ok_or_else(|| found("passed", passed.len()))?;
    Ok(State {
        cloud,
        passed: Passed { entered, left },
        books: read(&books).ok_or_else(|| found("books", books.len()))?,
        given: checkpoint.array("given")?.first().copied().unwrap_or_default(),
        fluid_volume: checkpoint.array("fluid-volume")?.first().copied().unwrap_or_default(),
        counts: Counts { closed, filled, broken, released, absorbed },
    })
}

fn amount<const D: usize>(amount: &Amount<D>) -> Vec<f64> {
    let Amount { volume, momentum, energy } = amount;
    [&[*volume, *energy], momentum.as_slice()].concat()
}

fn amount_of<const D: usize>(numbers: &[f64]) -> Option<Amount<D>> {
    let &[volume, energy, ref momentum @ ..] = numbers else { return None };
    Some(Amount { volume, energy, momentum: momentum.try_into().ok()? })
}

fn by_rows<T: Copy, const K: usize>(flat: Vec<T>) -> Vec<[T; K]> {
    flat.as_chunks::<K>().0.to_vec()
}

/// The accounts of the books, in the order in which they are written.
fn accounts<const D: usize>(books: &mut Books<D>) -> Vec<&mut Account> {
    let Books { volume, energy: EnergyBooks { kinetic, limiter, moment } } = books;
    let VolumeBooks {
        start: _,
        target: _,
        cells: _,
        drops: _,
        flow,
        management,
        overlap,
        merging,
        separation,
        absorption,
        correction,
        largest_error: _,
    } = volume;
    let of_volume = [flow, management, overlap, merging, separation, absorption, correction];
    of_volume.into_iter().chain([kinetic, limiter]).chain(moment).collect()
}

fn written<const D: usize>(books: &Books<D>) -> Vec<f64> {
    let mut books = *books;
    let VolumeBooks { start, target, cells, drops, largest_error, .. } = books.volume;
    let accounts = accounts(&mut books).into_iter().flat_map(|account| [account.sum, account.absolute]);
    [start, target, cells, drops, largest_error].into_iter().chain(accounts).collect()
}

fn read<const D: usize>(numbers: &[f64]) -> Option<Books<D>> {
    let (&[start, target, cells, drops, largest_error], rest) = numbers.split_first_chunk()?;
    let volume = VolumeBooks { start, target, cells, drops, largest_error, ..VolumeBooks::default() };
    let mut books = Books { volume, ..Books::default() };
    let accounts = accounts(&mut books);
    let (pairs, []) = rest.as_chunks::<2>() else { return None };
    if pairs.len() != accounts.len() {
        return None;
    }
    for (account, &[sum, absolute]) in accounts.into_iter().zip(pairs) {
        *account = Account { sum, absolute };
    }
    Some(books)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn books_come_back_as_they_were_and_others_are_refused() {
        let mut books = Books::<2>::default();
        books.volume.target = 3.0;
        books.volume.largest_error = 0.01;
        for (k, account) in accounts(&mut books).into_iter().enumerate() {
            account.add(k as f64 - 4.5);
        }
        let numbers = written(&books);
        assert_eq!(read::<2>(&numbers), Some(books));
        assert_eq!(read::<3>(&numbers), None);
    }
}
