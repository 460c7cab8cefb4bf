/** Why there is no answer. Problems of a program are diagnostics, not this. */
export class ChordalError extends Error {
  override readonly name = "ChordalError";

  constructor(
    /**
     * `use`: a wrong argument; `file`: a file that is not among those given; `machine`: a machine that
     * cannot be used; `inside`: Chordal itself failed, and the next call works; `closed`: the worker was closed.
     */
    readonly kind: "use" | "file" | "machine" | "inside" | "closed",
    message: string,
    /** What to do. */
    readonly help?: string,
  ) {
    super(message);
  }
}
