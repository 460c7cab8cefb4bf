// The script of all workers of the standalone page: the session worker, and one job worker for each kind of work.

import { jobWorker } from "./job-worker";
import { sessionWorker } from "./session-worker";
import type { WorkerPort } from "./worker-port";

const port = self as unknown as WorkerPort;
if (port.name === "answers") sessionWorker(port);
else jobWorker(port);
