// The page that stands alone, without a server of Chordal.

import "./standalone/content-policy";
import "./standalone/standalone-host";
import "./session/session";
