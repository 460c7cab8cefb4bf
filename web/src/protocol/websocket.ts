// The connection of the page that `chordal view` serves: a WebSocket to its server.

import type { Transport } from "./connection";

export function dialServer(onData: (data: string | ArrayBuffer) => void, onClose: () => void): Transport {
  const address = new URL("live", location.href);
  address.protocol = "ws:";
  address.hash = "";
  const socket = new WebSocket(address);
  socket.binaryType = "arraybuffer";
  socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => onData(event.data);
  socket.onclose = onClose;
  return {
    get isOpen() {
      return socket.readyState === WebSocket.OPEN;
    },
    send: (text) => socket.send(text),
  };
}
