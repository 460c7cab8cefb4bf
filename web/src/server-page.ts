// The page that `chordal view` serves.

import "./protocol/websocket";
import "./session/session";
