//! What pictures and drawings say of axes that a program does not name, and of moves that they leave out.

use chordal::control::{AxisMask, WorkName, WorkNaming};
use chordal::path::{NotNamed, UnrelatedZero};

/// `Y is never named; drawn at Y0`, `Z is not known in any cut; drawn at Z0`.
pub fn not_named_texts(axes: NotNamed) -> Vec<String> {
    let stated = |axes: AxisMask, why: &str| {
        let letters: Vec<String> = axes.iter().map(|axis| axis.letter().to_string()).collect();
        let zeros: Vec<String> = letters.iter().map(|letter| format!("{letter}0")).collect();
        let verb = if letters.len() == 1 { "is" } else { "are" };
        let text =
            || format!("{} {verb} {why}; drawn at {}", letters.join(" and "), zeros.join(" "));
        (!letters.is_empty()).then(text)
    };
    let both = [stated(axes.never, "never named"), stated(axes.in_no_cut, "not known in any cut")];
    both.into_iter().flatten().collect()
}

/// What to do about moves in a work offset that is not given.
pub const GIVE_OFFSETS: &str = "give both in `[work_offsets]` of the machine file, or with `--set`";

/// `moves in G55 are left out: where it lies from G54 is not given`: moves in work offsets of which nobody knows how they lie
/// to that of the first cut. Moves in machine coordinates go to the machine's own places, and nothing is said of them.
pub fn left_out_texts(zeros: &[UnrelatedZero], naming: WorkNaming) -> Vec<String> {
    let mut texts = Vec::new();
    let (presets, offsets): (Vec<&UnrelatedZero>, Vec<_>) = zeros
        .iter()
        .filter(|zero| zero.system != WorkName::Machine)
        .partition(|zero| zero.is_preset);
    if let Some(first) = offsets.first() {
        let of_run = first.run_system.key(naming);
        let (systems, verb) = listed(&offsets, naming);
        let pronoun = if verb == "lies" { "it" } else { "they" };
        texts.push(format!(
            "moves in {systems} are left out: where {pronoun} {verb} from {of_run} is not given"
        ));
    }
    if !presets.is_empty() {
        let (systems, _) = listed(&presets, naming);
        texts.push(format!(
            "moves in {systems} are left out: the tool was at an unknown place when zero was set there"
        ));
    }
    texts
}

/// `G55, G56 and G57`, and the verb that goes with one or several.
fn listed(zeros: &[&UnrelatedZero], naming: WorkNaming) -> (String, &'static str) {
    let mut systems: Vec<WorkName> = Vec::new();
    for zero in zeros {
        if !systems.contains(&zero.system) {
            systems.push(zero.system);
        }
    }
    let names: Vec<String> = systems.iter().map(|name| name.key(naming)).collect();
    match names.split_last() {
        Some((last, before)) if !before.is_empty() => {
            (format!("{} and {last}", before.join(", ")), "lie")
        }
        _ => (names.concat(), "lies"),
    }
}
