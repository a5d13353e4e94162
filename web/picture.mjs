// A picture of the page of `evc cab` on its way: PAGE=cab.html OUT=cab.png [SECONDS_DRIVEN=600] [WIDTH=1400] [HEIGHT=900]
// [SCHEME=dark|light] node picture.mjs. The driver of `evc run` drives; the window Main, which the start of mission opened,
// is closed by a touch.
import { pathToFileURL } from "node:url";

import puppeteer from "puppeteer-core";

const { PAGE, OUT, SECONDS_DRIVEN = "600", WIDTH = "1400", HEIGHT = "900", SCHEME = "dark", CHROMIUM = "/usr/bin/chromium" } = process.env;
if (PAGE === undefined || OUT === undefined) throw new Error("PAGE and OUT are not set");
const browser = await puppeteer.launch({ executablePath: CHROMIUM, args: ["--no-sandbox", "--disable-gpu", "--no-first-run"] });
try {
  const page = await browser.newPage();
  await page.setViewport({ width: Number(WIDTH), height: Number(HEIGHT) });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: SCHEME }]);
  await page.goto(`${pathToFileURL(PAGE).href}?auto=perfect`);
  await page.waitForFunction(() => "evc" in window);
  await page.evaluate((seconds) => {
    document.querySelector("#pause").click();
    window.evc.advance(seconds);
    const close = window.evc.screen().touch.find((place) => place.action === "close" && place.enabled);
    if (close !== undefined) window.evc.press(close.abs[0] + 20, close.abs[1] + 20);
  }, Number(SECONDS_DRIVEN));
  await page.screenshot({ path: OUT });
} finally {
  await browser.close();
}
