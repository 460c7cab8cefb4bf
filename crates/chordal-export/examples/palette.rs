//! Prints web/src/view/palette.ts.

fn main() {
    print!("{}", chordal_export::palette_typescript());
}
