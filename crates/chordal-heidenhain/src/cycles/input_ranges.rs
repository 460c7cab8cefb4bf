//! What the control accepts as data of cycles (TNC 640 cycle programming 34059x, "input range" of each parameter).

/// Data that cannot be negative: clearances, infeeds, feeds, dwells, sizes, numbers of operations.
const NOT_NEGATIVE: [u32; 22] = [
    200, 202, 205, 206, 207, 208, 209, 210, 211, 212, 213, 220, 222, 223, 253, 254, 255, 256, 257,
    334, 335, 338,
];

/// Data that choose one of some cases, and the smallest and the largest.
const CHOICES: [(u32, i32, i32); 5] =
    [(214, 0, 4), (215, 0, 2), (301, 0, 1), (343, 0, 1), (351, -1, 1)];

/// What the control accepts for a parameter of a cycle, where a value is not; `None` for one that it takes.
pub fn refused_range(parameter: u32, value: f64) -> Option<String> {
    if NOT_NEGATIVE.contains(&parameter) && value < 0.0 {
        return Some("0 or more".to_string());
    }
    let (_, least, most) = CHOICES.iter().find(|(number, ..)| *number == parameter)?;
    let is_choice = value.fract() == 0.0 && (f64::from(*least)..=f64::from(*most)).contains(&value);
    (!is_choice).then(|| format!("a whole number from {least} to {most}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_outside_of_their_range_are_refused() {
        assert_eq!(refused_range(202, -4.0).as_deref(), Some("0 or more"));
        assert_eq!(refused_range(214, 5.0).as_deref(), Some("a whole number from 0 to 4"));
        assert_eq!(refused_range(351, -1.0), None);
        assert_eq!(refused_range(201, -10.0), None);
    }
}
