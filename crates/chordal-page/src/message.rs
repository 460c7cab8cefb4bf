//! A message of JavaScript: four bytes with the length of a JSON object, the object, then the bytes that it names, in
//! their order.

use serde::Deserialize;
use serde::de::DeserializeOwned;

/// What a view begins with.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Begin {
    /// The name of the program, for messages and for what lies next to it.
    pub name: String,
    /// The bytes of the program; a view that works for another one has none of its own.
    pub program: Option<usize>,
    /// What lies next to it: subprograms, machine and setup files, what these name.
    pub files: Vec<File>,
    /// The machine that it runs on unless the page chooses another one: a name, or the path of a file.
    pub machine: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct File {
    pub path: String,
    pub bytes: usize,
}

/// The object of a message, and where what comes after it begins.
pub fn read<T: DeserializeOwned>(bytes: &[u8]) -> Result<(T, usize), String> {
    let (length, rest) = bytes.split_first_chunk::<4>().ok_or("the message ends too early")?;
    let length = u32::from_le_bytes(*length) as usize;
    let object = rest.get(..length).ok_or("the message ends too early")?;
    let object = serde_json::from_slice(object)
        .map_err(|error| format!("the message cannot be read: {error}"))?;
    Ok((object, 4 + length))
}

/// Bytes from a place to a place, in the memory of the message: a long text is not copied.
pub fn cut(mut bytes: Vec<u8>, from: usize, to: usize) -> Vec<u8> {
    bytes.truncate(to);
    bytes.drain(..from.min(to));
    bytes
}

/// The next bytes of a message.
pub fn take(rest: &mut &[u8], length: usize) -> Result<Vec<u8>, String> {
    let (taken, more) = rest.split_at_checked(length).ok_or("the message ends too early")?;
    *rest = more;
    Ok(taken.to_vec())
}
