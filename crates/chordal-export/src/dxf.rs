use std::io::{self, Write};

use chordal::Segment;

/// Under construction.
#[derive(Debug)]
pub struct Dxf<W> {
    out: W,
}

impl<W: Write> Dxf<W> {
    /// Writes the header.
    pub fn new(out: W) -> io::Result<Self> {
        Ok(Self { out })
    }

    /// Writes a segment.
    pub fn segment(&mut self, _segment: &Segment) -> io::Result<()> {
        Ok(())
    }

    /// Writes what is left and gives the output back.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }
}
