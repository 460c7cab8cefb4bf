//! Sends the rows of a path to the page, in batches, while they are computed.

use chordal::Segment;
use serde_json::{Value, json};

use crate::cancel_token::CancelToken;
use crate::columns::PathRows;
use crate::outbox::PageOutbox;

/// The rows of the first batch: few, so that it arrives soon; most programs have no more.
const FIRST_BATCH_ROWS: usize = 4_096;

/// The rows of later batches, limited so that none keeps the page busy for long.
const BATCH_ROWS: usize = 32_768;

/// The most path segments that are sent. Further ones are run and checked but not drawn.
pub const MAX_ROWS: u32 = 8_000_000;

/// Sends the rows of a path.
pub struct PathStream<'m> {
    /// The header of each batch.
    header: Value,
    out: &'m PageOutbox,
    cancel: &'m CancelToken,
    is_canceled: bool,
    /// The size of the program's text, bytes.
    size: f64,
    rows: PathRows,
    sent: u32,
    left_out: u64,
}

impl<'m> PathStream<'m> {
    /// A stream for the path of a program whose text has `size` bytes, in these columns.
    pub fn new(
        header: Value,
        size: usize,
        rows: PathRows,
        out: &'m PageOutbox,
        cancel: &'m CancelToken,
    ) -> PathStream<'m> {
        PathStream {
            header,
            out,
            cancel,
            is_canceled: false,
            size: size.max(1) as f64,
            rows,
            sent: 0,
            left_out: 0,
        }
    }

    /// The number of rows so far, including those of the batch that is not sent yet.
    pub fn sent(&self) -> u32 {
        self.sent
    }

    /// The number of rows beyond [`MAX_ROWS`].
    pub fn left_out(&self) -> u64 {
        self.left_out
    }

    /// Whether the run was canceled, so that no more rows are sent.
    pub fn is_canceled(&self) -> bool {
        self.is_canceled
    }

    /// Adds a row, and sends the batch when it is full.
    pub fn push(&mut self, segment: &Segment, inserted: bool) {
        if self.sent >= MAX_ROWS {
            self.left_out += 1;
            return;
        }
        self.rows.push(segment, inserted);
        self.sent += 1;
        let full =
            if self.sent as usize <= FIRST_BATCH_ROWS { FIRST_BATCH_ROWS } else { BATCH_ROWS };
        if self.rows.rows() >= full {
            self.is_canceled = !self.cancel.is_current();
            if !self.is_canceled {
                // Calls and loops go back in the text; the page shows the largest progress it has received.
                let at = f64::from(segment.origin.span.range.end) / self.size;
                self.send(at.min(1.0));
            }
        }
    }

    /// Sends the batch; the last one has the progress 1.
    pub fn send(&mut self, progress: f64) {
        let mut header = self.header.clone();
        header["first"] = json!(self.sent - self.rows.rows() as u32);
        header["progress"] = json!(progress);
        self.out.binary(self.rows.take(&header));
    }
}
