//! Whether a file holds something else than it did.

/// What a file held, as far as it takes to decide whether it holds something else.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Content {
    length: usize,
    sum: u64,
}

impl Content {
    /// Of these bytes. Nobody makes a file on purpose that has the sum of another one, so that a quick one will do.
    pub fn of(bytes: &[u8]) -> Content {
        /// Odd, with about as many ones as zeros: the fraction of the golden ratio.
        const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
        let add = |sum: u64, word: u64| (sum.rotate_left(23) ^ word).wrapping_mul(FACTOR);
        let (words, rest) = bytes.as_chunks::<8>();
        let sum = words.iter().fold(0, |sum, word| add(sum, u64::from_le_bytes(*word)));
        let sum = rest.iter().fold(sum, |sum, byte| add(sum, u64::from(*byte)));
        Content { length: bytes.len(), sum }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_bytes_are_another_content() {
        assert_eq!(Content::of(b"old"), Content::of(b"old"));
        assert_ne!(Content::of(b"old"), Content::of(b"new"));
        // Each byte and its place counts.
        let text = b"G1 X1. Y2. F100.\nG0 Z5.".to_vec();
        for at in 0..text.len() {
            let mut other = text.clone();
            other[at] ^= 1;
            assert_ne!(Content::of(&text), Content::of(&other), "{at}");
            other.copy_from_slice(&text);
            other.rotate_left(at + 1);
            assert!(other == text || Content::of(&text) != Content::of(&other), "{at}");
        }
    }
}
