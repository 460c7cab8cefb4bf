//! The programs, tools and labels of a text, with the blocks that belong to each.

use chordal_diagnostics::TextRange;
use chordal_kernel::{TextSymbol, TextSymbolKind};

use crate::syntax::{KlartextBlock, KlartextLabel, KlartextReader, KlartextStatement};

/// The programs, tools and labels of a text in order.
///
/// A label with LBL 0 after it is a subprogram up to there, and one that CALL LBL n REP calls a part that is repeated.
/// A tool reaches to the next tool, or to the subprograms after the end of the program.
pub fn text_symbols(text: &[u8]) -> Vec<TextSymbol> {
    let mut outline = KlartextOutline::default();
    KlartextReader::new(text).for_each(|block| outline.add(text, &block));
    outline.end(text.len() as u32);
    outline.symbols
}

/// The symbols so far, and which of them have no end yet.
#[derive(Default)]
struct KlartextOutline {
    symbols: Vec<TextSymbol>,
    program: Option<usize>,
    tool: Option<usize>,
    /// The labels since the last LBL 0, with their names.
    labels: Vec<(KlartextLabel, usize)>,
}

impl KlartextOutline {
    fn add(&mut self, text: &[u8], block: &KlartextBlock) {
        let range = block.range;
        match &block.statement {
            KlartextStatement::Begin { name, .. } => {
                self.end(range.start);
                let name = String::from_utf8_lossy(name.slice(text)).into_owned();
                self.program = Some(self.push(name, TextSymbolKind::Program, range));
            }
            KlartextStatement::End { .. } => self.end(range.end),
            KlartextStatement::ToolCall(words) if words.tool.is_some() => {
                self.end_tool(range.start);
                let name = String::from_utf8_lossy(range.slice(text)).into_owned();
                self.tool = Some(self.push(name, TextSymbolKind::Tool, range));
            }
            KlartextStatement::Label(KlartextLabel::Number(0)) => self.end_subprogram(range.end),
            KlartextStatement::Label(label) => {
                let name = match label {
                    KlartextLabel::Number(number) => format!("LBL {number}"),
                    KlartextLabel::Text(name) => format!("LBL \"{name}\""),
                    KlartextLabel::Parameter(_) => return,
                };
                let index = self.push(name, TextSymbolKind::Label, range);
                self.labels.push((label.clone(), index));
            }
            KlartextStatement::CallLabel { label, repeats: Some(_) } => {
                self.end_repeated(label, range.end);
            }
            _ => {}
        }
    }

    fn push(&mut self, name: String, kind: TextSymbolKind, range: TextRange) -> usize {
        self.symbols.push(TextSymbol { name, kind, range, body: range });
        self.symbols.len() - 1
    }

    /// LBL 0 ends the outermost label that is open; those in it are places to jump to.
    fn end_subprogram(&mut self, at: u32) {
        let Some((_, index)) = self.labels.first() else { return };
        let symbol = &mut self.symbols[*index];
        (symbol.kind, symbol.body.end) = (TextSymbolKind::Subprogram, at);
        let start = symbol.range.start;
        self.labels.clear();
        if self.tool.is_some_and(|tool| self.symbols[tool].range.start < start) {
            self.end_tool(start);
        }
    }

    fn end_repeated(&mut self, label: &KlartextLabel, at: u32) {
        let Some(place) = self.labels.iter().rposition(|(own, _)| own == label) else { return };
        let (_, index) = self.labels.remove(place);
        self.symbols[index].body.end = at;
    }

    fn end_tool(&mut self, at: u32) {
        if let Some(index) = self.tool.take() {
            self.symbols[index].body.end = at;
        }
    }

    fn end(&mut self, at: u32) {
        self.end_tool(at);
        self.labels.clear();
        if let Some(index) = self.program.take() {
            self.symbols[index].body.end = at;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bodies(text: &str) -> Vec<(String, TextSymbolKind, String)> {
        let last_line = |symbol: &TextSymbol| {
            let body = std::str::from_utf8(symbol.body.slice(text.as_bytes())).expect("ASCII");
            body.trim_end().lines().next_back().unwrap_or("").to_string()
        };
        let symbols = text_symbols(text.as_bytes());
        symbols.iter().map(|s| (s.name.clone(), s.kind, last_line(s))).collect()
    }

    #[test]
    fn subprograms_end_at_label_0_and_repeated_parts_at_their_call() {
        let text = "BEGIN PGM A MM\nTOOL CALL 1 Z S1000\nLBL 1\nL IX+1\nCALL LBL 1 REP 3\nTOOL CALL 2 Z\n\
                    L X+1\nM30\nLBL 7\nL Y+1\nLBL 8\nL Y+2\nLBL 0\nEND PGM A MM\n";
        let expected = [
            ("A", TextSymbolKind::Program, "END PGM A MM"),
            ("TOOL CALL 1 Z S1000", TextSymbolKind::Tool, "CALL LBL 1 REP 3"),
            ("LBL 1", TextSymbolKind::Label, "CALL LBL 1 REP 3"),
            ("TOOL CALL 2 Z", TextSymbolKind::Tool, "M30"),
            ("LBL 7", TextSymbolKind::Subprogram, "LBL 0"),
            ("LBL 8", TextSymbolKind::Label, "LBL 8"),
        ];
        let expected =
            expected.map(|(name, kind, last)| (name.to_string(), kind, last.to_string()));
        assert_eq!(bodies(text), expected);
    }

    #[test]
    fn half_a_text_has_an_outline() {
        let found = bodies("BEGIN PGM A MM\nLBL \"SIDE\"\nL X+1\nTOOL CALL 3 Z\nL X+2");
        assert_eq!(found[0].2, "L X+2");
        assert_eq!(found[1], ("LBL \"SIDE\"".into(), TextSymbolKind::Label, "LBL \"SIDE\"".into()));
        assert_eq!(found[2].2, "L X+2");
    }
}
