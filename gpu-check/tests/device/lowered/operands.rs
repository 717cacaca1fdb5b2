//! Operands that are hard for an implementation of f64: near ties, with close exponents, subnormal, or special.

/// Numbers at which an operation changes its way.
const SPECIAL: [f64; 24] = [
    0.0,
    f64::INFINITY,
    f64::NAN,
    f64::MAX,
    f64::MIN_POSITIVE,
    f64::from_bits(1),
    f64::from_bits((1 << 52) - 1),
    1.0,
    1.0 + f64::EPSILON,
    1.0 - f64::EPSILON / 2.0,
    0.5,
    1.5,
    2.5,
    3.0,
    4_503_599_627_370_496.0,
    9_007_199_254_740_991.0,
    2_147_483_647.5,
    2_147_483_648.0,
    4_294_967_295.5,
    4_294_967_296.0,
    3.402_823_567_797_336e38,
    1.401_298_464_324_817e-45,
    1.175_494_350_822_287_5e-38,
    f64::from_bits(0x0010_0000_0000_0001),
];

const SPECIAL_WORDS: [u32; 12] = [
    0,
    1,
    0x7fff_ffff,
    0x8000_0000,
    0xffff_ffff,
    0x7f80_0000,
    0xff80_0000,
    0x7fc0_0000,
    0x0080_0000,
    0x007f_ffff,
    0x8000_0001,
    0x3f80_0001,
];

/// A generator of 64-bit numbers: SplitMix64, which can begin at any place.
struct Draws(u64);

impl Draws {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, limit: u64) -> u64 {
        self.next() % limit
    }

    /// Returns a number with any sign, the biased exponent `exponent`, and a fraction whose bits are random, or all
    /// zero or one but for a few.
    fn with_exponent(&mut self, exponent: u64) -> f64 {
        let random = self.next() & ((1 << 52) - 1);
        let fraction = match self.below(8) {
            0 => random & !0 << self.below(53),
            1 => random | ((1 << self.below(53)) - 1),
            2 => self.below(4),
            3 => ((1 << 52) - 1) ^ self.below(4),
            _ => random,
        };
        f64::from_bits(self.below(2) << 63 | exponent.min(2046) << 52 | fraction & ((1 << 52) - 1))
    }

    fn special(&mut self) -> f64 {
        let number = SPECIAL[self.below(SPECIAL.len() as u64) as usize];
        if self.below(2) == 0 { -number } else { number }
    }
}

/// Returns the case number `index` of the sequence `seed`: three numbers, and one whose lower half is a word, for
/// conversions from numbers of 32 bits.
pub fn draw(seed: u64, index: u64) -> [f64; 4] {
    let mut draws = Draws(seed.wrapping_mul(0x6a09_e667_f3bc_c909) ^ index.wrapping_mul(0xd134_2543_de82_ef95));
    let word = match draws.below(4) {
        0 => SPECIAL_WORDS[draws.below(12) as usize],
        1 => (draws.next() as u32) >> draws.below(32),
        _ => draws.next() as u32,
    };
    let [a, b, c] = numbers(&mut draws, index % 12);
    [a, b, c, f64::from_bits(word.into())]
}

/// Returns three numbers of the kind number `kind`.
fn numbers(draws: &mut Draws, kind: u64) -> [f64; 3] {
    match kind {
        // Random bits.
        0 => [(); 3].map(|()| f64::from_bits(draws.next())),
        // Exponents that differ by 0 to 60, anywhere or near 1.
        1 | 2 => {
            let exponent = if kind == 1 { draws.below(1980) + 1 } else { draws.below(40) + 1000 };
            [0, 60, 60].map(|spread: u64| {
                let more = draws.below(spread + 1);
                draws.with_exponent(exponent + more)
            })
        }
        // Subnormal numbers, and products and quotients that are subnormal.
        3 => [(); 3].map(|()| {
            let exponent = draws.below(60);
            draws.with_exponent(exponent)
        }),
        4 => {
            let (first, second) = (draws.below(1000) + 20, draws.below(80));
            [
                draws.with_exponent(first),
                draws.with_exponent(1000 + second - first.min(980)),
                draws.with_exponent(second),
            ]
        }
        // Specials with each other and with random numbers.
        5 => [draws.special(), draws.special(), draws.special()],
        6 => {
            let exponent = draws.below(2047);
            let own = draws.with_exponent(exponent);
            if draws.below(2) == 0 { [own, draws.special(), own] } else { [draws.special(), own, own] }
        }
        // Sums near a tie: the smaller number is half of the last bit of the larger one, or next to it.
        7 => {
            let exponent = draws.below(1900) + 70;
            let a = draws.with_exponent(exponent);
            let half = f64::from_bits((exponent - 53) << 52);
            let b = f64::from_bits(half.to_bits().wrapping_add(draws.below(3)).wrapping_sub(1));
            let near = exponent - draws.below(60);
            [a, if draws.below(2) == 0 { b } else { -b }, draws.with_exponent(near)]
        }
        // Products of short significands, whose last bits are often exactly half.
        8 => {
            let mut short = |bits: u64| (draws.below(1 << bits) | 1 << (bits - 1) | 1) as f64;
            let product = short(27) * short(27);
            [short(27), short(27), if product > 1e16 { -product } else { short(53) }]
        }
        // Quotients near a tie: a is b times a number with one bit more than fits, rounded.
        9 => {
            let b = (draws.below(1 << 26) | 1 << 25) as f64;
            let quotient = (draws.below(1 << 27) | 1 << 26 | 1) as f64;
            let a = quotient * b;
            let a = f64::from_bits(a.to_bits().wrapping_add(draws.below(3)).wrapping_sub(1));
            let odd = (draws.below(1 << 53) | 1 << 52 | 1) as f64;
            if draws.below(2) == 0 { [a, b, -a] } else { [odd * b, b, odd] }
        }
        // Roots near a tie: the square of a number with one bit more than fits, rounded; and exact squares.
        10 => {
            let root = f64::from_bits(1023 << 52 | draws.below(1 << 52));
            let next = f64::from_bits(root.to_bits() + 1);
            let square = if draws.below(2) == 0 { root * next } else { root * root };
            let scale = f64::from_bits((2 * draws.below(500) + 500) << 52);
            let exact = (draws.below(1 << 26) as f64).powi(2);
            let square = f64::from_bits(square.to_bits().wrapping_add(draws.below(3)).wrapping_sub(1));
            [if draws.below(4) == 0 { exact } else { square * scale }, root, next]
        }
        // Halves, numbers near 2^31 and 2^32, and those that are halfway between two f32.
        _ => {
            let whole = (draws.next() >> draws.below(64)) as f64;
            let half = whole + [0.0, 0.5, 0.25, 0.75][draws.below(4) as usize];
            let single = f32::from_bits(draws.next() as u32 & 0x7fff_ffff);
            let next = f32::from_bits(single.to_bits().wrapping_add(1));
            let between = (f64::from(single) + f64::from(next)) / 2.0;
            let between = f64::from_bits(between.to_bits().wrapping_add(draws.below(3)).wrapping_sub(1));
            let signed = |number: f64, minus: bool| if minus { -number } else { number };
            let minus = draws.below(2) == 0;
            if draws.below(2) == 0 { [signed(half, minus), 1.0, 0.5] } else { [signed(between, minus), half, 2.0] }
        }
    }
}
