//! Collects the built-in machines: every machine file in the folder of a control.

#![allow(clippy::disallowed_methods, reason = "a build script reads files")]

use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    let root =
        PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("cargo names the crate's folder"));
    let controls = root.join("../chordal-dialect/src/controls");
    // The controls of other languages have their machines in their crate.
    let own_crates = ["../chordal-sinumerik/machines", "../chordal-heidenhain/machines"];
    println!("cargo::rerun-if-changed={}", controls.display());
    let mut files: Vec<PathBuf> = Vec::new();
    for control in entries(&controls) {
        let machines = control.join("machines");
        if machines.is_dir() {
            files.extend(entries(&machines));
        }
    }
    for folder in own_crates.map(|folder| root.join(folder)) {
        println!("cargo::rerun-if-changed={}", folder.display());
        files.extend(entries(&folder));
    }
    files.retain(|file| file.extension().is_some_and(|ending| ending == "toml"));
    files.sort_by_key(|file| file.file_stem().map(ToOwned::to_owned));
    let mut text = String::from(
        "/// Names and texts of the built-in machines, by name.\nconst FILES: &[(&str, &str)] = &[\n",
    );
    for file in files {
        let name = file.file_stem().expect("a file has a name").to_string_lossy().into_owned();
        let path = fs::canonicalize(&file).expect("the file is there");
        text += &format!("    ({name:?}, include_str!({path:?})),\n");
    }
    text += "];\n";
    let out = PathBuf::from(env::var("OUT_DIR").expect("cargo names the folder for output"));
    fs::write(out.join("machines.rs"), text).expect("the list is written");
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    entries.map(|entry| entry.expect("an entry").path()).collect()
}
