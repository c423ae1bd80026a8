//! XXH64: a fast 64-bit checksum against truncation and flipped bits; no protection against intent.

const P1: u64 = 0x9E37_79B1_85EB_CA87;
const P2: u64 = 0xC2B2_AE3D_27D4_EB4F;
const P3: u64 = 0x1656_67B1_9E37_79F9;
const P4: u64 = 0x85EB_CA77_C2B2_AE63;
const P5: u64 = 0x27D4_EB2F_1656_67C5;

/// XXH64 of `bytes` with seed 0.
///
/// Source: Y. Collet, xxHash specification 0.1.1, section XXH64,
/// <https://github.com/Cyan4973/xxHash/blob/dev/doc/xxhash_spec.md>.
pub fn checksum(bytes: &[u8]) -> u64 {
    let (stripes, tail) = bytes.as_chunks::<32>();
    let mut hash = if stripes.is_empty() {
        P5
    } else {
        let mut lanes = [P1.wrapping_add(P2), P2, 0, P1.wrapping_neg()];
        for stripe in stripes {
            for (lane, word) in lanes.iter_mut().zip(stripe.as_chunks::<8>().0) {
                *lane = round(*lane, u64::from_le_bytes(*word));
            }
        }
        let [a, b, c, d] = lanes;
        let joined = a
            .rotate_left(1)
            .wrapping_add(b.rotate_left(7))
            .wrapping_add(c.rotate_left(12))
            .wrapping_add(d.rotate_left(18));
        lanes.iter().fold(joined, |hash, &lane| (hash ^ round(0, lane)).wrapping_mul(P1).wrapping_add(P4))
    };
    hash = hash.wrapping_add(bytes.len() as u64);

    let (words, tail) = tail.as_chunks::<8>();
    for word in words {
        hash = (hash ^ round(0, u64::from_le_bytes(*word))).rotate_left(27).wrapping_mul(P1).wrapping_add(P4);
    }
    let (half_words, tail) = tail.as_chunks::<4>();
    for word in half_words {
        let word = u64::from(u32::from_le_bytes(*word));
        hash = (hash ^ word.wrapping_mul(P1)).rotate_left(23).wrapping_mul(P2).wrapping_add(P3);
    }
    for &byte in tail {
        hash = (hash ^ u64::from(byte).wrapping_mul(P5)).rotate_left(11).wrapping_mul(P1);
    }

    hash = (hash ^ (hash >> 33)).wrapping_mul(P2);
    hash = (hash ^ (hash >> 29)).wrapping_mul(P3);
    hash ^ (hash >> 32)
}

fn round(lane: u64, word: u64) -> u64 {
    lane.wrapping_add(word.wrapping_mul(P2)).rotate_left(31).wrapping_mul(P1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn golden_values_of_the_reference_implementation() {
        let counting: Vec<u8> = (0..=255).collect();
        assert_eq!(checksum(b""), 0xef46db3751d8e999);
        assert_eq!(checksum(b"abc"), 0x44bc2cf5ad770999);
        assert_eq!(checksum(&counting[..31]), 0xc346d2b59b4d8ee1);
        assert_eq!(checksum(&counting[..32]), 0xcbf59c5116ff32b4);
        assert_eq!(checksum(&counting[..47]), 0x0d9883a03e7bfbb8);
        assert_eq!(checksum(&counting[..63]), 0xe26aa9e2a95f8e4f);
        assert_eq!(checksum(&counting[..256]), 0x1facbe8406cd904b);
    }

    #[test]
    fn every_single_flipped_bit_changes_the_checksum() {
        let mut bytes: Vec<u8> = (0..77).collect();
        let whole = checksum(&bytes);
        for bit in 0..bytes.len() * 8 {
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert_ne!(checksum(&bytes), whole, "bit {bit}");
            bytes[bit / 8] ^= 1 << (bit % 8);
        }
    }
}
