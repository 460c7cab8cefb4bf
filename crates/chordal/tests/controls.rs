//! Every place where a control must appear, and the one list that they are held against.

#![allow(clippy::disallowed_methods, reason = "reads the tree of the workspace")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use chordal::Machine;
use chordal::control::{CONTROLS, Control, configured_control, control_profile, table};
use chordal::machine::ControlName;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The folders within a folder of the tree.
fn folders(of: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(root().join(of)).expect("the folder is there");
    let folders = entries.map(|entry| entry.expect("an entry").path()).filter(|path| path.is_dir());
    folders.map(|path| path.file_name().expect("a name").to_string_lossy().into_owned()).collect()
}

#[test]
fn the_list_of_controls_is_that_of_their_folders() {
    let listed: BTreeSet<String> =
        with_tables().map(|name| name.as_str().replace('-', "_")).collect();
    assert_eq!(listed, folders("crates/chordal-dialect/src/controls"));
    assert_eq!(CONTROLS.len(), with_tables().count());
    for name in with_tables() {
        assert_eq!(table(name).expect("a table").name, name.as_str());
    }
}

/// The controls with word-address blocks.
fn with_tables() -> impl Iterator<Item = ControlName> {
    ControlName::ALL.iter().copied().filter(|name| table(*name).is_some())
}

#[test]
fn a_control_of_another_language_has_a_machine_and_a_source() {
    for name in ControlName::ALL.iter().filter(|name| table(**name).is_none()) {
        let profile = control_profile(*name).expect("a language reads it");
        let machine = Machine::from_builtin(profile.default_machine)
            .unwrap_or_else(|errors| panic!("{name}: {errors:?}"));
        assert_eq!(machine.control, *name, "{name}: its default machine is of another control");
        let (_, errors) = configured_control(&machine).expect("a language reads it");
        assert!(errors.is_empty(), "{name}: {errors:?}");
        assert!(!profile.title.is_empty() && !profile.source.is_empty(), "{name}");
    }
}

#[test]
fn a_control_has_a_machine_signs_a_source_and_a_post() {
    for name in with_tables() {
        let table = table(name).expect("a table");
        let machine = Machine::from_builtin(table.default_machine)
            .unwrap_or_else(|errors| panic!("{name}: {errors:?}"));
        assert_eq!(machine.control, name, "{name}: its default machine is of another control");
        assert!(
            Control::of(&machine).expect("a word-address control").1.is_empty(),
            "{name}: settings that it does not have"
        );
        assert!(!table.title.is_empty() && !table.source.is_empty(), "{name}: title and source");
        assert!(!table.evidence.is_empty(), "{name}: nothing to recognize its programs by");
        assert!(!table.post.begin.is_empty() && !table.post.end.is_empty(), "{name}: its post");
    }
}

#[test]
fn examples_of_a_control_have_a_title_in_the_gallery() {
    let gallery = fs::read_to_string(root().join("web/gallery.ts")).expect("it is there");
    let examples = folders("examples");
    for name in ControlName::ALL.iter().map(|name| name.as_str()) {
        let is_titled = gallery.contains(&format!("\"{name}\": \""));
        assert!(is_titled || !examples.contains(name), "web/gallery.ts: no title for {name}");
    }
}

#[test]
fn a_control_has_programs_in_the_suite_and_a_page_of_its_codes() {
    let suite = folders("tests/suite");
    for name in with_tables() {
        assert!(suite.contains(name.as_str()), "tests/suite/{name}: no programs");
        let page = root().join(format!("docs/reference/controls/{name}.md"));
        assert!(page.is_file(), "{}: no page", page.display());
    }
}
