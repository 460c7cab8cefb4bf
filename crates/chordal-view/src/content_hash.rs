//! Detects that the content of a file has changed.

/// The length and a checksum of a file, to detect changes of its content.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ContentHash {
    length: usize,
    sum: u64,
}

impl ContentHash {
    /// The hash of these bytes. It is fast and not secure, because no attacker gains from a file with an equal hash.
    pub fn of(bytes: &[u8]) -> ContentHash {
        /// The fraction of the golden ratio, a multiplier that mixes bits well: it is odd and has about as many ones
        /// as zeros.
        const GOLDEN_FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
        let add = |sum: u64, word: u64| (sum.rotate_left(23) ^ word).wrapping_mul(GOLDEN_FACTOR);
        let (words, rest) = bytes.as_chunks::<8>();
        let sum = words.iter().fold(0, |sum, word| add(sum, u64::from_le_bytes(*word)));
        let sum = rest.iter().fold(sum, |sum, byte| add(sum, u64::from(*byte)));
        ContentHash { length: bytes.len(), sum }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_bytes_have_another_hash() {
        assert_eq!(ContentHash::of(b"old"), ContentHash::of(b"old"));
        assert_ne!(ContentHash::of(b"old"), ContentHash::of(b"new"));
        // Each byte and its place counts.
        let text = b"G1 X1. Y2. F100.\nG0 Z5.".to_vec();
        for at in 0..text.len() {
            let mut other = text.clone();
            other[at] ^= 1;
            assert_ne!(ContentHash::of(&text), ContentHash::of(&other), "{at}");
            other.copy_from_slice(&text);
            other.rotate_left(at + 1);
            assert!(other == text || ContentHash::of(&text) != ContentHash::of(&other), "{at}");
        }
    }
}
