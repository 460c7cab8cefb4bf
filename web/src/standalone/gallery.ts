// The example programs of every control. Their file is made from the folder `examples` when the page is built.

/** The address of that file; its name contains a hash of the content. */
declare const EXAMPLES: string;

export interface Example {
  name: string;
  /** What it demonstrates, in a sentence. */
  shows: string;
  text: string;
  /** Path and text of the files of its folder. */
  files: [string, string][];
  machine: string | null;
}

export interface ExampleGroup {
  title: string;
  /** The folder of the examples. */
  folder: string;
  examples: Example[];
}

/** The example of a path such as `haas/thread-mill.nc`. */
export function exampleAt(groups: ExampleGroup[], path: string): Example | undefined {
  const [folder, name] = path.split("/");
  return groups.find((group) => group.folder === folder)?.examples.find((example) => example.name === name);
}

let loaded: Promise<ExampleGroup[]> | undefined;

/** The examples, loaded once. */
export function gallery(): Promise<ExampleGroup[]> {
  loaded ??= load().catch((error: unknown) => {
    // The next call tries again.
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
