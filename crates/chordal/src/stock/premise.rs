//! The stock of a run: that of the setup, or else the one that the program defines or a comment of it describes.

use std::borrow::Cow;

use chordal_diagnostics::{Code, Diagnostic, FileId, Span};
use chordal_machine::{Axis, Body, BodyShape};

use super::run::StockRunError;
use crate::job::Job;
use crate::tool_comments::{StockPlace, commented_stock};

/// The stock of a run, and where it was taken from.
pub(super) struct StockPremise<'a> {
    pub body: Cow<'a, Body>,
    /// The words of the program that say so; `None` where a setup or machine file does.
    pub source: Option<StockSource>,
}

/// The words of a program from which its stock was taken.
#[derive(Clone, Copy, Debug)]
pub(super) struct StockSource {
    /// Where they stand.
    span: Span,
    /// What they are, for messages.
    name: &'static str,
}

impl StockPremise<'_> {
    /// The note that the stock is that of the program; `None` where it is not.
    pub fn note(&self) -> Option<Diagnostic> {
        let source = self.source?;
        let message =
            format!("the stock is taken from this {}: {}", source.name, sides(&self.body));
        let help = "give `[stock]` in a setup file, named with --setup, to use another one";
        Some(Diagnostic::new(Code::StockFromComment, source.span, message).help(help))
    }

    /// The warning that a program's own stock is not the one that the program cuts, since no cut removes any of it;
    /// `None` otherwise.
    pub fn doubt(&self, removed_mm3: f64, cuts: bool) -> Option<Diagnostic> {
        let source = self.source.filter(|_| cuts && removed_mm3 <= 0.0)?;
        let message = format!("no cut meets the stock of this {}", source.name);
        let help = "it may be of another program: give `[stock]` in a setup file";
        Some(Diagnostic::new(Code::StockCommentDoubted, source.span, message).help(help))
    }
}

impl Job<'_> {
    /// Whether there is a stock: of the setup, or of the program.
    pub fn has_stock(&self) -> bool {
        self.stock_premise().is_ok()
    }

    pub(super) fn stock_premise(&self) -> Result<StockPremise<'_>, StockRunError> {
        if let Some(body) = &self.machine().setup.stock {
            return Ok(StockPremise { body: Cow::Borrowed(body), source: None });
        }
        let text = self.sources().get(FileId(0)).map(|source| source.text());
        let defined = text.and_then(|text| self.configured_control().defined_stock(text));
        if let Some((body, range)) = defined {
            let source = StockSource { span: range.in_file(FileId(0)), name: "block" };
            return Ok(StockPremise { body: Cow::Owned(body), source: Some(source) });
        }
        let commented = commented_stock(self).ok_or(StockRunError::NoStock)?;
        match commented.place {
            StockPlace::Body(body) => {
                let source = StockSource { span: commented.comment, name: "comment" };
                Ok(StockPremise { body: Cow::Owned(*body), source: Some(source) })
            }
            StockPlace::Size(size) => Err(StockRunError::StockNotPlaced(size)),
        }
    }
}

/// The extent of a body for a message: `X 0 to 100, Y 0 to 60, Z -20 to 0 mm`.
fn sides(body: &Body) -> String {
    let rounded = |value: f64| (value * 1000.0).round() / 1000.0 + 0.0;
    let along = |axis: usize| {
        let (from, to) = (body.from[axis].unwrap_or(0.0), body.to[axis].unwrap_or(0.0));
        format!("{} {} to {}", ["X", "Y", "Z"][axis], rounded(from), rounded(to))
    };
    match (body.shape, body.diameter_mm) {
        (Some(BodyShape::Cylinder | BodyShape::Tube), Some(diameter)) => {
            let bore = body.bore_mm.map(|bore| format!(", bore {}", rounded(bore)));
            let ends = along(body.axis.unwrap_or(Axis::Z) as usize);
            format!("diameter {}{}, {ends} mm", rounded(diameter), bore.unwrap_or_default())
        }
        _ => format!("{}, {}, {} mm", along(0), along(1), along(2)),
    }
}
