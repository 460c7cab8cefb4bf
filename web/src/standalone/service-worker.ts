// Registers the service worker that keeps the files of the page, version by version, so that it works without a network.

/** Registers it after the first picture; `renew` is called when a newer version waits. */
export function registerServiceWorker(renew: (load: () => void) => void): void {
  const { serviceWorker } = navigator;
  // Only of a secure origin, or of this computer.
  if (!serviceWorker) return;
  const hadOne = serviceWorker.controller !== null;
  let isLoading = false;
  serviceWorker.addEventListener("controllerchange", () => {
    if (isLoading) location.reload();
  });
  const waits = (worker: ServiceWorker) =>
    renew(() => {
      isLoading = true;
      worker.postMessage("take over");
    });
  setTimeout(() => {
    serviceWorker
      .register("./sw.js")
      .then((registration) => {
        if (registration.waiting && hadOne) waits(registration.waiting);
        registration.addEventListener("updatefound", () => {
          const worker = registration.installing;
          worker?.addEventListener("statechange", () => {
            if (worker.state === "installed" && hadOne) waits(worker);
          });
        });
      })
      .catch(() => {
        // A browser that keeps nothing: the page works while there is a network.
      });
  }, REGISTER_AFTER_MS);
}

/** What the first picture needs comes first, ms. */
const REGISTER_AFTER_MS = 1500;
