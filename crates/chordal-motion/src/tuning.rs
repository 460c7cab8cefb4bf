//! The constants on which the planner's choices depend: each with its unit, and why it has this value.
//!
//! Constants that concern only rounding or one algorithm are next to the code that uses them. After a change here run
//! `cargo test -p chordal --test motion_table -- --nocapture` and the example `dense`, whose tables are in `docs/motion.md`.

/// How far the planner looks ahead, and when it plans curves.
#[derive(Debug)]
pub(crate) struct PlannerTuning {
    /// Shorter moves are ignored, mm or rad: the direction of such a move would be rounding.
    pub shortest_move: f64,
    /// The largest gap between two moves that is closed without an error, mm or rad. Coordinates are rounded
    /// to a micrometre or so, and ends of arcs are computed.
    pub closed_gap: f64,
    /// The largest number of pieces of a look-ahead window that is planned corner by corner. The window ends earlier
    /// where the axes rest; of a longer one the part that later moves cannot change is emitted. This bounds the memory,
    /// and is far longer than a braking distance.
    pub window_pieces: usize,
    /// The smallest number of moves of a group that is planned as curves; smaller groups are planned corner by corner. The
    /// value is chosen, not measured: so few moves hardly ever approximate a curve.
    pub min_group_moves: usize,
    /// How many moves of a group decide whether it is dense. If these are long, the rest of the group is taken to be so,
    /// too, and need not wait in memory.
    pub sampled_group_moves: usize,
    /// The largest number of moves of a group: at this number those before its last corner are planned. It bounds the
    /// memory for a surface without a corner; the one rest that it may add costs hundredths of a second in minutes.
    pub max_group_moves: usize,
    /// A group is dense if its moves take less than this on average at their feeds, s. With longer moves it is best to
    /// blend each corner by itself.
    pub dense_move_s: f64,
    /// A curve is taken without planning corners for comparison if it takes less time than stops at all corners, and at most
    /// this many times the time bound without jerk. Corners were quicker than such curves by 0.5 % at most.
    pub curve_always_faster_below: f64,
    /// By which fraction the profile of a curve may exceed the least time, at the levels fast and best. The first is about
    /// what grid intervals of the usual length cost; the second needs intervals of a quarter of that length.
    pub profile_gaps: [f64; 2],
    /// Which curves are compared to find the quickest.
    pub curves: CurveTuning,
}

/// Where curves end at corners, and of which curves the profile is solved.
#[derive(Debug)]
pub(crate) struct CurveTuning {
    /// The cosine of 75 degrees: a joint at which the chords turn by more is a corner, where the axes rest and
    /// the movements may overlap. That is quicker than a curve around a sharp corner.
    pub corner_cosine: f64,
    /// The cosine of 40 degrees: a run with joints that turn by more is also planned with corners there, and the quicker
    /// plan is taken. Between the two angles either may be quicker.
    pub bend_cosine: f64,
    /// The direction at a joint of chords shorter than the tolerance is measured over this many tolerances: over less it
    /// would be the rounding of coordinates. Of corners nearer to each other than that only the sharpest counts.
    pub look_tolerances: f64,
    /// Tolerances in the usual steps 1, 2, 5, mm. Those below the tolerance of the path are candidates, too, so that a larger
    /// tolerance is never slower: a curve within a small tolerance is within a larger one.
    pub tolerance_ladder_mm: [f64; 9],
    /// The fraction of the tolerance that replacing an arc by chords may use; the curve has the rest. The number of chords
    /// grows with the square root of its inverse.
    pub arc_chord_share: f64,
    /// The largest number of chords of a group: an arc of metres within a nanometre would have millions.
    pub max_group_chords: usize,
    /// A run that takes at most this many times its time at the feeds is not planned with more corners: they could gain no
    /// more than the difference.
    pub at_feed_factor: f64,
    /// Of the curves of one kind those are solved whose initial profiles exceed the shortest of them by at most this
    /// fraction. An initial profile takes 8 to 23 % longer than the quickest one, and those of one kind much the same.
    pub kind_window: f64,
    /// Curves of a kind are solved if its shortest initial profile exceeds that of the other kind by at most this fraction.
    /// It is larger, since initial profiles of different kinds are less comparable.
    pub rival_window: f64,
    /// `kind_window` for runs of up to `short_run_s` s, whose profiles are cheap to solve; `short_rival_window` likewise.
    pub short_kind_window: f64,
    pub short_rival_window: f64,
    pub short_run_s: f64,
    /// If the initial profiles of one tolerance of the ladder exceed the shortest one by this fraction, those of smaller
    /// tolerances do so, too, and are not tried.
    pub ladder_stop_share: f64,
    /// The largest fraction of the time beyond that at the feeds which another curve is expected to gain; 0.1 was the
    /// largest measured.
    pub max_gain_share: f64,
    /// A candidate that cannot gain more than this fraction of the time is not tried; in runs of more than `long_run_chords`
    /// chords, where each candidate is expensive, the fraction is `long_negligible_gain`.
    pub negligible_gain: f64,
    pub long_negligible_gain: f64,
    pub long_run_chords: usize,
}

/// The values in use.
pub(crate) const TUNING: PlannerTuning = PlannerTuning {
    shortest_move: 1e-9,
    closed_gap: 1e-6,
    window_pieces: 8192,
    min_group_moves: 8,
    sampled_group_moves: 4096,
    max_group_moves: 50_000,
    dense_move_s: 0.04,
    curve_always_faster_below: 1.5,
    profile_gaps: [2e-4, 5e-5],
    curves: CurveTuning {
        corner_cosine: 0.258_819_045_102_521,
        bend_cosine: 0.766_044_443_118_978,
        look_tolerances: 4.0,
        tolerance_ladder_mm: [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5],
        arc_chord_share: 1.0 / 32.0,
        max_group_chords: 400_000,
        at_feed_factor: 1.02,
        kind_window: 0.005,
        rival_window: 0.02,
        short_kind_window: 0.03,
        short_rival_window: 0.05,
        short_run_s: 0.5,
        ladder_stop_share: 0.02,
        max_gain_share: 0.2,
        negligible_gain: 2e-4,
        long_negligible_gain: 4e-3,
        long_run_chords: 2000,
    },
};
