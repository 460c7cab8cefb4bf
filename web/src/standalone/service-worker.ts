// Registers the service worker, which caches the files of each version of the page, so that it works offline.

/** Registers it with a delay; `onUpdate` is called when a newer version is ready, with a function that loads it. */
export function registerServiceWorker(onUpdate: (load: () => void) => void): void {
  const { serviceWorker } = navigator;
  // Missing where the origin is neither secure nor local.
  if (!serviceWorker) return;
  const hadController = serviceWorker.controller !== null;
  let isLoading = false;
  serviceWorker.addEventListener("controllerchange", () => {
    if (isLoading) location.reload();
  });
  const offerUpdate = (worker: ServiceWorker) =>
    onUpdate(() => {
      isLoading = true;
      worker.postMessage("take over");
    });
  setTimeout(() => {
    serviceWorker
      .register("./sw.js")
      .then((registration) => {
        if (registration.waiting && hadController) offerUpdate(registration.waiting);
        registration.addEventListener("updatefound", () => {
          const worker = registration.installing;
          worker?.addEventListener("statechange", () => {
            if (worker.state === "installed" && hadController) offerUpdate(worker);
          });
        });
      })
      .catch(() => {
        // The browser allows no service worker: the page works online only.
      });
  }, REGISTER_AFTER_MS);
}

/** Delay of the registration, ms, so that what the first picture needs is loaded before. */
const REGISTER_AFTER_MS = 1500;
