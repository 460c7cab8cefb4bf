// The page that `chordal view` serves.

import "./socket";
import "./main";
