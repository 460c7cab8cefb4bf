//! What gathers rows for a batch of columns.

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};

/// Rows that are gathered before they are emitted, and the rows of a batch of an Arrow file.
pub(crate) const BATCH: usize = 1 << 13;

/// What gathers rows and gives them as a batch when it is asked.
pub trait RowBatcher {
    /// Rows gathered since the last batch.
    fn rows(&self) -> usize;

    /// The columns, with their units and what they come from.
    fn schema(&self) -> &SchemaRef;

    /// The columns that the rows have as text: all of them, as a rule.
    fn text_columns(&self) -> Vec<String> {
        self.schema().fields().iter().map(|field| field.name().clone()).collect()
    }

    /// The first of its JSON lines, where the others are objects of these columns.
    fn json_header(&self) -> Option<Vec<u8>> {
        None
    }

    /// The rows gathered so far; the next begin anew.
    ///
    /// # Errors
    /// A row without a number where its column must have one.
    fn take(&mut self) -> Result<RecordBatch, ArrowError>;
}
