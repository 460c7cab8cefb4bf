// Which part of the path is shown.

/** What of the path is shown; what is not said is all. */
export interface VisibleSection {
  tool?: number;
  /** Lines of the program, from and to, both counted. */
  lines?: [number, number];
  /** Lowest and highest place, in the frame of the run, mm. */
  depth?: [number, number];
}
