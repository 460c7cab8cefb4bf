// The profile of a browser that a test starts.

import { rmSync } from "node:fs";

/**
 * Removes the profile of a browser that has ended.
 *
 * Processes of the browser write into it for some seconds more, so the removal is tried again for half a minute.
 * A folder that stays is no fault of what was tested: it is said, and fails nothing.
 */
export function removeProfile(folder) {
  try {
    rmSync(folder, { recursive: true, force: true, maxRetries: 16, retryDelay: 200 });
  } catch (error) {
    console.warn(`${folder} could not be removed: ${error.message}`);
  }
}
