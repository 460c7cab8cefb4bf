//! Converts between paths and file URIs such as `file:///shop/part%20one.nc`, `file:///c%3A/shop/part.nc` and
//! `file://server/shop/part.nc`.

use std::ffi::OsString;
use std::path::PathBuf;

const WINDOWS: bool = cfg!(windows);

/// The URI of a file; `None` when its path is not absolute.
pub fn address_of(file: &str) -> Option<String> {
    address(file, WINDOWS)
}

/// The path of a file URI; `None` when it is not a file on this computer or, on Windows, on a network share.
pub fn path_of(address: &str) -> Option<PathBuf> {
    let bytes = path(address, WINDOWS)?;
    #[cfg(unix)]
    let path = <OsString as std::os::unix::ffi::OsStringExt>::from_vec(bytes);
    #[cfg(not(unix))]
    let path = OsString::from(String::from_utf8(bytes).ok()?);
    Some(PathBuf::from(path))
}

fn address(file: &str, windows: bool) -> Option<String> {
    if !windows {
        return file.starts_with('/').then(|| format!("file://{}", encoded(file)));
    }
    let file = file.replace('\\', "/");
    // The verbatim form of Windows paths: `\\?\C:\shop`, `\\?\UNC\server\shop`.
    let plain = file.strip_prefix("//?/UNC/").map(|share| format!("//{share}"));
    let plain = plain.unwrap_or_else(|| file.strip_prefix("//?/").unwrap_or(&file).to_string());
    match plain.strip_prefix("//") {
        Some(share) => Some(format!("file://{}", encoded(share))),
        None if has_drive(plain.as_bytes()) => Some(format!("file:///{}", encoded(&plain))),
        None => None,
    }
}

fn path(address: &str, windows: bool) -> Option<Vec<u8>> {
    let (scheme, rest) = address.split_once(':')?;
    let rest = rest.split(['?', '#']).next().unwrap_or_default();
    if !scheme.eq_ignore_ascii_case("file") || !rest.starts_with('/') {
        return None;
    }
    let (host, path) = match rest.strip_prefix("//") {
        Some(rest) => rest.split_at(rest.find('/')?),
        None => ("", rest),
    };
    let host = if host.eq_ignore_ascii_case("localhost") { "" } else { host };
    let path = decoded(path);
    if !windows {
        return host.is_empty().then_some(path);
    }
    let path = match host {
        "" if has_drive(path.get(1..)?) => path[1..].to_vec(),
        "" => return None,
        host => [b"//", host.as_bytes(), &path].concat(),
    };
    Some(path.into_iter().map(|byte| if byte == b'/' { b'\\' } else { byte }).collect())
}

/// Whether the path begins with a drive, such as `C:/`.
fn has_drive(path: &[u8]) -> bool {
    matches!(path, [letter, b':', b'/', ..] if letter.is_ascii_alphabetic())
}

fn encoded(path: &str) -> String {
    let mut text = String::with_capacity(path.len());
    for byte in path.bytes() {
        match byte {
            b'/' | b'-' | b'.' | b'_' | b'~' | b':' => text.push(char::from(byte)),
            _ if byte.is_ascii_alphanumeric() => text.push(char::from(byte)),
            _ => text.push_str(&format!("%{byte:02X}")),
        }
    }
    text
}

fn decoded(text: &str) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let digit = |place: usize| char::from(*after.get(place)?).to_digit(16);
        match (first, digit(0), digit(1)) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((high * 16 + low) as u8);
                rest = &after[2..];
            }
            _ => {
                bytes.push(first);
                rest = after;
            }
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn both_ways(file: &str, named: &str, windows: bool) {
        assert_eq!(address(file, windows).as_deref(), Some(named));
        assert_eq!(path(named, windows).as_deref(), Some(file.as_bytes()));
    }

    #[test]
    fn files_of_this_machine() {
        both_ways("/shop/O77.nc", "file:///shop/O77.nc", false);
        both_ways("/a b/50%/#1?/Stück.nc", "file:///a%20b/50%25/%231%3F/St%C3%BCck.nc", false);
        assert_eq!(path("FILE://localhost/a.nc", false), Some(b"/a.nc".to_vec()));
        assert_eq!(path("file:/a%2Enc", false), Some(b"/a.nc".to_vec()));
        assert_eq!(path("file:///a%zz%2", false), Some(b"/a%zz%2".to_vec()));
        assert_eq!(address("O77.nc", false), None);
        for other in ["untitled:Untitled-1", "file://server/a.nc", "file:a.nc", "a.nc", ""] {
            assert_eq!(path(other, false), None, "{other}");
        }
    }

    #[test]
    fn drives_and_shares() {
        both_ways(r"C:\shop\a b.nc", "file:///C:/shop/a%20b.nc", true);
        both_ways(r"\\server\shop\a.nc", "file://server/shop/a.nc", true);
        assert_eq!(path("file:///c%3A/shop/a.nc", true), Some(br"c:\shop\a.nc".to_vec()));
        assert_eq!(address(r"\\?\C:\a.nc", true).as_deref(), Some("file:///C:/a.nc"));
        assert_eq!(address(r"\\?\UNC\server\a.nc", true).as_deref(), Some("file://server/a.nc"));
        assert_eq!(address(r"shop\a.nc", true), None);
        assert_eq!(path("file:///shop/a.nc", true), None);
    }
}
