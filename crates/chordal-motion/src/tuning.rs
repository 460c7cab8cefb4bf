//! The numbers by which the planner chooses: each with its unit, and why it has this value.
//!
//! What only rounding or an algorithm needs is next to the code that uses it. Whoever changes a number here runs
//! `cargo test -p chordal --test motion_table -- --nocapture` and the example `dense`, whose tables are in `docs/motion.md`.

/// How far the planner looks ahead, and when it plans curves.
#[derive(Debug)]
pub(crate) struct PlannerTuning {
    /// Shorter moves are left out, mm or rad: the direction of such a move would be rounding.
    pub shortest_move: f64,
    /// The largest gap between two moves that is closed without an error, mm or rad. Coordinates are rounded
    /// to a micrometre or so, and ends of arcs are computed.
    pub closed_gap: f64,
    /// Pieces of a look-ahead window, planned corner by corner. It ends earlier where the axes rest; a longer one is
    /// emitted as far as later moves cannot change it. It bounds the memory, and is far longer than a braking
    /// distance.
    pub window_pieces: usize,
    /// Moves of a group at least that is planned as curves. Fewer are planned corner by corner. The value is chosen, not
    /// measured: so few moves hardly ever approximate a curve.
    pub min_group_moves: usize,
    /// Moves of a group that are looked at to see whether it is dense. The rest of a group whose first moves are long is not
    /// dense either, and need not wait in memory.
    pub sampled_group_moves: usize,
    /// Moves of a group at most: those before its last corner are planned then. A surface without a corner is
    /// bounded in memory, and the one rest that this may cost is hundredths of a second in minutes.
    pub max_group_moves: usize,
    /// Moves of a group are dense where they take less than this on average at their feeds, s. The corners of longer ones are best
    /// passed each by itself.
    pub dense_move_s: f64,
    /// Curves that take no more times as long as without jerk, and less than with stops, are taken without a plan of
    /// corners to compare with. Corners were quicker than such curves by half a percent at most.
    pub curve_always_faster_below: f64,
    /// How far above the least time a profile of a curve may be, as a share of it: at the fast level and at the best. The first
    /// is about what grid intervals of the usual length cost; the second needs intervals of a quarter of it.
    pub profile_gaps: [f64; 2],
    /// The curves among which the quickest is looked for.
    pub curves: CurveTuning,
}

/// Where runs of a curve end, and which curves are solved.
#[derive(Debug)]
pub(crate) struct CurveTuning {
    /// The cosine of 75 degrees: a joint at which the chords turn by more is a corner, where the axes rest and
    /// the movements may overlap. That is quicker than a curve around a sharp corner.
    pub corner_cosine: f64,
    /// The cosine of 40 degrees: a run that turns by more is also planned with corners there, and the quicker
    /// is taken. Between the two angles either may be.
    pub bend_cosine: f64,
    /// The direction of chords shorter than the tolerance is looked at over so many tolerances: over less it would be the
    /// rounding of coordinates. Of corners nearer to each other than that only the sharpest is one.
    pub look_tolerances: f64,
    /// Tolerances, mm. All that are lower than that of the path are candidates as well, so that more tolerance is not
    /// slower: what a lower one allows a larger one allows, too. They are the usual steps 1, 2, 5.
    pub tolerance_ladder_mm: [f64; 9],
    /// The share of the tolerance that the chords of an arc may take. The curve has the rest, so it should be
    /// small; and the chords grow in number with the root of its inverse.
    pub arc_chord_share: f64,
    /// Chords of a group at most: an arc of metres within a nanometre would have millions.
    pub max_group_chords: usize,
    /// A run that takes no more times as long as at its feeds is not planned with more corners: they cannot gain more.
    pub at_feed_factor: f64,
    /// Of curves of one kind those are solved whose first profiles take no longer than the least of them by this share.
    /// A first profile takes 8 to 23 % longer than the quickest one, and those of one kind by much the same share.
    pub kind_window: f64,
    /// Curves of a kind are solved where its least first profile takes no longer than the other kind's by this share. The
    /// first profiles of different kinds tell less about each other.
    pub rival_window: f64,
    /// The same two shares for runs that take no longer than `short_run_s`, s: their profiles cost little.
    pub short_kind_window: f64,
    pub short_rival_window: f64,
    pub short_run_s: f64,
    /// Where the first profiles of a step of the ladder take longer by this share than the least, those of lower steps do,
    /// too: the ladder ends.
    pub ladder_stop_share: f64,
    /// Of what a run takes longer than at its feed another curve gains no more than about this share. A tenth was the
    /// most that was measured.
    pub max_gain_share: f64,
    /// What cannot gain more than this share of the time is not looked for; in runs of more than `long_run_chords` chords,
    /// where every candidate takes long to solve, than `long_negligible_gain`.
    pub negligible_gain: f64,
    pub long_negligible_gain: f64,
    pub long_run_chords: usize,
}

/// The numbers in use.
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
