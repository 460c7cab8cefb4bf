//! The page and the picture files have the same colours.

#![allow(clippy::disallowed_methods, reason = "a test reads the file that it checks")]

#[test]
fn the_page_has_the_colours_of_the_picture_files() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../web/src/view/palette.ts");
    let page = std::fs::read_to_string(path).unwrap_or_default();
    assert_eq!(
        page,
        chordal_export::palette_typescript(),
        "write it anew: cargo run -p chordal-export --example palette > web/src/view/palette.ts"
    );
}
