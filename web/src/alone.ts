// The page that stands alone, without a server of Chordal.

import "./alone/policy";
import "./alone/shell";
import "./main";
