//! The grammar in the extension is the one that the tables give.

#[test]
#[allow(clippy::disallowed_methods, reason = "reads a file of the project")]
fn the_extension_has_the_grammar_of_the_tables() {
    let path =
        concat!(env!("CARGO_MANIFEST_DIR"), "/../../editors/vscode/syntaxes/nc.tmLanguage.json");
    let there = std::fs::read_to_string(path).expect("the grammar");
    assert_eq!(
        there.trim_end(),
        format!("{:#}", chordal_editor::grammar()),
        "write it anew: cargo run -p chordal-editor --example grammar > \
         editors/vscode/syntaxes/nc.tmLanguage.json"
    );
}
