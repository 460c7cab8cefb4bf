//! Reading any bytes: no crash, every span inside the text, every block further on.

#![no_main]

use chordal::control::CONTROLS;
use chordal::diagnostics::FileId;
use chordal::syntax::{Block, BlockReader, decode, find_programs};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let decoded = decode(bytes);
    let text = &decoded.text;
    for table in CONTROLS {
        let mut last = 0;
        for program in find_programs(text, &table.lexicon) {
            assert!(program.start.offset >= last && program.end as usize <= text.len());
            last = program.start.offset;
        }
        let mut reader = BlockReader::new(text, FileId(0), table.lexicon);
        let mut block = Block::new();
        let mut before = 0;
        while reader.read(&mut block) {
            assert!(block.range.start <= block.range.end);
            assert!(block.range.end as usize <= text.len());
            for word in &block.words {
                assert!(word.range.end as usize <= text.len());
                assert!(word.number().is_none_or(|number| number.to_f64().is_finite()));
            }
            assert!(reader.position().offset > before || block.range.end as usize == text.len());
            before = reader.position().offset;
        }
    }
});
