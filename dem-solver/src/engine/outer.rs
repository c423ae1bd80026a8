//! The outer list: pairs within the skin, found rarely.

use super::chunk::{Chunk, OuterPairs};
use super::levels::{Level, Levels};
use super::periods::Periods;
use crate::grains::Grains;
use crate::lanes::{Backend, Kernel, RowLanes, Vec3};

/// Finds a chunk's outer pairs, but for the pairs of rows `apart`, ascending, that have no contact.
pub fn find_outer(
    backend: Backend,
    grains: &Grains,
    (levels, periods): (&Levels, &Periods),
    skin: f64,
    apart: &[[u32; 2]],
    chunk: &mut Chunk,
) {
    let OuterPairs { i: first, slot: second } = &mut chunk.outer;
    first.clear();
    second.clear();
    backend.run(Search { grains, levels, periods, skin, range: chunk.rows.clone(), first, second });
    if !apart.is_empty() {
        leave_out(apart, &mut chunk.outer);
    }
    assign_slots(chunk);
}

/// Takes these pairs out of a list of rows.
fn leave_out(apart: &[[u32; 2]], outer: &mut OuterPairs) {
    let pairs = outer.i.iter().copied().zip(outer.slot.iter().copied());
    let left = pairs.filter(|&(i, j)| apart.binary_search(&[i, j]).is_err());
    (outer.i, outer.slot) = left.unzip();
}

/// Gives each second grain, told by its row, a slot of the chunk's loads.
pub fn assign_slots(chunk: &mut Chunk) {
    let second = &mut chunk.outer.slot;
    chunk.grain_of_slot.clear();
    chunk.grain_of_slot.extend(chunk.rows.start as u32..chunk.rows.end as u32);
    let end = chunk.rows.end as u32;
    let mut behind: Vec<u32> = second.iter().copied().filter(|&j| j >= end).collect();
    behind.sort_unstable();
    behind.dedup();
    for j in second.iter_mut() {
        *j = if *j < end {
            *j - chunk.rows.start as u32
        } else {
            (chunk.rows.len() + behind.partition_point(|row| row < j)) as u32
        };
    }
    chunk.grain_of_slot.append(&mut behind);
}

/// Compares each grain of a range with runs of grains in cells around it, class by class.
struct Search<'a> {
    grains: &'a Grains,
    levels: &'a Levels,
    periods: &'a Periods,
    skin: f64,
    range: std::ops::Range<usize>,
    first: &'a mut Vec<u32>,
    second: &'a mut Vec<u32>,
}

impl Kernel for Search<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: RowLanes>(self) {
        let Self { grains, levels, periods, skin, range, first, second } = self;
        let mut runs = Vec::new();
        for row in range {
            let place = &grains.place[row];
            let [x0, y0, z0] = place.centre.into();
            let centre = Vec3::new(L::splat(x0), L::splat(y0), L::splat(z0));
            let reach = L::splat(place.radius + skin);
            let frozen = grains.motion[row].is_frozen();
            let begin_of_row = second.len();
            for Level { largest, grid } in levels.iter() {
                grid.around(place, place.radius + largest + skin, &mut runs);
                let [x, y, z, r] = &grid.columns;
                for &(begin, end) in &runs {
                    for k in (begin as usize..end as usize).step_by(L::WIDTH) {
                        let others = Vec3::load(&x[k..], &y[k..], &z[k..]);
                        let separation = periods.nearest(others - centre);
                        let reach = reach + L::load(&r[k..]);
                        let inside = low_bits((end as usize - k).min(L::WIDTH));
                        let mut near = L::bits(separation.norm_squared().less(reach * reach)) & inside;
                        while near != 0 {
                            let j = grid.order[k + near.trailing_zeros() as usize];
                            near &= near - 1;
                            if j as usize > row && !(frozen && grains.motion[j as usize].is_frozen()) {
                                first.push(row as u32);
                                second.push(j);
                            }
                        }
                    }
                }
            }
            // The order of sums is then that of the rows, whenever the list was made.
            second[begin_of_row..].sort_unstable();
        }
    }
}

/// The lowest bits, so many.
#[inline(always)]
pub fn low_bits(count: usize) -> u32 {
    (1 << count) - 1
}
