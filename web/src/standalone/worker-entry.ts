// What runs in the workers of the page that stands alone: one answers, one for each kind of work does what takes long.

import { answers } from "./session-worker";
import type { Port } from "./worker-port";
import { works } from "./job-worker";

const port = self as unknown as Port;
if (port.name === "answers") answers(port);
else works(port);
