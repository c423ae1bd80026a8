//! Perceptually uniform colour maps.

/// Red, green and blue between 0 and 1 (sRGB).
pub(super) type Colour = [f32; 3];

/// What a value without meaning (NaN) looks like.
const UNKNOWN: Colour = [0.62, 0.62, 0.62];

/// How a value becomes a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ColourMap {
    /// Dark violet to yellow. S. van der Walt, N. Smith, matplotlib (2015), CC0; every 16th of its 256 colours.
    Viridis,
    /// Near white to blue: a background that lets grains in viridis stand out. After ColorBrewer's Blues.
    Water,
}

const VIRIDIS: [u32; 17] = [
    0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d, 0x2c728e, 0x26828e, 0x21918c, 0x1fa088,
    0x28ae80, 0x3fbc73, 0x5ec962, 0x84d44b, 0xaddc30, 0xd8e219, 0xfde725,
];

const WATER: [u32; 9] =
    [0xf2f7fd, 0xddeaf7, 0xc9ddf0, 0xaacfe5, 0x84bcdb, 0x5da5d1, 0x3c8cc3, 0x2171b5, 0x0d57a1];

impl ColourMap {
    /// The colour at `share`, 0 to 1 along the map; beyond the ends the end colours, for NaN grey.
    pub(super) fn at(self, share: f64) -> Colour {
        let table: &[u32] = match self {
            Self::Viridis => &VIRIDIS,
            Self::Water => &WATER,
        };
        if share.is_nan() {
            return UNKNOWN;
        }
        let place = share.clamp(0.0, 1.0) * (table.len() - 1) as f64;
        let cell = (place as usize).min(table.len() - 2);
        let part = (place - cell as f64) as f32;
        let (low, high) = (rgb(table[cell]), rgb(table[cell + 1]));
        std::array::from_fn(|k| low[k] + part * (high[k] - low[k]))
    }

    /// The colour of `value` when the map spans `range`; a range without length has one colour, the lowest.
    pub(super) fn of(self, value: f64, (low, high): (f64, f64)) -> Colour {
        let share = if high > low { (value - low) / (high - low) } else { 0.0 * value };
        self.at(share)
    }
}

fn rgb(hex: u32) -> Colour {
    [hex >> 16, hex >> 8, hex].map(|byte| (byte & 0xff) as f32 / 255.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance of an sRGB colour, IEC 61966-2-1.
    fn luminance(colour: Colour) -> f32 {
        let linear = colour.map(|c| if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    #[test]
    fn brightness_is_strictly_monotone_along_both_maps() {
        let brightness = |map: ColourMap| (0..=100).map(move |k| luminance(map.at(f64::from(k) / 100.0)));
        assert!(brightness(ColourMap::Viridis).is_sorted_by(|a, b| a < b));
        assert!(brightness(ColourMap::Water).is_sorted_by(|a, b| a > b));
    }

    #[test]
    fn values_beyond_the_range_take_the_end_colours_and_nan_is_grey() {
        let map = ColourMap::Viridis;
        assert_eq!(map.of(-5.0, (0.0, 1.0)), map.at(0.0));
        assert_eq!(map.of(f64::INFINITY, (0.0, 1.0)), map.at(1.0));
        assert_eq!(map.of(f64::NAN, (0.0, 1.0)), UNKNOWN);
        assert_eq!(map.of(3.0, (3.0, 3.0)), map.at(0.0));
    }
}
