//! The texts of a job.

use std::borrow::Cow;

use crate::text_store::AppendOnlyTexts;
use crate::{FileId, Source, Span};

/// The texts of a job, by [`FileId`].
#[derive(Debug, Default)]
pub struct SourceMap<'a> {
    sources: Vec<Source<'a>>,
    appended: AppendOnlyTexts,
}

impl<'a> SourceMap<'a> {
    /// An empty map.
    pub fn new() -> SourceMap<'a> {
        SourceMap::default()
    }

    /// Adds a text and returns its number. All texts must be added before the first one is appended.
    pub fn add(&mut self, source: Source<'a>) -> FileId {
        self.sources.push(source);
        FileId(self.sources.len() as u32 - 1)
    }

    /// Stores a text during a run and returns its number: the same number for the same name and text. `None` beyond
    /// 10,000 texts or 64 MiB.
    pub fn append(&self, name: &str, text: &str) -> Option<FileId> {
        let place = self.appended.place(name, text)?;
        u32::try_from(self.sources.len() + place).ok().map(FileId)
    }

    /// The texts that were appended, in order.
    pub fn appended(&self) -> impl Iterator<Item = &Source<'a>> {
        self.appended.iter().map(|source| -> &Source<'a> { source })
    }

    /// The text of a number; `None` when this map has no such text.
    pub fn get(&self, file: FileId) -> Option<&Source<'a>> {
        let place = file.0 as usize;
        self.sources.get(place).or_else(|| self.appended.get(place - self.sources.len()))
    }

    /// The texts that were added, in order.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &Source<'a>)> {
        self.sources.iter().enumerate().map(|(index, source)| (FileId(index as u32), source))
    }

    /// The words of a span as text; bytes that are not UTF-8 are replaced. Empty when there is no such text.
    pub fn words(&self, span: Span) -> Cow<'_, str> {
        self.get(span.file)
            .map_or(Cow::Borrowed(""), |s| String::from_utf8_lossy(span.range.slice(s.text())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_appended_text_is_kept_once_and_read_like_any() {
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.nc", &b"M120"[..]));
        let first = sources.append("M120", "G4 P1.");
        let source = first.and_then(|file| sources.get(file)).map(Source::text);
        assert_eq!((first, source), (Some(FileId(1)), Some(&b"G4 P1."[..])));
        assert_eq!(sources.append("M121", "G4 P1."), Some(FileId(2)));
        assert_eq!(sources.append("M120", "G4 P1."), first);
        assert_eq!(sources.append("M120", "G4 P2."), Some(FileId(3)));
        assert_eq!(sources.get(FileId(4)).map(Source::name), None);
        assert_eq!((sources.iter().count(), sources.appended().count()), (1, 3));
    }

    #[test]
    fn appended_texts_have_a_bound() {
        let sources = SourceMap::new();
        let half = "G1\n".repeat(12 << 20);
        assert!(sources.append("a", &half).is_some());
        assert!(sources.append("b", &half).is_none());
        assert!(sources.append("a", &half).is_some(), "it is there already");
        let most = (0..20_000).take_while(|n| sources.append("n", &n.to_string()).is_some());
        assert_eq!(most.count(), 9_999);
    }
}
