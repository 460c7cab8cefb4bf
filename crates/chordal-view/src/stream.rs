//! A path on its way to the page: rows go out in batches while they are made.

use chordal::Segment;
use serde_json::{Value, json};

use crate::columns::Columns;
use crate::outbox::Outbox;
use crate::wanted::Wanted;

/// Rows of the first batch: soon there, and most programs are no longer.
const FIRST_BATCH: usize = 4_096;

/// Rows of later batches, so that the page is not busy with any one of them for long.
const BATCH: usize = 32_768;

/// Most pieces of path that are sent. What comes after is run and judged, not drawn.
pub const MOST_ROWS: u32 = 8_000_000;

/// Sends the rows of a path.
pub struct PathStream<'m> {
    /// What each batch says in addition to its rows.
    header: Value,
    out: &'m Outbox,
    wanted: &'m Wanted,
    is_given_up: bool,
    /// Bytes of the program's text.
    size: f64,
    rows: Columns,
    sent: u32,
    left_out: u64,
}

impl<'m> PathStream<'m> {
    /// The path of a program whose text has so many bytes, in these columns.
    pub fn new(
        header: Value,
        size: usize,
        rows: Columns,
        out: &'m Outbox,
        wanted: &'m Wanted,
    ) -> PathStream<'m> {
        PathStream {
            header,
            out,
            wanted,
            is_given_up: false,
            size: size.max(1) as f64,
            rows,
            sent: 0,
            left_out: 0,
        }
    }

    /// Rows so far, those that wait for their batch included.
    pub fn sent(&self) -> u32 {
        self.sent
    }

    /// Rows beyond what is sent.
    pub fn left_out(&self) -> u64 {
        self.left_out
    }

    /// Nobody wants the rest.
    pub fn is_given_up(&self) -> bool {
        self.is_given_up
    }

    /// Adds a row.
    pub fn push(&mut self, segment: &Segment, inserted: bool) {
        if self.sent >= MOST_ROWS {
            self.left_out += 1;
            return;
        }
        self.rows.push(segment, inserted);
        self.sent += 1;
        let full = if self.sent as usize <= FIRST_BATCH { FIRST_BATCH } else { BATCH };
        if self.rows.rows() >= full {
            self.is_given_up = !self.wanted.is_wanted();
            if !self.is_given_up {
                // Calls and loops go back in the text: the page shows the largest it has seen.
                let at = f64::from(segment.origin.span.range.end) / self.size;
                self.send(at.min(1.0));
            }
        }
    }

    /// Sends what waits; the last batch has the progress 1.
    pub fn send(&mut self, progress: f64) {
        let mut header = self.header.clone();
        header["first"] = json!(self.sent - self.rows.rows() as u32);
        header["progress"] = json!(progress);
        self.out.binary(self.rows.take(&header));
    }
}
