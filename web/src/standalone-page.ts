// The standalone page, without a server of Chordal.

import "./standalone/content-policy";
import { Session } from "./session/session";
import { StandaloneHost } from "./standalone/standalone-host";

new Session(document.querySelector<HTMLElement>("#app")!, new StandaloneHost());
