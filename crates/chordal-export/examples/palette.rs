//! Prints web/src/palette.ts.

fn main() {
    print!("{}", chordal_export::palette_typescript());
}
