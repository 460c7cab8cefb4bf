//! Names that go from one text to another.

use chordal::diagnostics::FileId;

use crate::{EditorProgram, NameOccurrence, NameRole, SymbolName};

/// A place of a name in one of the texts of a program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OccurrenceInFile {
    /// The text, as a job numbers them: 0 is the program's own.
    pub file: FileId,
    /// The place in it.
    pub place: NameOccurrence,
}

impl SymbolName {
    /// True for a name that means the same in every text: a program, a named subroutine, a
    /// variable of all programs.
    fn is_of_all_texts(&self) -> bool {
        match self {
            SymbolName::Program(_) => true,
            SymbolName::Subroutine(label) => label.starts_with('<'),
            SymbolName::Variable { program, .. } => program.is_none(),
            SymbolName::Label { .. } | SymbolName::LineLabel(_) => false,
        }
    }
}

impl EditorProgram {
    /// Where a name of this text is made: in this text, or else in the files of its folder.
    pub fn definitions(&self, name: &SymbolName) -> Vec<OccurrenceInFile> {
        let made = |found: &OccurrenceInFile| found.place.role == NameRole::Definition;
        let own: Vec<OccurrenceInFile> =
            self.places_in(FileId(0), name).into_iter().filter(made).collect();
        let subroutine = matches!(name, SymbolName::Subroutine(_));
        if !own.is_empty() || !(subroutine || name.is_of_all_texts()) {
            return own;
        }
        self.others().flat_map(|file| self.places_in(file, name)).filter(made).collect()
    }

    /// Everywhere that a name of this text stands.
    pub fn references(&self, name: &SymbolName) -> Vec<OccurrenceInFile> {
        let mut places = self.places_in(FileId(0), name);
        if name.is_of_all_texts() {
            places.extend(self.others().flat_map(|file| self.places_in(file, name)));
        }
        places
    }

    fn others(&self) -> impl Iterator<Item = FileId> {
        (1..=self.setup().subprogram_texts.len() as u32).map(FileId)
    }

    fn places_in(&self, file: FileId, name: &SymbolName) -> Vec<OccurrenceInFile> {
        let places = match file {
            FileId(0) => self.places_of(name),
            _ => self.with_text(self.file_text(file).to_vec()).places_of(name),
        };
        places.into_iter().map(|place| OccurrenceInFile { file, place }).collect()
    }
}
