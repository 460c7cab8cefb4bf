// How the language server is started. Knows nothing of the editor, so that tests can use it.

/** What the settings say. */
export interface Settings {
  /** The chordal program, by name or path. */
  command: string;
  /** A built-in machine or a machine file; empty for none. */
  machine: string;
}

/** The program and its arguments. */
export function serverCommand(settings: Settings): { command: string; args: string[] } {
  return { command: settings.command.trim() || "chordal", args: ["lsp", "--stdio"] };
}

/** What the server gets at its start. */
export function initializationOptions(settings: Settings): { machine?: string } {
  const machine = settings.machine.trim();
  return machine === "" ? {} : { machine };
}

/** What to tell a user whose server does not start. */
export function startFailure(command: string, reason: string): string {
  return `Chordal does not start (${command}: ${reason}). Install it, or set "chordal.command" to its path.`;
}
