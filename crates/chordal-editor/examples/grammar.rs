//! Prints editors/vscode/syntaxes/nc.tmLanguage.json.

fn main() {
    println!("{:#}", chordal_editor::grammar());
}
