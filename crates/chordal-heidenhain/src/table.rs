//! The form of all tables of the control: `BEGIN name MM` or `INCH`, a line with the names of the columns at fixed
//! places, a line for each row, `[END]` (iTNC 530 user's manual 340 49x, 5.2 and 8.9).

/// A table.
#[derive(Clone, Debug)]
pub struct ControlTableText {
    /// Its name as its first line has it, in upper case.
    pub name: String,
    /// One unit of its lengths, mm.
    pub unit_mm: f64,
    columns: Vec<TableColumn>,
    rows: Vec<Vec<char>>,
}

/// A column: its name and the characters of a line that belong to it.
#[derive(Clone, Debug)]
struct TableColumn {
    name: String,
    start: usize,
    end: usize,
}

/// A row of a table.
#[derive(Clone, Copy, Debug)]
pub struct ControlTableRow<'t> {
    columns: &'t [TableColumn],
    letters: &'t [char],
}

impl ControlTableText {
    /// Reads a table; `None` for a text that does not begin like one.
    pub fn read(text: &[u8]) -> Option<ControlTableText> {
        // Names may have letters of any code page; columns are counted in characters.
        let text: String = text.iter().map(|byte| char::from(*byte)).collect();
        let mut lines = text.lines().map(|line| line.trim_end_matches('\r'));
        let first = lines.find(|line| !line.trim().is_empty())?.trim().to_ascii_uppercase();
        let name = first.strip_prefix("BEGIN ")?;
        let is_inch = name.contains(" INCH");
        let name = name.split(" MM").next()?.split(" INCH").next()?.trim().to_string();
        let columns = columns(lines.find(|line| !line.trim().is_empty())?);
        let rows = lines.take_while(|line| !line.trim_start().starts_with('['));
        let rows = rows.map(|line| line.chars().collect()).collect();
        let unit_mm = if is_inch { 25.4 } else { 1.0 };
        Some(ControlTableText { name, unit_mm, columns, rows })
    }

    /// Its rows.
    pub fn rows(&self) -> impl Iterator<Item = ControlTableRow<'_>> {
        self.rows.iter().map(|letters| ControlTableRow { columns: &self.columns, letters })
    }

    /// Whether it has a column.
    pub fn has_column(&self, name: &str) -> bool {
        self.columns.iter().any(|column| column.name.eq_ignore_ascii_case(name))
    }
}

impl ControlTableRow<'_> {
    /// What stands in a column; `None` for nothing.
    pub fn text(&self, name: &str) -> Option<String> {
        let column = self.columns.iter().find(|column| column.name.eq_ignore_ascii_case(name))?;
        let end = column.end.min(self.letters.len());
        let letters = self.letters.get(column.start.min(end)..end).unwrap_or_default();
        let text = letters.iter().collect::<String>().trim().to_string();
        (!text.is_empty()).then_some(text)
    }

    /// The number in a column.
    pub fn number(&self, name: &str) -> Option<f64> {
        let value: f64 = self.text(name)?.replace(',', ".").parse().ok()?;
        value.is_finite().then_some(value)
    }
}

/// The columns of a header line: each reaches to the start of the next.
fn columns(header: &str) -> Vec<TableColumn> {
    let mut found: Vec<TableColumn> = Vec::new();
    let mut at = 0;
    for name in header.split(' ') {
        let letters = name.chars().count();
        if letters > 0 {
            if let Some(last) = found.last_mut() {
                last.end = at;
            }
            found.push(TableColumn { name: name.to_string(), start: at, end: usize::MAX });
        }
        at += letters + 1;
    }
    found
}
