// What the page may load from other servers: only what its own address names.
//
// The rules in the head allow any address, and whatever is added here narrows them: a page can make its rules
// stricter, not weaker. So this comes before everything else.

import { addressRequest } from "./address";

const origins = new Set(["'self'"]);
try {
  const { program, files, against } = addressRequest(location.search, document.baseURI) ?? { files: [] };
  for (const url of [program, ...files, against]) if (url) origins.add(url.origin);
} catch {
  // What is wrong with the address is said once the page is there.
}
const rules = document.createElement("meta");
rules.httpEquiv = "Content-Security-Policy";
rules.content = `connect-src ${[...origins].join(" ")}`;
document.head.append(rules);
