// Caches the files of one version of the page. The build defines `VERSION` and `FILES`.

const CACHE = `chordal ${registration.scope} ${VERSION}`;
const CACHE_PREFIX = `chordal ${registration.scope} `;

self.addEventListener("install", (event) => {
  // A file with a hash of its content in its name may come from the browser's own cache; the others are requested again.
  const requests = FILES.map((file) => new Request(file, { cache: /-[\w-]{8}\.\w+$/.test(file) ? "default" : "no-cache" }));
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(requests)));
});

self.addEventListener("activate", (event) => {
  const outdatedDeleted = caches.keys().then((names) =>
    Promise.all(names.filter((name) => name.startsWith(CACHE_PREFIX) && name !== CACHE).map((name) => caches.delete(name))),
  );
  event.waitUntil(outdatedDeleted.then(() => self.clients.claim()));
});

self.addEventListener("message", (event) => {
  if (event.data === "take over") self.skipWaiting();
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(registration.scope)) return;
  const cacheKey = request.mode === "navigate" ? "./" : request;
  const cached = caches.open(CACHE).then((cache) => cache.match(cacheKey, { ignoreSearch: true }));
  event.respondWith(cached.then((response) => response ?? fetch(request)));
});
