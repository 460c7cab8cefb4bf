//! What editors show and offer: the meaning of a word at a place, words and whole cycles to write.

mod cycle_words;
mod meanings;
mod numbers;
mod symbols;
mod vocabulary;

use chordal_kernel::{VocabularyGroup, WordCompletion};

use cycle_words::CYCLE_WORDS;
pub use meanings::{meaning_at, word_meaning};
use numbers::{MACHINE_FUNCTIONS, NUMBERED_FUNCTIONS, PARAMETERS, parameter_meaning};
pub use symbols::text_symbols;
use vocabulary::VOCABULARY;

use crate::cycles::cycle_signature;

/// The words of the language, and each cycle with its parameters as the control writes it.
pub fn completions() -> Vec<WordCompletion> {
    let word = |(word, meaning): &(&str, &str)| WordCompletion {
        word: word.to_string(),
        meaning: meaning.to_string(),
    };
    let cycles = CYCLE_WORDS.iter().map(|(number, words)| WordCompletion {
        word: cycle_text(*number, words),
        meaning: cycle_title(*number).to_string(),
    });
    VOCABULARY.iter().map(word).chain(cycles).collect()
}

/// The words of the language by what they are, for a reference page.
pub fn vocabulary_groups() -> Vec<VocabularyGroup> {
    let row = |word: String, meaning: &str| WordCompletion { word, meaning: meaning.to_string() };
    let numbered = |letter: &str, all: &[(u32, &str)]| -> Vec<WordCompletion> {
        all.iter().map(|(number, meaning)| row(format!("{letter}{number}"), meaning)).collect()
    };
    let cycle = |(number, words): &(u32, &[u32])| {
        let data: Vec<String> = words.iter().map(|word| format!("Q{word}")).collect();
        row(format!("CYCL DEF {number}"), &format!("{}: {}", cycle_title(*number), data.join(" ")))
    };
    let words = VOCABULARY.iter().map(|(word, meaning)| row(word.to_string(), meaning));
    vec![
        VocabularyGroup { title: "Words", words: words.collect() },
        VocabularyGroup {
            title: "Cycles, with their data in the order of the control",
            words: CYCLE_WORDS.iter().map(cycle).collect(),
        },
        VocabularyGroup { title: "Data of cycles", words: numbered("Q", PARAMETERS) },
        VocabularyGroup { title: "M functions", words: numbered("M", MACHINE_FUNCTIONS) },
        VocabularyGroup { title: "FN functions", words: numbered("FN ", NUMBERED_FUNCTIONS) },
    ]
}

/// The name of a cycle; empty for one that is not known.
fn cycle_title(number: u32) -> &'static str {
    cycle_signature(number).map_or("", |cycle| cycle.title)
}

/// `CYCL DEF 200 DRILLING ~` with a line for each parameter.
fn cycle_text(number: u32, words: &[u32]) -> String {
    let mut text = format!("CYCL DEF {number} {}", cycle_title(number).to_uppercase());
    for word in words {
        let meaning = parameter_meaning(*word).unwrap_or("");
        let meaning = meaning.split([',', ':']).next().unwrap_or("").to_uppercase();
        text += &format!(" ~\n    Q{word}=+0 ;{meaning}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::{KlartextReader, KlartextStatement};

    #[test]
    fn every_cycle_is_read_back_with_its_parameters() {
        for (number, words) in CYCLE_WORDS {
            let text = cycle_text(*number, words);
            let blocks: Vec<_> = KlartextReader::new(text.as_bytes()).collect();
            assert_eq!(blocks.len(), 1, "{text}");
            assert!(blocks[0].faults.is_empty(), "{text}");
            let KlartextStatement::CycleParameters { number: read, values } = &blocks[0].statement
            else {
                panic!("{text}");
            };
            let read_words: Vec<u32> = values.iter().map(|(word, ..)| *word).collect();
            assert_eq!((*read, read_words.as_slice()), (*number, *words));
            assert!(words.iter().all(|word| parameter_meaning(*word).is_some()), "{text}");
        }
    }

    #[test]
    fn a_cycle_has_all_that_it_requires() {
        for (number, words) in CYCLE_WORDS {
            let cycle = cycle_signature(*number).expect("a known cycle");
            assert!(cycle.required.iter().all(|word| words.contains(word)), "{number}");
        }
    }
}
