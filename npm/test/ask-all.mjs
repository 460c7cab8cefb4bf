// Asks everything about every program: in Node, and as it is in a page.

/** The answers' digests by program and question; `failed <kind>` where there is none. */
export async function askAll(chordal, programs, questions) {
  const answers = {};
  for (const program of programs) {
    for (const [name, format] of questions) {
      const options = { ...program.options, files: program.files, format };
      const answer = await chordal[name](program.text, options).catch((error) => `failed: ${error.message}`);
      answers[`${program.path} ${name}`] = await digest(answer);
    }
  }
  return answers;
}

/** SHA-256 of a text. */
export async function digest(text) {
  const bytes = await crypto.subtle.digest("SHA-256", new TextEncoder().encode(text));
  return Array.from(new Uint8Array(bytes), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
