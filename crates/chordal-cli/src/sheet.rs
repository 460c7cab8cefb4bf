//! Text for people: rows with a label on the left, and tables.

use comfy_table::Table;

use crate::terminal::{BOLD, style};

/// Width of the labels on the left.
const LABEL: usize = 10;

/// Rows and tables one after the other.
pub struct Sheet {
    text: String,
    color: bool,
    /// Columns; without them rows are as long as they are.
    width: Option<usize>,
}

impl Sheet {
    /// A sheet under a heading. Rows that are longer than `width` columns are broken at spaces.
    pub fn new(heading: &str, width: Option<usize>, color: bool) -> Sheet {
        let text = format!("{}\n", style(color, BOLD, heading));
        Sheet { text, color, width }
    }

    /// The text that was written.
    pub fn into_text(self) -> String {
        self.text
    }

    /// An empty line.
    pub fn gap(&mut self) {
        self.text.push('\n');
    }

    /// A line at the left margin.
    pub fn line(&mut self, text: &str) {
        self.text.push_str(&format!("  {}\n", text.trim_end()));
    }

    /// A row with its label.
    pub fn row(&mut self, label: &str, text: &str) {
        self.row_in(BOLD, label, text);
    }

    /// A row, its label in a style.
    pub fn row_in(&mut self, code: &str, label: &str, text: &str) {
        let label = style(self.color, code, format_args!("{label:LABEL$}"));
        self.labelled(&label, text);
    }

    /// A row below another, without a label.
    pub fn more(&mut self, text: &str) {
        self.labelled(&" ".repeat(LABEL), text);
    }

    fn labelled(&mut self, label: &str, text: &str) {
        let Some(width) = self.width else {
            return self.text.push_str(&format!("  {label}{text}\n"));
        };
        let mut lines = wrapped(text, width - LABEL - 2).into_iter();
        self.text.push_str(&format!("  {label}{}\n", lines.next().unwrap_or_default()));
        for line in lines {
            self.text.push_str(&format!("  {:LABEL$}{line}\n", ""));
        }
    }

    /// Rows of which the first has the label.
    pub fn rows(&mut self, label: &str, rows: &[String]) {
        for (index, row) in rows.iter().enumerate() {
            if index == 0 { self.row(label, row) } else { self.more(row) }
        }
    }

    /// A table below an empty line, under a title if there is one; nothing without rows.
    pub fn table(&mut self, title: &str, table: &Table) {
        if table.is_empty() {
            return;
        }
        self.gap();
        if !title.is_empty() {
            self.text.push_str(&format!("  {}\n", style(self.color, BOLD, title)));
        }
        for line in table.lines() {
            self.line(&line);
        }
    }
}

/// Breaks a text at spaces.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let last = lines.len() - 1;
        let line = &mut lines[last];
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > width {
            lines.push(word.to_string());
        } else {
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    lines
}
