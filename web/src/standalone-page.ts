// The page that stands alone, without a server of Chordal.

import "./standalone/content-policy";
import { StandaloneHost } from "./standalone/standalone-host";
import { Session } from "./session/session";

new Session(document.querySelector<HTMLElement>("#app")!, new StandaloneHost());
