//! Prints docs/columns.md.

fn main() {
    print!("{}", chordal_export::column_reference());
}
