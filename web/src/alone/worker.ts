// What runs in the workers of the page that stands alone: one answers, one for each kind of work does what takes long.

import { answers } from "./answers";
import type { Port } from "./port";
import { works } from "./works";

const port = self as unknown as Port;
if (port.name === "answers") answers(port);
else works(port);
