//! A message: four bytes with the length of a JSON object, the object, then the bytes that it names, in their order.

use std::fmt;

use serde::de::DeserializeOwned;

/// A message as it is read.
#[derive(Debug)]
pub struct MemoryMessage {
    bytes: Vec<u8>,
    /// The first byte that was not read yet.
    at: usize,
}

/// What is wrong with a message: it does not come from our JavaScript, or from that of another version.
#[derive(Debug, PartialEq, Eq)]
pub struct TornMessage(String);

impl fmt::Display for TornMessage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl TornMessage {
    fn too_short() -> TornMessage {
        TornMessage("ends too early".into())
    }
}

impl MemoryMessage {
    /// Reads the object of a message.
    ///
    /// # Errors
    /// Bytes that are no message.
    pub fn read<T: DeserializeOwned>(bytes: Vec<u8>) -> Result<(T, MemoryMessage), TornMessage> {
        let (length, rest) = bytes.split_first_chunk::<4>().ok_or_else(TornMessage::too_short)?;
        let length = u32::from_le_bytes(*length) as usize;
        let object = rest.get(..length).ok_or_else(TornMessage::too_short)?;
        let object = serde_json::from_slice(object)
            .map_err(|error| TornMessage(format!("cannot be read: {error}")))?;
        Ok((object, MemoryMessage { bytes, at: 4 + length }))
    }

    /// The next bytes.
    ///
    /// # Errors
    /// Fewer are left.
    pub fn take(&mut self, length: usize) -> Result<Vec<u8>, TornMessage> {
        let end = self.at.checked_add(length).ok_or_else(TornMessage::too_short)?;
        let taken = self.bytes.get(self.at..end).ok_or_else(TornMessage::too_short)?.to_vec();
        self.at = end;
        Ok(taken)
    }

    /// All that is left, in the memory of the message: a long text is not copied.
    #[must_use]
    pub fn rest(mut self) -> Vec<u8> {
        self.bytes.drain(..self.at);
        self.bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(object: &str, rest: &str) -> Vec<u8> {
        let length = u32::try_from(object.len()).unwrap();
        [&length.to_le_bytes(), object.as_bytes(), rest.as_bytes()].concat()
    }

    #[test]
    fn an_object_and_the_bytes_that_it_names_are_read_in_order() {
        let (lengths, mut read) =
            MemoryMessage::read::<Vec<usize>>(message("[2,0,3]", "G0X1.")).unwrap();
        let taken: Vec<_> = lengths.into_iter().map(|length| read.take(length).unwrap()).collect();
        assert_eq!(taken, [b"G0".to_vec(), Vec::new(), b"X1.".to_vec()]);
        assert_eq!(read.take(1), Err(TornMessage::too_short()));
        assert_eq!(read.take(usize::MAX), Err(TornMessage::too_short()));
        assert_eq!(read.rest(), b"");
        let (_, mut read) = MemoryMessage::read::<Vec<usize>>(message("[2]", "G0X1.")).unwrap();
        read.take(2).unwrap();
        assert_eq!(read.rest(), b"X1.");
    }

    #[test]
    fn bytes_that_are_no_message_are_refused() {
        let read = |bytes: &[u8]| {
            MemoryMessage::read::<Vec<usize>>(bytes.to_vec()).map(|(object, _)| object)
        };
        for bytes in [&b""[..], b"\x01", b"\xff\xff\xff\xff[]", b"\x03\0\0\0[]"] {
            assert_eq!(read(bytes), Err(TornMessage::too_short()), "{bytes:?}");
        }
        let wrong = read(&message("[1e9]", "")).unwrap_err().to_string();
        assert!(wrong.starts_with("cannot be read: invalid type"), "{wrong}");
    }
}
