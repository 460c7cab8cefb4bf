// The examples: programs of every control, and what each shows. The file is made of the folder `examples` when the page is built.

/** The address of the examples, whose name changes with them. */
declare const EXAMPLES: string;

export interface Example {
  name: string;
  /** In a sentence. */
  shows: string;
  text: string;
  /** What lies next to it: path and text. */
  files: [string, string][];
  machine: string | null;
}

export interface ExampleGroup {
  title: string;
  /** The folder of the examples. */
  folder: string;
  examples: Example[];
}

/** The example of a path, as `haas/thread-mill.nc`. */
export function exampleAt(groups: ExampleGroup[], path: string): Example | undefined {
  const [folder, name] = path.split("/");
  return groups.find((group) => group.folder === folder)?.examples.find((example) => example.name === name);
}

let loaded: Promise<ExampleGroup[]> | undefined;

export function gallery(): Promise<ExampleGroup[]> {
  loaded ??= load().catch((error: unknown) => {
    // The next look may have more luck.
    loaded = undefined;
    throw error;
  });
  return loaded;
}

async function load(): Promise<ExampleGroup[]> {
  const response = await fetch(new URL(EXAMPLES, document.baseURI));
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
  return (await response.json()) as ExampleGroup[];
}
