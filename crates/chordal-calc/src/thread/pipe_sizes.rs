//! Sizes and tolerances of pipe threads, as the standards list them.

/// A size of a pipe thread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PipeSize {
    /// `1 1/2`.
    pub name: &'static str,
    /// The size as a number.
    pub size: f64,
    pub tpi: f64,
    /// Outside diameter of the pipe, in (NPT), or major diameter, mm (G, R).
    pub major: f64,
    /// Hand-tight engagement L1, in (NPT), or gauge length, mm (R); 0 where there is no such taper
    /// thread.
    pub gauge: f64,
}

const fn size(name: &'static str, size: f64, tpi: f64, major: f64, gauge: f64) -> PipeSize {
    PipeSize { name, size, tpi, major, gauge }
}

/// ASME B1.20.1, table 2.
pub(super) const NPT: [PipeSize; 19] = [
    size("1/16", 0.0625, 27.0, 0.3125, 0.160),
    size("1/8", 0.125, 27.0, 0.405, 0.1615),
    size("1/4", 0.25, 18.0, 0.540, 0.2278),
    size("3/8", 0.375, 18.0, 0.675, 0.240),
    size("1/2", 0.5, 14.0, 0.840, 0.320),
    size("3/4", 0.75, 14.0, 1.050, 0.339),
    size("1", 1.0, 11.5, 1.315, 0.400),
    size("1 1/4", 1.25, 11.5, 1.660, 0.420),
    size("1 1/2", 1.5, 11.5, 1.900, 0.420),
    size("2", 2.0, 11.5, 2.375, 0.436),
    size("2 1/2", 2.5, 8.0, 2.875, 0.682),
    size("3", 3.0, 8.0, 3.5, 0.766),
    size("3 1/2", 3.5, 8.0, 4.0, 0.821),
    size("4", 4.0, 8.0, 4.5, 0.844),
    size("5", 5.0, 8.0, 5.563, 0.937),
    size("6", 6.0, 8.0, 6.625, 0.958),
    size("8", 8.0, 8.0, 8.625, 1.063),
    size("10", 10.0, 8.0, 10.75, 1.210),
    size("12", 12.0, 8.0, 12.75, 1.360),
];

/// ISO 228-1, table 1, with the gauge lengths of ISO 7-1.
pub(super) const G: [PipeSize; 22] = [
    size("1/16", 0.0625, 28.0, 7.723, 4.0),
    size("1/8", 0.125, 28.0, 9.728, 4.0),
    size("1/4", 0.25, 19.0, 13.157, 6.0),
    size("3/8", 0.375, 19.0, 16.662, 6.4),
    size("1/2", 0.5, 14.0, 20.955, 8.2),
    size("5/8", 0.625, 14.0, 22.911, 0.0),
    size("3/4", 0.75, 14.0, 26.441, 9.5),
    size("7/8", 0.875, 14.0, 30.201, 0.0),
    size("1", 1.0, 11.0, 33.249, 10.4),
    size("1 1/8", 1.125, 11.0, 37.897, 0.0),
    size("1 1/4", 1.25, 11.0, 41.910, 12.7),
    size("1 1/2", 1.5, 11.0, 47.803, 12.7),
    size("1 3/4", 1.75, 11.0, 53.746, 0.0),
    size("2", 2.0, 11.0, 59.614, 15.9),
    size("2 1/4", 2.25, 11.0, 65.710, 0.0),
    size("2 1/2", 2.5, 11.0, 75.184, 17.5),
    size("2 3/4", 2.75, 11.0, 81.534, 0.0),
    size("3", 3.0, 11.0, 87.884, 20.6),
    size("3 1/2", 3.5, 11.0, 100.330, 0.0),
    size("4", 4.0, 11.0, 113.030, 25.4),
    size("5", 5.0, 11.0, 138.430, 28.6),
    size("6", 6.0, 11.0, 163.830, 28.6),
];

/// Tolerances of ISO 228-1, mm: up to this size, Td2 of class A and TD2, Td, TD1.
pub(super) const TOLERANCES: [(f64, f64, f64, f64); 5] = [
    (0.125, 0.107, 0.214, 0.282),
    (0.375, 0.125, 0.250, 0.445),
    (0.875, 0.142, 0.284, 0.541),
    (2.0, 0.180, 0.360, 0.640),
    (6.0, 0.217, 0.434, 0.640),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_stand_once_and_in_order() {
        for table in [&NPT[..], &G[..]] {
            assert!(table.windows(2).all(|pair| pair[0].size < pair[1].size));
            assert!(table.windows(2).all(|pair| pair[0].major < pair[1].major));
        }
    }
}
