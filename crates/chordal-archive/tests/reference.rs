//! Checks that `docs/archives.md` lists the columns of the code.

#![allow(clippy::disallowed_methods, reason = "reads a document")]

#[test]
fn the_document_lists_the_columns() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/archives.md");
    let page = std::fs::read_to_string(file).expect("the page is there");
    let tables = [
        ("<!-- columns:", chordal_archive::archive_reference()),
        ("<!-- diff columns:", chordal_archive::diff::diff_reference()),
    ];
    for (mark, reference) in tables {
        let (_, rest) = page.split_once(mark).expect(mark);
        let (_, rest) = rest.split_once("-->\n").expect("the mark ends");
        let (listed, _) = rest.split_once("<!-- end -->").expect("the table ends");
        assert!(listed == reference, "put this behind `{mark}`:\n{reference}");
    }
}
