//! Files are whole or as before, and stay what they are.

#![cfg(unix)]
#![allow(clippy::disallowed_methods, clippy::disallowed_types, reason = "looks at files")]

use std::fs::{self, File};
use std::io::{Read, Write};
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::Command;

use chordal_files::{FileDraft, is_regular, is_same, write_whole};

fn names(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        names.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_file_keeps_its_mode() {
    let folder = tempfile::tempdir().unwrap();
    for mode in [0o600, 0o640, 0o755, 0o666] {
        let path = folder.path().join("part.nc");
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
        write_whole(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, mode);
    }
    assert_eq!(names(folder.path()), ["part.nc"]);
}

#[test]
fn a_link_stays_a_link() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("deep")).unwrap();
    fs::write(at("deep/real.nc"), "old").unwrap();
    symlink("deep/real.nc", at("link.nc")).unwrap();
    symlink("link.nc", at("again.nc")).unwrap();
    symlink("deep/none.nc", at("loose.nc")).unwrap();
    symlink("circle.nc", at("circle.nc")).unwrap();
    write_whole(&at("again.nc"), b"new").unwrap();
    write_whole(&at("loose.nc"), b"made").unwrap();
    assert!(write_whole(&at("circle.nc"), b"x").is_err());
    assert_eq!(fs::read(at("deep/real.nc")).unwrap(), b"new");
    assert_eq!(fs::read(at("deep/none.nc")).unwrap(), b"made");
    for link in ["again.nc", "link.nc", "loose.nc"] {
        assert!(at(link).is_symlink(), "{link}");
        assert!(at(link).canonicalize().unwrap().starts_with(at("deep").canonicalize().unwrap()));
    }
    assert_eq!(names(&at("deep")), ["none.nc", "real.nc"]);
}

#[test]
fn what_is_no_file_is_written_through() {
    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let read = {
        let pipe = pipe.clone();
        std::thread::spawn(move || {
            let mut text = String::new();
            File::open(pipe).unwrap().read_to_string(&mut text).unwrap();
            text
        })
    };
    write_whole(&pipe, b"through").unwrap();
    assert_eq!(read.join().unwrap(), "through");
    assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
    let link = folder.path().join("null");
    symlink("/dev/null", &link).unwrap();
    write_whole(&link, b"nowhere").unwrap();
    write_whole(Path::new("/dev/null"), b"nowhere").unwrap();
    assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    let full = write_whole(Path::new("/dev/full"), b"too much").unwrap_err();
    assert_eq!(full.kind(), std::io::ErrorKind::StorageFull);
    for own in ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"] {
        assert!(!is_regular(Path::new(own)), "{own}");
    }
    assert!(write_whole(folder.path(), b"x").is_err(), "a folder");
    assert_eq!(names(folder.path()), ["null", "pipe"]);
}

#[test]
fn a_draft_that_is_not_put_is_gone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("new/part.nc");
    let mut draft = FileDraft::open(&path).unwrap();
    draft.write_all(b"half").unwrap();
    assert_eq!(names(&folder.path().join("new")).len(), 1);
    drop(draft);
    assert!(names(&folder.path().join("new")).is_empty());
}

#[test]
fn names_of_one_file() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("a.nc"), "a").unwrap();
    fs::write(at("b.nc"), "a").unwrap();
    fs::hard_link(at("a.nc"), at("hard.nc")).unwrap();
    symlink("a.nc", at("soft.nc")).unwrap();
    assert!(is_same(&at("a.nc"), &at("./a.nc")));
    assert!(is_same(&at("a.nc"), &at("hard.nc")) && is_same(&at("soft.nc"), &at("hard.nc")));
    assert!(!is_same(&at("a.nc"), &at("b.nc")) && !is_same(&at("a.nc"), &at("none.nc")));
    assert!(is_same(&at("none.nc"), &at("./none.nc")));
}
