//! Checks that `docs/compare.md` lists the categories of the code.

#![allow(clippy::disallowed_methods, reason = "reads a document")]

#[test]
fn the_document_lists_the_items() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/compare.md");
    let page = std::fs::read_to_string(file).expect("the page is there");
    let (_, rest) = page.split_once("<!-- shared:").expect("the mark");
    let (_, rest) = rest.split_once("-->\n").expect("the mark ends");
    let (listed, _) = rest.split_once("<!-- end -->").expect("the table ends");
    let reference = chordal_compare::shared_reference();
    assert!(listed == reference, "put this behind `<!-- shared:`:\n{reference}");
}
