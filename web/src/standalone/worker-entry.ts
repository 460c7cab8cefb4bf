// The script of the workers of the standalone page: one answers requests, one for each kind of work does what takes long.

import { jobWorker } from "./job-worker";
import { sessionWorker } from "./session-worker";
import type { WorkerPort } from "./worker-port";

const port = self as unknown as WorkerPort;
if (port.name === "answers") sessionWorker(port);
else jobWorker(port);
