//! Maps of heights of any text: a surface with finite heights, or an error that says where.

#![no_main]

use chordal_rewrite::HeightMap;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| match HeightMap::read(bytes, 25.4) {
    Ok(map) => {
        let [low, high] = map.range();
        assert!(low.is_finite() && low <= high);
        let [x, y] = map.bounds();
        for at in [[x[0], y[0]], [x[1], y[1]], [0.5 * (x[0] + x[1]), 0.3 * y[0] + 0.7 * y[1]]] {
            let height = map.height(at);
            let slack = 1e-9 * low.abs().max(high.abs()).max(1.0);
            assert!(height >= low - slack && height <= high + slack);
        }
    }
    Err(error) => assert!(!error.what.is_empty() && !error.help.is_empty()),
});
