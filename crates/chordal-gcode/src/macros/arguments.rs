//! The words of a macro call as local variables.

use chordal_syntax::Letters;

/// Words that belong to the call itself.
pub(crate) const RESERVED: Letters = Letters::of("GLNOP");

/// The variable of an address in argument type I; 0 for none.
pub(crate) const fn type_one(letter: u8) -> u32 {
    match letter {
        b'A' => 1,
        b'B' => 2,
        b'C' => 3,
        b'D' => 7,
        b'E' => 8,
        b'F' => 9,
        b'H' => 11,
        b'I' => 4,
        b'J' => 5,
        b'K' => 6,
        b'M' => 13,
        b'Q' => 17,
        b'R' => 18,
        b'S' => 19,
        b'T' => 20,
        b'U'..=b'Z' => letter as u32 - b'U' as u32 + 21,
        _ => 0,
    }
}

/// The variable of a word that belongs to the call itself when it is also an argument (G66.1); `None` for others.
pub(crate) const fn reserved_variable(letter: u8) -> Option<u32> {
    match letter {
        b'G' => Some(10),
        b'L' => Some(12),
        b'O' => Some(15),
        b'P' => Some(16),
        _ => None,
    }
}

/// The letter of an argument number: 24 is X; 14, N, is one of the words of the call itself. `None` for no argument.
pub(crate) fn letter_of(number: u32) -> Option<u8> {
    let own = match number {
        14 => Some(b'N'),
        15 => Some(b'O'),
        16 => Some(b'P'),
        _ => None,
    };
    own.or_else(|| (b'A'..=b'Z').find(|letter| type_one(*letter) == number))
}

/// Assigns variables to words: A to Z by type I, and I, J, K in sets. A repeated I, J or K, or one out of order, starts
/// the next set (Fanuc B-63684EN, 15.6.1).
pub(crate) struct ArgumentAssigner {
    set: u32,
    last: u8,
    sets: bool,
}

/// Number of sets of I, J and K.
const SETS: u32 = 10;

impl ArgumentAssigner {
    pub fn new(sets: bool) -> ArgumentAssigner {
        ArgumentAssigner { set: 1, last: 0, sets }
    }

    /// The variable of the next word; `None` when the letter cannot be an argument.
    pub fn next(&mut self, letter: u8) -> Option<u32> {
        if RESERVED.has(letter) {
            return None;
        }
        if !self.sets || !matches!(letter, b'I'..=b'K') {
            return Some(type_one(letter)).filter(|number| *number > 0);
        }
        if self.last != 0 && letter <= self.last {
            self.set += 1;
        }
        self.last = letter;
        (self.set <= SETS).then(|| 3 * self.set + 1 + u32::from(letter - b'I'))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn variables(letters: &str) -> Vec<u32> {
        let mut assigner = ArgumentAssigner::new(true);
        letters.bytes().map(|letter| assigner.next(letter).unwrap_or(0)).collect()
    }

    #[test]
    fn the_addresses_of_type_one() {
        let all = variables("ABCDEFHIJKMQRSTUVWXYZ");
        let expected = [1, 2, 3, 7, 8, 9, 11, 4, 5, 6, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26];
        assert_eq!(all, expected);
    }

    #[test]
    fn sets_of_i_j_k() {
        assert_eq!(variables("IJKIJKI"), [4, 5, 6, 7, 8, 9, 10]);
        // K, then I: the next set. I alone, again I: the next.
        assert_eq!(variables("KIIJ"), [6, 7, 10, 11]);
        let ten: String = "IJK".repeat(10);
        assert_eq!(variables(&ten).last(), Some(&33));
        assert_eq!(variables(&"K".repeat(11)).last(), Some(&0));
    }

    #[test]
    fn type_two_beside_type_one() {
        // `A1. B2. I-3. I4. D5.`: I4. and D5. are both #7, and the later one counts.
        assert_eq!(variables("ABIID"), [1, 2, 4, 7, 7]);
    }

    #[test]
    fn words_of_the_call_are_no_arguments() {
        assert_eq!(variables("GLNOP"), [0; 5]);
    }
}
