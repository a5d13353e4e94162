/* What the pages of `evc curves` share: colours, numbers, round values of an axis. */
const C = { white:"#FFFFFF", grey:"#C3C3C3", medium:"#969696", dark:"#555555", blue:"#031122", yellow:"#DFDF00", orange:"#EA9100", red:"#BF0002", paspDark:"#21314A", paspLight:"#294A6B" };
const FONT = "11.5px Verdana,'DejaVu Sans',sans-serif";
const $ = id => document.getElementById(id);
const fmt = (v, n) => v === null || v === undefined || Number.isNaN(v) ? "–" : v.toFixed(n).replace("-", "−");
function ticks(a, b, n) {
  const r = (b - a) / n, p = Math.pow(10, Math.floor(Math.log10(r))); let s = p;
  for (const m of [2, 5, 10]) if (s < r * .999) s = m * p;
  const out = []; for (let k = Math.ceil(a / s - 1e-9); k * s <= b + s * 1e-6; ++k) out.push(k * s); return out;
}
/* A button that shows or hides a curve. */
function chip(name, colour, dashed, toggle) {
  const c = document.createElement("button"); c.type = "button"; c.className = "chip"; c.setAttribute("aria-pressed", "true");
  c.innerHTML = `<i style="border-color:${colour};border-top-style:${dashed ? "dashed" : "solid"}"></i>${name}`;
  c.onclick = () => c.setAttribute("aria-pressed", toggle()); return c;
}
function tool(name, title, act) { const t = document.createElement("button"); t.type = "button"; t.className = "tool"; t.textContent = name; t.title = title; t.onclick = act; return t; }
function gap() { const g = document.createElement("span"); g.className = "gap"; return g; }
