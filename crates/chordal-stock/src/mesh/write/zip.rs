//! Writes files to a zip archive without compression and dates, so that the same input gives the same bytes.

use super::{WriteError, count};

const LOCAL: u32 = 0x0403_4B50;
const CENTRAL: u32 = 0x0201_4B50;
const END: u32 = 0x0605_4B50;
/// Version of the format that a reader needs: 2.0.
const VERSION: u16 = 20;
/// Flag: names are UTF-8.
const FLAGS: u16 = 0x0800;
/// 1 January 1980, the first date of the format, in place of the true one.
const DATE: u16 = 0x0021;

/// An archive of files by name.
pub(super) fn stored(files: &[(&str, &[u8])]) -> Result<Vec<u8>, WriteError> {
    let mut bytes = Vec::new();
    let mut directory = Vec::new();
    for (name, content) in files {
        let offset = count("bytes", bytes.len())?;
        let about = about(name, content)?;
        word(&mut bytes, LOCAL);
        bytes.extend_from_slice(&about);
        bytes.extend_from_slice(name.as_bytes());
        bytes.extend_from_slice(content);

        word(&mut directory, CENTRAL);
        half(&mut directory, VERSION);
        directory.extend_from_slice(&about);
        // No extra field, no comment, first disc, no attributes.
        directory.extend_from_slice(&[0; 10]);
        word(&mut directory, offset);
        directory.extend_from_slice(name.as_bytes());
    }
    let start = count("bytes", bytes.len())?;
    let size = count("bytes", directory.len())?;
    bytes.append(&mut directory);
    word(&mut bytes, END);
    bytes.extend_from_slice(&[0; 4]);
    // The only writer that uses this adds three files.
    half(&mut bytes, files.len() as u16);
    half(&mut bytes, files.len() as u16);
    word(&mut bytes, size);
    word(&mut bytes, start);
    half(&mut bytes, 0);
    Ok(bytes)
}

/// The fields that the header of a file and its entry in the directory have in common.
fn about(name: &str, content: &[u8]) -> Result<Vec<u8>, WriteError> {
    let size = count("bytes", content.len())?;
    let mut bytes = Vec::new();
    // Method 0 is "stored", time 0 is midnight.
    for value in [VERSION, FLAGS, 0, 0, DATE] {
        half(&mut bytes, value);
    }
    for value in [crc32fast::hash(content), size, size] {
        word(&mut bytes, value);
    }
    // Names are a few letters long.
    half(&mut bytes, name.len() as u16);
    half(&mut bytes, 0);
    Ok(bytes)
}

fn word(bytes: &mut Vec<u8>, value: u32) {
    bytes.extend_from_slice(&value.to_le_bytes());
}

fn half(bytes: &mut Vec<u8>, value: u16) {
    bytes.extend_from_slice(&value.to_le_bytes());
}
