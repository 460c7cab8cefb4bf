// The line of the page that `chordal view` serves: a WebSocket to its server.

import type { Line } from "./connection";
import { use } from "../page-host";

function dial(take: (data: string | ArrayBuffer) => void, closed: () => void): Line {
  const address = new URL("live", location.href);
  address.protocol = "ws:";
  address.hash = "";
  const socket = new WebSocket(address);
  socket.binaryType = "arraybuffer";
  socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => take(event.data);
  socket.onclose = closed;
  return {
    get isOpen() {
      return socket.readyState === WebSocket.OPEN;
    },
    send: (text) => socket.send(text),
  };
}

use({
  dial,
  lost: "Chordal has ended, or the connection is lost. Start `chordal view` again. What you typed since the last save is still here: copy it.",
  saved: "Saved.",
  another: "For another file, start `chordal view` with `--against FILE`.",
});
