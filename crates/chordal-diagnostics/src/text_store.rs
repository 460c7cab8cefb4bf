//! Stores texts that are added during a run while others are being read.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Mutex, PoisonError};

use crate::Source;

/// Limits on the number of different texts and on their total size, bytes, so that a run uses bounded memory.
const MAX_TEXTS: usize = 10_000;
const MAX_BYTES: usize = 64 << 20;

/// Texts that are never moved or removed, so that references to them stay valid.
#[derive(Debug, Default)]
pub(crate) struct AppendOnlyTexts {
    texts: boxcar::Vec<Source<'static>>,
    index: Mutex<TextIndex>,
}

#[derive(Debug, Default)]
struct TextIndex {
    by_hash: HashMap<u64, Vec<usize>>,
    bytes: usize,
}

impl AppendOnlyTexts {
    /// Stores a text once and returns its index; `None` when a limit is reached.
    pub fn place(&self, name: &str, text: &str) -> Option<usize> {
        let mut hasher = DefaultHasher::new();
        (name, text).hash(&mut hasher);
        let mut index = self.index.lock().unwrap_or_else(PoisonError::into_inner);
        let bytes = index.bytes + text.len();
        let same = index.by_hash.entry(hasher.finish()).or_default();
        let known = same.iter().copied().find(|place| {
            let source = &self.texts[*place];
            source.name() == name && source.text() == text.as_bytes()
        });
        if known.is_some() {
            return known;
        }
        if self.texts.count() >= MAX_TEXTS || bytes > MAX_BYTES {
            return None;
        }
        let place = self.texts.push(Source::new(name, text.as_bytes().to_vec()));
        same.push(place);
        index.bytes = bytes;
        Some(place)
    }

    pub fn get(&self, place: usize) -> Option<&Source<'static>> {
        self.texts.get(place)
    }

    pub fn iter(&self) -> impl Iterator<Item = &Source<'static>> {
        self.texts.iter().map(|(_, source)| source)
    }
}
