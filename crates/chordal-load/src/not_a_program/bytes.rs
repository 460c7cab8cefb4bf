//! Recognizes kinds of files by their first bytes.

use super::FileKind;

/// The first bytes of a file, and its kind.
const ROWS: &[(&[u8], FileKind)] = &[
    (b"CDF\x01", NETCDF),
    (b"CDF\x02", NETCDF),
    (b"CDF\x05", NETCDF),
    (b"\x89HDF\r\n\x1a\n", binary("a NetCDF data file (HDF5)")),
    (b"\x89PNG", binary("a picture (PNG)")),
    (b"\xFF\xD8\xFF", binary("a picture (JPEG)")),
    (b"GIF87a", binary("a picture (GIF)")),
    (b"GIF89a", binary("a picture (GIF)")),
    (b"II*\0", binary("a picture (TIFF)")),
    (b"MM\0*", binary("a picture (TIFF)")),
    (b"%PDF-", binary("a PDF document")),
    (b"{\\rtf", binary("an RTF document").help("save it as plain text")),
    (b"\xD0\xCF\x11\xE0", binary("a document of an office program").help("save it as plain text")),
    (b"PK\x03\x04", ZIP),
    (b"PK\x05\x06", ZIP),
    (b"\x1F\x8B\x08", binary("a gzip archive").help(UNPACK)),
    (b"BZh", binary("a bzip2 archive").help(UNPACK)),
    (b"\xFD7zXZ", binary("an xz archive").help(UNPACK)),
    (b"7z\xBC\xAF", binary("a 7-Zip archive").help(UNPACK)),
    (b"Rar!\x1A", binary("a RAR archive").help(UNPACK)),
    (b"\x7FELF", binary("an executable")),
    (b"MZ\x90\0", binary("an executable")),
    (b"glTF", binary("a 3D model (GLB)")),
    (b"AC10", binary("a drawing (DWG)")),
    (b"SQLite format 3\0", binary("a database (SQLite)")),
    // The first block of a tape is its header: 19 bytes, flag 0.
    (b"\x13\0\0", binary("a tape of a ZX Spectrum")),
];

const NETCDF: FileKind = binary("a NetCDF data file");
const ZIP: FileKind = binary("a ZIP archive").help(UNPACK);
const UNPACK: &str = "unpack it, and give the program in it";

const fn binary(what: &'static str) -> FileKind {
    FileKind::new(what).certain()
}

/// The kind of a file that begins with these bytes; `None` when unknown.
pub(super) fn kind_of(text: &[u8]) -> Option<&'static FileKind> {
    ROWS.iter().find(|(first, _)| text.starts_with(first)).map(|(_, kind)| kind)
}
