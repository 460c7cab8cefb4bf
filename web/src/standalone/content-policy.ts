// The Content-Security-Policy of connections: the page may load only from its own origin and those named in its address.
//
// The policy in the head allows any address; this one, added to it, can only restrict it further. It does not apply to earlier
// requests, so this module is imported before all others.

import { addressRequest } from "./address";

const origins = new Set(["'self'"]);
try {
  const { program, files, against } = addressRequest(location.search, document.baseURI) ?? { files: [] };
  for (const url of [program, ...files, against]) if (url) origins.add(url.origin);
} catch {
  // The error of the address is reported when the page is ready.
}
const rules = document.createElement("meta");
rules.httpEquiv = "Content-Security-Policy";
rules.content = `connect-src ${[...origins].join(" ")}`;
document.head.append(rules);
