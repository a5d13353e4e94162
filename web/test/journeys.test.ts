// Whole journeys by presses alone, on the page in a browser: what a driver does on the display and the desk, and what the
// on-board makes of it.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import type { Browser } from "puppeteer-core";

import { browserOf, Cabin, madeLine, programOf, TRAIN, type By, type BrowserName } from "./cabin.js";

/// From a place of the lines of tests/data/cab, where the train starts at -40 m.
const ahead = (place_m: number): number => place_m + 40;

async function reads(cab: Cabin, text: string): Promise<boolean> {
  return (await cab.see()).texts.some((shown) => shown.includes(text));
}
function inBrowser(name: BrowserName, body: (open: (words: string[], by?: By) => Promise<Cabin>) => void): void {
  const skip = programOf(name) === undefined ? `${name} is not installed` : false;
  let browser: Browser | undefined;
  before(async () => {
    if (skip === false) browser = await browserOf(name);
  });
  after(async () => browser?.close());
  body(async (words, by) => {
    assert.ok(browser !== undefined, `${name} is not installed`);
    return Cabin.open(browser, words, by);
  });
}

inBrowser("chrome", (open) => {
  test("start of mission in level 1 by the mouse, with data entry and validation (5.4.3, 015560 11.7.2)", async () => {
    const cab = await open([madeLine("level_1")], "mouse");
    await cab.openDesk();
    await cab.enter("Driver ID", "ab12");
    await cab.enter("Level", "Level 1");
    await cab.wait({ window: "Main" }, 5);
    await cab.press("Train data");
    await cab.enter("Train data", { ...TRAIN, "Length (m)": "18" });
    // What was entered is read again before it is valid: a mistake is taken back.
    assert.deepEqual((await cab.see()).echoes.map((echo) => echo.value), ["PASS 3", "18", "135", "140", "C2", "No", "G1"]);
    await cab.enter("Validate train data", "No");
    await cab.expect({ mode: "SB" });
    assert.equal((await cab.line()).data["train_data"]?.status, "unknown");
    await cab.enter("Train data", TRAIN);
    await cab.enter("Validate train data", "Yes");
    await cab.enter("Train running number", "4711");
    await cab.wait({ window: "Main" }, 5);
    const { data } = await cab.line();
    assert.equal(data["driver_id"]?.value, "ab12");
    assert.equal(data["train_data"]?.status, "valid");
    assert.equal(data["train_running_number"]?.status, "valid");
    await cab.startInSR();
    await cab.replayed();
    await cab.close();
  });

  test("a journey in level 1: text, on sight, adhesion, override, shunting area, trip, post trip", async () => {
    const cab = await open([madeLine("level_1")]);
    await cab.startInLevel1();
    await cab.drive({ mode: "FS" }, 30);

    // A text to be acknowledged (3.12.3.4).
    await cab.drive({ asks: "text" });
    assert.ok(await reads(cab, "Works"), JSON.stringify((await cab.see()).texts));
    await cab.acknowledge("text");
    await cab.advance(1);
    assert.ok(!(await reads(cab, "Works")), JSON.stringify((await cab.see()).texts));

    await cab.stop();
    await selectSlipperyRail(cab);

    // The speed restriction, then on sight with its acknowledgement (5.9.3).
    await cab.drive({ run_m: ahead(770) });
    assert.ok(((await cab.line()).V_MRSP ?? 999) <= 40);
    await cab.drive({ asks: "OS" });
    await cab.acknowledge("OS");
    await cab.drive({ mode: "OS" });
    await cab.drive({ mode: "FS" });

    // The signal at danger, and past it in SR.
    await cab.drive({ stands: true }, 60);
    await override(cab, 2080);
    await cab.drive({ mode: "FS" }, 30);

    // The shunting area with its acknowledgement, and out of it at a stand (5.6).
    await cab.drive({ asks: "SH" });
    await cab.acknowledge("SH");
    await cab.drive({ mode: "SH" });
    await cab.advance(3);
    await cab.stop();
    await cab.press("Main");
    await cab.press("Exit Shunting");
    await cab.wait({ mode: "SB" }, 5);

    // Start again: the driver ID is only to be confirmed, the level is still valid (5.4.3.2).
    await cab.wait({ window: "Driver ID" }, 5);
    await cab.press("field 1");
    await cab.enterTrainData();
    await cab.startInSR();

    // The order to stop in SR trips the train (4.4.11, 4.6.3 [49]); from post trip on in SR.
    await cab.drive({ mode: "TR" }, 30);
    await toPostTrip(cab);
    await cab.openMenu("Main");
    await cab.startInSR();
    await cab.drive({ run_m: ahead(3400) }, 30);
    await cab.stop();
    await cab.replayed();
    await cab.close();
  });

  test("what is painted from cycle to cycle is what is painted at once", async () => {
    const cab = await open([madeLine("level_1")]);
    const compare = async (): Promise<void> => {
      const most = await cab.page.evaluate(async () => {
        const canvas = document.querySelector("#dmi") as HTMLCanvasElement;
        const frames = async (): Promise<void> => {
          for (let n = 0; n < 3; ++n) await new Promise((done) => requestAnimationFrame(done));
        };
        const pixels = (): Uint8ClampedArray => {
          const copy = document.createElement("canvas");
          [copy.width, copy.height] = [canvas.width, canvas.height];
          const context = copy.getContext("2d", { willReadFrequently: true }) as CanvasRenderingContext2D;
          context.drawImage(canvas, 0, 0);
          return context.getImageData(0, 0, copy.width, copy.height).data;
        };
        await frames();
        const grown = pixels();
        // Another size, and all is painted again.
        canvas.width += 1;
        window.evc?.advance(0);
        await frames();
        return pixels().reduce((most, value, n) => Math.max(most, Math.abs(value - (grown[n] ?? 255))), 0);
      });
      // Smooth edges come out a little different by where they are cut; a shape that was missed is another colour.
      assert.ok(most <= 64, `${most} of 255`);
    };
    const pass = async (seconds: number): Promise<void> => {
      for (let n = 0; n < 10 * seconds; ++n) {
        await cab.advance(0.1);
        await cab.page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
      }
    };
    await pass(1);
    await compare();
    await cab.startInLevel1();
    await pass(1);
    await compare();
    await cab.drive({ mode: "FS" }, 30);
    for (const speed of [50, 20]) {
      await cab.drive({ run_m: speed === 50 ? 400 : 500 }, speed);
      await pass(1);
      await compare();
    }
    await cab.close();
  });

  test("speed and distance of SR, entered and in force (4.4.11.1.3)", async () => {
    const cab = await open([madeLine("level_1")]);
    await cab.startInLevel1();
    await cab.press("Special");
    await cab.press("SR speed / distance");
    await cab.enter("SR speed / distance", { "SR speed (km/h)": "25", "SR distance (m)": "120" });
    await cab.advance(1);
    const line = await cab.line();
    assert.equal(Math.round(line.V_MRSP ?? 0), 25);
    await cab.press("close");
    // Its end is supervised: with all the traction in the world the train does not get there.
    await cab.page.evaluate(() => window.evc?.desk({ lever: 0.5 }));
    await cab.advance(90);
    await cab.expect({ mode: "SR" });
    const { est_front_m } = await cab.line();
    assert.ok(est_front_m > 80 && est_front_m < 120, `${est_front_m}`);
    await cab.close();
  });

  test("shunting on the driver's request in level 1, and out of it (5.6.2)", async () => {
    const cab = await open([madeLine("level_1")]);
    await cab.prepareLevel1();
    await cab.press("Shunting");
    await cab.wait({ mode: "SH" }, 5);
    await cab.drive({ run_m: ahead(170) }, 25);
    await cab.stop();
    await cab.press("Main");
    await cab.press("Exit Shunting");
    await cab.wait({ mode: "SB" }, 5);
    await cab.close();
  });

  test("start of mission in level 2 by touch: the RBC's data, the session, an authority", async () => {
    const cab = await open([madeLine("level_2")], "touch");
    await prepareLevel2(cab);
    await cab.startInSR();
    await cab.drive({ mode: "FS" }, 40);
    await cab.drive({ asks: "OS" });
    await cab.acknowledge("OS");
    await cab.drive({ mode: "OS" });
    await cab.drive({ mode: "FS" });
    await cab.drive({ run_m: ahead(2150) });
    await cab.stop();
    await cab.replayed();
    await cab.close();
  });

  test("start of mission in level 2 where the terminals have to register with another network (3.5.6, 015560 11.7.1 S3-2)", async () => {
    // The first network is that of the terminals; along the line there is the second one.
    const radio_networks = { offered: ["26202", "26201"], along_line: "26201" };
    const cab = await open([madeLine("level_2", { radio_networks })], "mouse");
    const shows = async (id: string): Promise<boolean> => (await cab.see()).symbols.some((symbol) => symbol.id === id);
    await cab.openDesk();
    await cab.enter("Driver ID", "1234");
    await cab.enter("Level", "Level 2");
    await cab.wait({ window: "Radio data", offers: "Radio network ID" }, 60);
    // Nobody can be called before a terminal is registered.
    const isOffered = async (name: string): Promise<boolean | undefined> =>
      (await cab.see()).places.find((place) => place.name === name)?.enabled;
    assert.equal(await isOffered("Enter RBC data"), false);
    assert.equal(await isOffered("Use short number"), false);
    await cab.press("Radio network ID");
    await cab.wait({ window: "Radio network ID" }, 30);
    assert.deepEqual((await cab.see()).keys.map((key) => key.label), ["26202", "26201"]);
    // The display waits for the registration.
    await cab.enter("Radio network ID", "26201");
    await cab.wait({ window: "Radio data" }, 5);
    assert.ok(await shows("ST05"));
    assert.equal(await isOffered("Enter RBC data"), false);
    await cab.wait({ offers: "Enter RBC data" }, 10);
    assert.ok(!(await shows("ST05")));
    assert.equal((await cab.line()).data["network"]?.value, "26201");
    await enterRbcData(cab);
    await cab.enterTrainData();
    assert.ok(await shows("ST03"));
    await cab.startInSR();
    await cab.drive({ mode: "FS" }, 40);
    await cab.drive({ run_m: ahead(700) });
    await cab.expect({ mode: "FS", level: "2" });
    await cab.stop();
    // The network is in the view of the data (015560 11.5.1).
    await cab.press("Data view");
    await cab.press("next");
    assert.ok((await cab.viewed()).includes("26201"));
    await cab.replayed();
    await cab.close();
  });

  test("a journey in level 2: adhesion, override, emergency stop, trip, post trip", async () => {
    const cab = await open([madeLine("level_2_trip")]);
    await prepareLevel2(cab);
    await cab.startInSR();
    await cab.drive({ mode: "FS" }, 40);
    await cab.stop();
    await selectSlipperyRail(cab);

    // No new authority comes at the end of this one: override, and past it in SR until the next one has come.
    await cab.drive({ run_m: ahead(1850) }, 60);
    await override(cab, 2080);
    await cab.drive({ mode: "FS" }, 30);
    assert.equal((await cab.line()).level, "2");

    // The unconditional emergency stop trips the train (4.6.3 [20], 3.10.2). There is no Start before
    // the RBC has recognised the exit from trip and revoked the emergency stop (015560 11.2.1).
    await cab.drive({ mode: "TR" }, 60);
    await toPostTrip(cab);
    await cab.openMenu("Main");
    assert.equal((await cab.see()).places.find((place) => place.name === "Start")?.enabled, false);
    await cab.wait({ offers: "Start" }, 120);
    // From post trip on with the authority that the RBC gives for it (5.11.2.2 S150).
    await cab.press("Start");
    await cab.wait({ mode: "FS" }, 30);
    await cab.drive({ run_m: ahead(4500) }, 60);
    await cab.expect({ mode: "FS", level: "2" });
    await cab.stop();
    await cab.replayed();
    await cab.close();
  });

  test("shunting in level 2 asks the RBC (5.6.2)", async () => {
    const cab = await open([madeLine("level_2")]);
    await prepareLevel2(cab);
    await cab.press("Shunting");
    await cab.wait({ mode: "SH" }, 30);
    await cab.press("Main");
    await cab.press("Exit Shunting");
    await cab.wait({ mode: "SB" }, 5);
    await cab.close();
  });
});

/// Adhesion by the driver, at a stand, where the national values allow it, and back again (3.18.4.6).
async function selectSlipperyRail(cab: Cabin): Promise<void> {
  const shown = async (): Promise<boolean> => (await cab.see()).symbols.some((symbol) => symbol.id === "ST02");
  await cab.press("Special");
  await cab.press("Adhesion");
  await cab.enter("Adhesion", "Slippery rail");
  await cab.advance(1);
  assert.equal((await cab.line()).data["adhesion"]?.value, "slippery rail");
  assert.ok(await shown());
  await cab.press("Adhesion");
  await cab.enter("Adhesion", "Non slippery rail");
  await cab.advance(1);
  assert.ok(!(await shown()));
  await cab.press("close");
}

/// Override at a stand, and in SR past the end of the authority up to a place of the line (5.8).
async function override(cab: Cabin, past_m: number): Promise<void> {
  await cab.stop();
  await cab.press("Override");
  await cab.press("EOA");
  await cab.wait({ mode: "SR" }, 5);
  assert.ok((await cab.see()).symbols.some((symbol) => symbol.id === "MO03"));
  await cab.drive({ run_m: ahead(past_m) }, 30);
  await cab.expect({ mode: "SR" });
}

/// The trip, acknowledged when the train stands (5.11); then the driver's brake holds it.
async function toPostTrip(cab: Cabin): Promise<void> {
  assert.ok((await cab.line()).eb);
  await cab.stop();
  await cab.acknowledge("trip");
  await cab.wait({ mode: "PT" }, 5);
  assert.equal((await cab.line()).eb, false);
}

async function prepareLevel2(cab: Cabin): Promise<void> {
  await cab.openDesk();
  await cab.enter("Driver ID", "1234");
  await cab.enter("Level", "Level 2");
  await cab.wait({ window: "Radio data" }, 60);
  await enterRbcData(cab);
  await cab.enterTrainData();
}

async function enterRbcData(cab: Cabin): Promise<void> {
  await cab.press("Enter RBC data");
  // NID_C 1000 and NID_RBC 1 in one number (015560 11.3.5.3.1).
  await cab.enter("RBC data", { "RBC ID": `${1000 * 16384 + 1}`, "RBC phone number": "0041790000000001" });
}

inBrowser("firefox", (open) => {
  test("the page opens and drives in Firefox", async () => {
    const cab = await open([madeLine("level_1")]);
    await cab.startInLevel1();
    await cab.drive({ mode: "FS" }, 30);
    await cab.replayed();
    await cab.close();
  });
});
