// What runs in the workers of the page that stands alone: one answers, one for each kind of work does what takes long.

import { jobWorker } from "./job-worker";
import { sessionWorker } from "./session-worker";
import type { WorkerPort } from "./worker-port";

const port = self as unknown as WorkerPort;
if (port.name === "answers") sessionWorker(port);
else jobWorker(port);
