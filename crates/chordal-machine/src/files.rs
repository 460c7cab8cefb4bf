//! Relative file names.

/// Whether a character separates folders in a name.
pub(crate) fn is_separator(c: char) -> bool {
    c == '/' || c == '\\'
}

/// A name relative to the folder of a file, unless the name is absolute.
pub(crate) fn in_folder_of(file: &str, name: &str) -> String {
    let rooted = name.starts_with(is_separator) || name.as_bytes().get(1) == Some(&b':');
    match file.rfind(is_separator) {
        Some(end) if !rooted => format!("{}{name}", &file[..=end]),
        _ => name.to_string(),
    }
}
