// Keeps the files of one version of the page. `VERSION` and `FILES` are written when the page is built.

const CACHE = `chordal ${registration.scope} ${VERSION}`;
const OURS = `chordal ${registration.scope} `;

self.addEventListener("install", (event) => {
  // A name that changes with its content may come from the browser's own cache, others are asked for.
  const requests = FILES.map((file) => new Request(file, { cache: /-[\w-]{8}\.\w+$/.test(file) ? "default" : "no-cache" }));
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(requests)));
});

self.addEventListener("activate", (event) => {
  const tidied = caches.keys().then((names) =>
    Promise.all(names.filter((name) => name.startsWith(OURS) && name !== CACHE).map((name) => caches.delete(name))),
  );
  event.waitUntil(tidied.then(() => self.clients.claim()));
});

self.addEventListener("message", (event) => {
  if (event.data === "take over") self.skipWaiting();
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(registration.scope)) return;
  const asked = request.mode === "navigate" ? "./" : request;
  const kept = caches.open(CACHE).then((cache) => cache.match(asked, { ignoreSearch: true }));
  event.respondWith(kept.then((found) => found ?? fetch(request)));
});
