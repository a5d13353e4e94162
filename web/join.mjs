// Joins the page of `evc cab`: node join.mjs SCRIPT.js MODULE.wasm PAGE.html. Script, style and module go to their places in
// index.html, the module packed with gzip; the place of the line and the train stays, for `evc cab`.
import { readFileSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

const [script, module, page] = process.argv.slice(2);
if (page === undefined) throw new Error("usage: node join.mjs SCRIPT.js MODULE.wasm PAGE.html");
const here = new URL(".", import.meta.url);
let text = readFileSync(new URL("index.html", here), "utf8");
const put = (place, what) => {
  if (text.split(place).length !== 2) throw new Error(`index.html: ${place} is not there once`);
  text = text.replace(place, () => what);
};
put("/*@style@*/", readFileSync(new URL("style.css", here), "utf8"));
// A script ends at the first "</script".
put("/*@script@*/", readFileSync(script, "utf8").replaceAll("</script", "<\\/script"));
put("@module@", gzipSync(readFileSync(module), { level: 9 }).toString("base64"));
writeFileSync(page, text);
