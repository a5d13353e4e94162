// The begin of the page: the module and the bytes of line and train are in it.

import { Cab, wantedOf, type Evc } from "./cab.js";
import { bytesOfBase64, Ride } from "./module.js";

declare global {
  interface Window {
    evc?: Evc;
  }
}

async function begin(): Promise<void> {
  const bytesIn = (id: string) => bytesOfBase64(document.getElementById(id)?.textContent ?? "");
  const wanted = wantedOf(location.search);
  const cab = new Cab(await Ride.begin(bytesIn("module"), bytesIn("given"), wanted.driver), wanted);
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

begin().catch((error: unknown) => {
  const done = document.getElementById("done");
  if (done !== null) done.textContent = `The page could not begin: ${String(error)}`;
  throw error;
});
