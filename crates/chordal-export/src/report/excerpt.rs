//! The lines around spans, cut to what fits on a screen.

use std::ops::Range;

use annotate_snippets::{Annotation, AnnotationKind, Snippet};
use chordal::diagnostics::{FileId, TextRange};
use chordal::{Source, SourceMap, Span};

/// Characters shown on either side of the words.
const CONTEXT_CHARS: usize = 60;
/// The longest words that are shown whole.
const MAX_SHOWN_CHARS: usize = 160;
/// Lines this near to each other are shown as one piece.
const MERGE_LINES: u32 = 3;

/// Words to underline.
#[derive(Clone, Debug)]
pub(crate) struct ExcerptMark {
    pub span: Span,
    pub text: String,
    pub primary: bool,
}

/// Consecutive lines of one file with marks in them.
#[derive(Debug)]
struct SourceExcerpt {
    file: FileId,
    first_line: u32,
    text: String,
    marks: Vec<(Range<usize>, String, bool)>,
    corrections: Vec<ColumnCorrection>,
}

/// A column as the renderer counts it in a cut line, and as it is in the text.
#[derive(Debug)]
struct ColumnCorrection {
    line: u32,
    shown: usize,
    column: u32,
}

/// The excerpts of a problem, the one with the cause first.
#[derive(Debug, Default)]
pub(crate) struct ProblemExcerpts {
    excerpts: Vec<SourceExcerpt>,
}

impl ProblemExcerpts {
    /// Cuts the lines of all marks out of their texts.
    pub fn new(marks: &[ExcerptMark], sources: &SourceMap) -> ProblemExcerpts {
        let mut places: Vec<(FileId, u32, &ExcerptMark)> = marks
            .iter()
            .filter(|mark| mark.span != Span::default())
            .filter_map(|mark| {
                let source = sources.get(mark.span.file)?;
                let inside = mark.span.range.start as usize <= source.text().len();
                inside.then(|| (mark.span.file, source.line_of(mark.span.range.start), mark))
            })
            .collect();
        places.sort_by_key(|(file, line, _)| (*file, *line));
        let mut excerpts: Vec<SourceExcerpt> = Vec::new();
        for group in places.chunk_by(|a, b| a.0 == b.0 && b.1 - a.1 <= MERGE_LINES) {
            if let Some(source) = sources.get(group[0].0) {
                excerpts.push(SourceExcerpt::new(group, source));
            }
        }
        excerpts.sort_by_key(|excerpt| !excerpt.marks.iter().any(|mark| mark.2));
        ProblemExcerpts { excerpts }
    }

    /// As annotated snippets.
    pub fn snippets<'s>(
        &'s self,
        sources: &'s SourceMap,
    ) -> impl Iterator<Item = Snippet<'s, Annotation<'s>>> {
        self.excerpts.iter().map(move |excerpt| {
            let annotations = excerpt.marks.iter().map(|(range, text, primary)| {
                let kind = if *primary { AnnotationKind::Primary } else { AnnotationKind::Context };
                let label = (!text.is_empty()).then_some(text.as_str());
                kind.span(range.clone()).label(label)
            });
            let name = sources.get(excerpt.file).map(Source::name);
            Snippet::source(excerpt.text.as_str())
                .line_start(excerpt.first_line as usize)
                .path(name)
                .fold(false)
                .annotations(annotations)
        })
    }

    /// Puts the true columns of cut lines into the rendered text.
    pub fn correct(&self, mut text: String, sources: &SourceMap) -> String {
        for excerpt in &self.excerpts {
            let name = sources.get(excerpt.file).map_or("", Source::name);
            for ColumnCorrection { line, shown, column } in &excerpt.corrections {
                let wrong = format!("{name}:{line}:{shown}\n");
                text = text.replacen(&wrong, &format!("{name}:{line}:{column}\n"), 1);
            }
        }
        text
    }

    /// The first line of the first excerpt, its text and the range of its first mark.
    pub fn first(&self) -> Option<(u32, &str, Range<usize>)> {
        let excerpt = self.excerpts.first()?;
        Some((excerpt.first_line, &excerpt.text, excerpt.marks.first()?.0.clone()))
    }
}

impl SourceExcerpt {
    fn new(group: &[(FileId, u32, &ExcerptMark)], source: &Source) -> SourceExcerpt {
        let (file, first_line, _) = group[0];
        let last_line = group[group.len() - 1].1;
        let (text, marks, corrections) = Default::default();
        let mut excerpt = SourceExcerpt { file, first_line, text, marks, corrections };
        for line in first_line..=last_line {
            let marks: Vec<&ExcerptMark> =
                group.iter().filter(|place| place.1 == line).map(|place| place.2).collect();
            if line > first_line {
                excerpt.text.push('\n');
            }
            excerpt.line(source, line, &marks);
        }
        excerpt
    }

    /// Appends a line, cut around its marks.
    fn line(&mut self, source: &Source, line: u32, marks: &[&ExcerptMark]) {
        let start = source.line_start(line);
        let bytes = source.line_text(line);
        let local = |range: TextRange| {
            let from = (range.start.saturating_sub(start) as usize).min(bytes.len());
            let to = (range.end.saturating_sub(start) as usize).clamp(from, bytes.len());
            from..to
        };
        let chosen = marks.iter().find(|mark| mark.primary).or(marks.first());
        let focus = chosen.map_or(0..0, |mark| local(mark.span.range));
        let window = LineWindow::new(bytes, focus);
        if let Some(mark) = chosen
            && window.text.starts_with('…')
        {
            let at = window.map(local(mark.span.range)).start;
            let shown = window.text[..at].chars().count() + 1;
            let column = source.line_column(mark.span.range.start).column;
            self.corrections.push(ColumnCorrection { line, shown, column });
        }
        let base = self.text.len();
        self.text.push_str(&window.text);
        for mark in marks {
            let range = window.map(local(mark.span.range));
            let range = base + range.start..base + range.end;
            self.marks.push((range, mark.text.clone(), mark.primary));
        }
    }
}

/// A piece of a line as text, and where its bytes went.
struct LineWindow {
    text: String,
    /// Offset in the line and in `text` of each character, in order, and of the end.
    places: Vec<(usize, usize)>,
}

impl LineWindow {
    fn new(line: &[u8], focus: Range<usize>) -> LineWindow {
        // A character has at most four bytes; the surplus is cut by characters below.
        let reach = 4 * (CONTEXT_CHARS + 1);
        let focus = focus.start..focus.end.min(focus.start + MAX_SHOWN_CHARS);
        let mut from = focus.start.saturating_sub(reach);
        while from > 0 && line.get(from).is_some_and(|byte| byte & 0xC0 == 0x80) {
            from += 1;
        }
        let to = (focus.end + reach).min(line.len());
        let characters = decode(&line[from..to], from);
        let before = characters.iter().filter(|(at, _)| *at < focus.start).count();
        let until = characters.iter().filter(|(at, _)| *at < focus.end).count();
        let short = from == 0 && to == line.len() && characters.len() <= 2 * CONTEXT_CHARS;
        let first = if short { 0 } else { before.saturating_sub(CONTEXT_CHARS) };
        let last =
            if short { characters.len() } else { (until + CONTEXT_CHARS).min(characters.len()) };
        let cut_before = from > 0 || first > 0;
        let cut_after = to < line.len() || last < characters.len();
        let end = characters.get(last).map_or(to, |(at, _)| *at);
        LineWindow::of(&characters[first..last], end, cut_before, cut_after)
    }

    fn of(
        characters: &[(usize, char)],
        end: usize,
        cut_before: bool,
        cut_after: bool,
    ) -> LineWindow {
        let mut text = String::new();
        if cut_before {
            text.push('…');
        }
        let mut places = Vec::with_capacity(characters.len() + 1);
        for (at, character) in characters {
            places.push((*at, text.len()));
            text.push(*character);
        }
        places.push((end, text.len()));
        if cut_after {
            text.push('…');
        }
        LineWindow { text, places }
    }

    /// A range of the line's bytes in the text; the nearest edge where it was cut.
    fn map(&self, range: Range<usize>) -> Range<usize> {
        let at = |offset: usize| {
            let index = self.places.partition_point(|(at, _)| *at < offset);
            self.places[index.min(self.places.len() - 1)].1
        };
        let start = at(range.start);
        start..at(range.end).max(start)
    }
}

/// The characters of some bytes with their offsets; each byte that is none becomes `�`, and
/// a tab a space, so that a column stays a column.
fn decode(bytes: &[u8], base: usize) -> Vec<(usize, char)> {
    let mut characters = Vec::with_capacity(bytes.len());
    let mut at = base;
    for chunk in bytes.utf8_chunks() {
        for (offset, character) in chunk.valid().char_indices() {
            let shown = match character {
                '\t' => ' ',
                other if other.is_control() => '�',
                other => other,
            };
            characters.push((at + offset, shown));
        }
        at += chunk.valid().len();
        for offset in 0..chunk.invalid().len() {
            characters.push((at + offset, '�'));
        }
        at += chunk.invalid().len();
    }
    characters
}

#[cfg(test)]
mod tests {
    use super::*;

    fn window(line: &[u8], focus: Range<usize>) -> (String, String) {
        let window = LineWindow::new(line, focus.clone());
        let range = window.map(focus);
        let words = window.text[range].to_string();
        (window.text, words)
    }

    #[test]
    fn a_short_line_is_whole() {
        assert_eq!(window(b"G1 X1. Y2.", 3..6), ("G1 X1. Y2.".into(), "X1.".into()));
    }

    #[test]
    fn a_long_line_is_cut_on_both_sides() {
        let mut line = vec![b'a'; 1_000_000];
        line[500_000..500_004].copy_from_slice(b"X12.");
        let (text, words) = window(&line, 500_000..500_004);
        assert_eq!(words, "X12.");
        assert_eq!(text.chars().count(), 60 + 4 + 60 + 2);
        assert!(text.starts_with('…') && text.ends_with('…'));
    }

    #[test]
    fn long_words_are_cut_too() {
        let line = vec![b'a'; 10_000];
        let (text, words) = window(&line, 0..10_000);
        assert_eq!((words.len(), text.chars().count()), (160 + 60, 160 + 60 + 1));
    }

    #[test]
    fn foreign_bytes_do_not_shift_the_words() {
        assert_eq!(window(b"(\xD8\xFF) X1", 5..7), ("(��) X1".into(), "X1".into()));
        assert_eq!(window("(Ø) X1".as_bytes(), 5..7), ("(Ø) X1".into(), "X1".into()));
    }

    #[test]
    fn an_end_of_line_has_a_place() {
        assert_eq!(window(b"G1", 2..2), ("G1".into(), String::new()));
    }
}
