// The begin of the page: the module and the bytes of line and train are in it.

import { Cab, wantedOf, type Evc } from "./cab.js";
import { Live } from "./live.js";
import { bytesOfBase64, Remote, Ride, unpacked } from "./module.js";

/// `window.evc` at a unit elsewhere: time passes there, so `advance` waits for it.
interface LiveEvc extends Omit<Evc, "advance"> {
  advance(seconds: number): Promise<void>;
  /// Lines of inputs from elsewhere: odometer, balises, radio.
  give(lines: string): void;
}

declare global {
  interface Window {
    evc?: Evc | LiveEvc;
  }
}

async function begin(): Promise<void> {
  const bytesIn = (id: string) => bytesOfBase64(document.getElementById(id)?.textContent ?? "");
  const module = await unpacked(bytesIn("module"));
  // Without a line the page is that of a unit which runs elsewhere: of `evc serve`.
  if (document.getElementById("given")?.textContent === "") return beginLive(await Remote.begin(module));
  const wanted = wantedOf(location.search);
  const cab = new Cab(await Ride.begin(module, bytesIn("given"), wanted), wanted);
  window.evc = {
    state: () => cab.state(),
    screen: () => cab.screen(),
    press: (x, y) => cab.press(x, y),
    desk: (part) => cab.desk(part),
    advance: (seconds) => cab.advance(seconds),
    inputs: () => cab.inputs(),
  };
  cab.go();
}

function beginLive(remote: Remote): void {
  const live = new Live(remote);
  window.evc = {
    state: () => live.state(),
    screen: () => live.screen(),
    press: (x, y) => live.press(x, y),
    desk: (part) => live.setDesk(part),
    advance: (seconds) => live.advance(seconds),
    inputs: () => live.inputs(),
    give: (lines) => live.give(lines),
  };
  live.go();
}

begin().catch((error: unknown) => {
  const done = document.getElementById("done");
  if (done !== null) done.textContent = `The page could not begin: ${String(error)}`;
  throw error;
});
