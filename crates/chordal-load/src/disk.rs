//! Reads from the disk, where a path may be anything: also a pipe without a writer, or an endless device.

use std::fs::{File, Metadata};
use std::io::{self, Read};
use std::path::Path;

use crate::ledger;

/// The largest file, bytes: positions in a text are 32-bit numbers.
pub(crate) const MAX_FILE_BYTES: u64 = u32::MAX as u64;

/// The most that is read from a pipe or a device (512 MiB): it has no known size and is kept in memory.
const MAX_STREAM_BYTES: u64 = 1 << 29;

/// Opens a file for reading and records it in the ledger. Returns its metadata as well.
pub(crate) fn open(path: &Path) -> io::Result<(File, Metadata)> {
    let file = opened(path)?;
    let about = file.metadata()?;
    if about.is_file() && about.len() > MAX_FILE_BYTES {
        return Err(too_large());
    }
    ledger::note_input(path);
    Ok((file, about))
}

/// Reads a whole file.
pub(crate) fn bytes(path: &Path) -> io::Result<Vec<u8>> {
    let (mut file, about) = open(path)?;
    if !about.is_file() {
        return stream(file);
    }
    let mut bytes = Vec::with_capacity(usize::try_from(about.len()).unwrap_or_default());
    file.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Reads a pipe or a device up to [`MAX_STREAM_BYTES`].
pub(crate) fn stream(reader: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    reader.take(MAX_STREAM_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_STREAM_BYTES { Err(endless()) } else { Ok(bytes) }
}

pub(crate) fn too_large() -> io::Error {
    io::Error::other("it is larger than 4 GiB; split the program")
}

fn endless() -> io::Error {
    let mebibytes = MAX_STREAM_BYTES >> 20;
    io::Error::other(format!(
        "it is a pipe or a device and gives more than {mebibytes} MiB; write it into a file"
    ))
}

#[cfg(not(unix))]
fn opened(path: &Path) -> io::Result<File> {
    File::open(path)
}

/// Opening a pipe waits for a writer, so it is done with a timeout.
#[cfg(unix)]
fn opened(path: &Path) -> io::Result<File> {
    use std::os::unix::fs::FileTypeExt;
    use std::sync::mpsc::channel;
    use std::time::Duration;

    const OPEN_TIMEOUT: Duration = Duration::from_secs(5);
    if !path.metadata().is_ok_and(|about| about.file_type().is_fifo()) {
        return File::open(path);
    }
    let (send, opened) = channel();
    let path = path.to_path_buf();
    std::thread::spawn(move || send.send(File::open(path)));
    let late = |_| io::Error::other("it is a pipe, and nobody writes into it");
    opened.recv_timeout(OPEN_TIMEOUT).map_err(late)?
}
