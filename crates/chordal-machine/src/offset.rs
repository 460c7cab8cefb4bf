//! Normalizes the names of work offsets.

/// The normalized name of a work offset in any spelling: `g54` is `G54`, `G54.1P01` and `G54 P1` are `G54.1 P1`, `G110`
/// is `G154 P1`, `e3` is `E3`. `None`: no such work offset.
///
/// The normalized names are: `G52`, `G54` to `G59`, `G59.1` to `G59.3`, `G54.1 P1` to `P300`, `G154 P1`
/// to `P99`, `G59 P7` to `P254`, `E1` to `E48`, `G505` to `G599`, `EXT` (the common shift of all of them), and `G54.2 P1` to
/// `P8`, the errors of clamped parts.
pub fn work_offset_name(text: &str) -> Option<String> {
    let text: String =
        text.chars().filter(|c| !c.is_whitespace()).map(|c| c.to_ascii_uppercase()).collect();
    if text == "EXT" {
        return Some(text);
    }
    if let Some(number) = text.strip_prefix('E') {
        let number = whole(number)?;
        return (1..=48).contains(&number).then(|| format!("E{number}"));
    }
    let code = text.strip_prefix('G')?;
    if let Some((code, number)) = code.split_once('P') {
        let number = whole(number)?;
        return match code {
            "54" | "54.1" if (1..=300).contains(&number) => Some(format!("G54.1 P{number}")),
            "54.2" if (1..=8).contains(&number) => Some(format!("G54.2 P{number}")),
            "59" if (1..=6).contains(&number) => Some(format!("G{}", number + 53)),
            "59" if (7..=254).contains(&number) => Some(format!("G59 P{number}")),
            "154" if (1..=99).contains(&number) => Some(format!("G154 P{number}")),
            _ => None,
        };
    }
    match code {
        "52" | "54" | "55" | "56" | "57" | "58" | "59" | "59.1" | "59.2" | "59.3" => {
            Some(format!("G{code}"))
        }
        _ => {
            let number = whole(code)?;
            if (505..=599).contains(&number) {
                return Some(format!("G{number}"));
            }
            (110..=129).contains(&number).then(|| format!("G154 P{}", number - 109))
        }
    }
}

fn whole(text: &str) -> Option<u32> {
    let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    digits.then(|| text.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::work_offset_name as name;

    #[test]
    fn one_name_each() {
        for (text, expected) in [
            ("G54", "G54"),
            ("g59.3", "G59.3"),
            ("G54.1 P1", "G54.1 P1"),
            ("G54.1P01", "G54.1 P1"),
            ("G54 P48", "G54.1 P48"),
            ("G54.2P1", "G54.2 P1"),
            ("G154P99", "G154 P99"),
            ("G110", "G154 P1"),
            ("g59 p7", "G59 P7"),
            ("G59P254", "G59 P254"),
            ("G59 P1", "G54"),
            ("G129", "G154 P20"),
            ("e1", "E1"),
            ("E48", "E48"),
            ("ext", "EXT"),
            ("G52", "G52"),
            ("g505", "G505"),
            ("G599", "G599"),
        ] {
            assert_eq!(name(text).as_deref(), Some(expected), "{text}");
        }
        for text in [
            "", "G", "G53", "G60", "G59.4", "G59 P0", "G59 P255", "E0", "E49", "E", "G154 P0",
            "G54 P", "G54.2 P9", "G54.2", "G130", "G504", "G600", "X",
        ] {
            assert_eq!(name(text), None, "{text}");
        }
    }
}
