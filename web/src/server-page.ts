// The page that `chordal view` serves.

import { dialServer } from "./protocol/websocket";
import { Session } from "./session/session";

new Session(document.querySelector<HTMLElement>("#app")!, {
  dial: dialServer,
  lostMessage: "Chordal has ended, or the connection is lost. Start `chordal view` again. What you typed since the last save is still here: copy it.",
  savedMessage: "Saved.",
  anotherHint: "For another file, start `chordal view` with `--against FILE`.",
});
