//! Integers of many bits.

/// An integer of 64 L bits, two's complement, least significant limb first; arithmetic is modulo 2^(64 L).
#[derive(Clone, Copy)]
pub struct Wide<const L: usize>([u64; L]);

impl<const L: usize> Wide<L> {
    #[inline(always)]
    pub fn plus(self, other: Self) -> Self {
        let mut sum = [0; L];
        let mut carry = false;
        for k in 0..L {
            let (a, over_a) = self.0[k].overflowing_add(other.0[k]);
            let (b, over_b) = a.overflowing_add(u64::from(carry));
            (sum[k], carry) = (b, over_a | over_b);
        }
        Self(sum)
    }

    #[inline(always)]
    pub fn negated(self) -> Self {
        Self(self.0.map(|limb| !limb)).plus(Self::one())
    }

    #[inline(always)]
    pub fn minus(self, other: Self) -> Self {
        self.plus(other.negated())
    }

    #[inline(always)]
    pub fn times(self, factor: i64) -> Self {
        let product = self.times_limb(factor.unsigned_abs());
        if factor < 0 { product.negated() } else { product }
    }

    #[inline(always)]
    pub fn times_unsigned(self, factor: u128) -> Self {
        let high = self.times_limb((factor >> 64) as u64);
        let mut shifted = [0; L];
        shifted[1..].copy_from_slice(&high.0[..L - 1]);
        self.times_limb(factor as u64).plus(Self(shifted))
    }

    /// −1, 0 or 1.
    pub fn sign(self) -> f64 {
        if (self.0[L - 1] as i64) < 0 {
            -1.0
        } else if self.0.iter().fold(0, |bits, limb| bits | limb) == 0 {
            0.0
        } else {
            1.0
        }
    }

    fn one() -> Self {
        let mut one = [0; L];
        one[0] = 1;
        Self(one)
    }

    #[inline(always)]
    fn times_limb(self, factor: u64) -> Self {
        let mut product = [0; L];
        let mut carry = 0;
        for k in 0..L {
            let sum = u128::from(self.0[k]) * u128::from(factor) + u128::from(carry);
            (product[k], carry) = (sum as u64, (sum >> 64) as u64);
        }
        Self(product)
    }
}

impl<const L: usize> From<i128> for Wide<L> {
    #[inline(always)]
    fn from(number: i128) -> Self {
        let mut limbs = [(number >> 127) as u64; L];
        limbs[0] = number as u64;
        limbs[1] = (number >> 64) as u64;
        Self(limbs)
    }
}

#[cfg(test)]
mod tests {
    use super::Wide;

    const CASES: [i128; 8] =
        [0, 1, -1, 7, -12_345_678_901_234_567_890, 1 << 90, -(1 << 100), i64::MAX as i128];

    #[test]
    fn it_calculates_like_128_bits_where_those_suffice() {
        for a in CASES {
            for b in CASES {
                let [wide_a, wide_b] = [a, b].map(Wide::<4>::from);
                assert_eq!(wide_a.plus(wide_b).0, Wide::from(a + b).0);
                assert_eq!(wide_a.minus(wide_b).0, Wide::from(a - b).0);
                assert_eq!(wide_a.minus(wide_b).sign(), (a - b).signum() as f64);
                assert_eq!(wide_a.times(-7).0, Wide::from(a * -7).0);
            }
        }
    }

    #[test]
    fn products_beyond_128_bits_have_the_right_sign_and_divide_out() {
        let (a, factor) = (-(1i128 << 126), (1u128 << 127) + 5);
        let product = Wide::<6>::from(a).times_unsigned(factor);
        assert_eq!(product.sign(), -1.0);
        let sum = (0..5).fold(Wide::<6>::from(a).times_unsigned(1 << 127), |sum, _| sum.plus(Wide::from(a)));
        assert_eq!(product.minus(sum).sign(), 0.0);
        assert_eq!(product.times(-1).plus(product).sign(), 0.0);
    }
}
