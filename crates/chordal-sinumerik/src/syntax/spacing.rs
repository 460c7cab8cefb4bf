//! One blank between the words of a block, and none at its ends.

use chordal_diagnostics::TextRange;

use super::ast::ProgramBlock;
use super::reader::BlockReader;

/// The text with one blank between the words of each block and none at its ends. Values, comments, and blocks that cannot
/// be read stay as they are written; so do heads and lines that are no blocks.
pub fn with_uniform_spacing(text: &[u8]) -> Vec<u8> {
    let mut spaced = Vec::with_capacity(text.len());
    let mut copied = 0;
    for block in BlockReader::new(text) {
        let Some(line) = spaced_block(text, &block) else { continue };
        spaced.extend_from_slice(&text[copied..block.range.start as usize]);
        spaced.extend_from_slice(&line);
        copied = block.range.end as usize;
    }
    spaced.extend_from_slice(&text[copied..]);
    spaced
}

/// The line of a block; `None` where it stays as it is.
fn spaced_block(text: &[u8], block: &ProgramBlock) -> Option<Vec<u8>> {
    if !block.faults.is_empty() {
        return None;
    }
    let number = block.number.map(|number| number.range);
    let label = block.label.as_ref().map(|label| label.range);
    let statements = block.statements.iter().map(|statement| statement.range);
    let mut words: Vec<TextRange> =
        number.into_iter().chain(label).chain(statements).chain(block.comment).collect();
    words.sort_by_key(|word| word.start);
    let (first, last) = (words.first()?, words.last()?);
    let is_blank = |start: u32, end: u32| {
        start <= end && text[start as usize..end as usize].iter().all(u8::is_ascii_whitespace)
    };
    let gaps_are_blank = words.windows(2).all(|pair| is_blank(pair[0].end, pair[1].start));
    if !gaps_are_blank || !is_blank(last.end, block.range.end) {
        return None;
    }
    // The skip character stands next to the first word.
    let mut line = text[block.range.start as usize..first.start as usize].trim_ascii().to_vec();
    for (index, word) in words.iter().enumerate() {
        if index > 0 {
            line.push(b' ');
        }
        line.extend_from_slice(word.slice(text).trim_ascii());
    }
    Some(line)
}

#[cfg(test)]
mod tests {
    use super::with_uniform_spacing;

    fn spaced(text: &str) -> String {
        String::from_utf8(with_uniform_spacing(text.as_bytes())).expect("UTF-8")
    }

    #[test]
    fn words_stand_one_blank_apart() {
        let written = "%_N_PART_MPF\n;$PATH=/_N_MPF_DIR\n  N10  G1X10   Y=R1 + 2 F100 ; to the  corner\n\n\
                       / N20\tG0 Z5\r\n/2N30 Z=IC( 5 )\nEND: G4 F2   \nIF  R1 == 1  GOTOF END\n";
        let expected = "%_N_PART_MPF\n;$PATH=/_N_MPF_DIR\nN10 G1 X10 Y=R1 + 2 F100 ; to the  corner\n\n\
                      /N20 G0 Z5\r\n/2N30 Z=IC( 5 )\nEND: G4 F2\nIF  R1 == 1  GOTOF END\n";
        assert_eq!(spaced(written), expected);
        assert_eq!(spaced(expected), expected, "a second time nothing changes");
    }

    #[test]
    fn what_cannot_be_read_stays() {
        let text = "N10 G1  X10 )) Y5\n";
        assert_eq!(spaced(text), text);
    }
}
