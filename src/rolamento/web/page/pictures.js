// Pictures: drawn by Plotly when they are seen, and redrawn in the frame that follows an answer.
//
// A full drawing takes Plotly some 10 ms. While a slider moves the frame around the lines stays as
// it is as long as they fit, so their paths alone are set anew (`trace`), and Plotly draws all when
// it has come to rest.

import { make, remember, remembered, say } from "./ask.js";

const REST = 200; // ms without a new picture, after which Plotly draws what was only traced
const LEAST_FILLED = 0.3; // of an axis, by what moves
const BUDGET = 9; // ms of a frame for full drawings; what is left over waits for the next
const DASHES = { dash: "6 4", dot: "2 3", dashdot: "7 3 2 3", longdash: "10 4", longdashdot: "10 3 2 3" };
const MARKS = { circle: "M12.5 6a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0-7 0", square: "M13 3h6v6h-6z", diamond: "M16 2l4 4-4 4-4-4z",
  "triangle-up": "M16 2l4 7h-8z", cross: "M15 2h2v3h3v2h-3v3h-2v-3h-3v-2h3z", star: "M16 1l1.5 3.5 3.7.3-2.8 2.4.9 3.6-3.3-1.9-3.3 1.9.9-3.6-2.8-2.4 3.7-.3z",
  "line-ns": "M16 0v12", "x-thin": "M12 2l8 8M20 2l-8 8" };
const CONFIG = { displayModeBar: false, scrollZoom: false, doubleClick: false, showTips: false, responsive: false };

const figures = new Map(); // key → what is known of a figure of the page
let language = "en";
let seen = () => {};
let frame = 0;
let resting = 0;
let observer, sizes;
let theme = {};

/** Make the figures in `root`; `onVisible` is called when some that were not seen are. */
export function startPictures(root, descriptions, words, { lang, onVisible }) {
  observer?.disconnect();
  sizes?.disconnect();
  for (const one of figures.values()) Plotly.purge(one.plot);
  figures.clear();
  language = lang.replace("_", "-");
  seen = onVisible;
  theme = {};
  observer = new IntersectionObserver(looked, { rootMargin: "60px" });
  sizes = new ResizeObserver((entries) => entries.forEach(({ target }) => resized(target)));
  root.classList.add("pictures");
  root.append(...descriptions.map(({ key, label, opened }) => newFigure(key, label, opened)));
}

/** Make a figure that can be folded; `before`: elements above the drawing. */
export function newFigure(key, label, opened, before = []) {
  const plot = make("div", { className: "plot", role: "img", "aria-label": label });
  const legend = make("ul", { className: "legend" });
  const caption = make("figcaption");
  const numbers = make("div", { className: "numbers", hidden: true, tabIndex: 0, role: "region", "aria-label": label });
  const table = make("button", { type: "button", className: "button", textContent: say("pictures.table"), "aria-expanded": "false" });
  const save = make("button", { type: "button", className: "button", textContent: say("pictures.save") });
  const element = make("details", { className: "picture", open: remembered(`picture.${key}`, opened) },
    make("summary", {}, make("h3", { textContent: label })), ...before, make("figure", {}, plot, legend, caption),
    make("div", { className: "tools does" }, table, save), numbers);
  element.dataset.key = key;
  const own = { key, label, element, plot, legend, caption, numbers, table, visible: false };
  figures.set(key, own);
  element.ontoggle = () => remember(`picture.${key}`, element.open);
  table.onclick = () => {
    numbers.hidden = !numbers.hidden;
    table.setAttribute("aria-expanded", String(!numbers.hidden));
    fillTable(own);
  };
  save.onclick = () => { // with what the page tells beside it
    const title = { text: label, font: { size: 15 }, y: 0.98, yanchor: "top", yref: "container" };
    const beside = { showlegend: true, legend: { orientation: "h", yref: "container", y: 0 }, autosize: false, title };
    const { margin } = plot.layout;
    const layout = { ...plot.layout, ...beside, margin: { ...margin, t: margin.t + 30, b: margin.b + 50 } };
    Plotly.downloadImage({ data: plot.data, layout, config: { locale: language } }, { format: "svg", filename: key, width: 900, height: 620 });
  };
  observer.observe(plot);
  sizes.observe(plot);
  return element;
}

function looked(entries) {
  let more = false;
  for (const own of figures.values()) {
    const entry = entries.findLast(({ target }) => target === own.plot);
    if (!entry || entry.isIntersecting === own.visible) continue;
    own.visible = entry.isIntersecting;
    if (own.visible) {
      if (own.next) later();
      if (own.apart) own.apart();
      else more ||= !own.current && !own.asked;
    }
  }
  if (more) seen();
}

/** Take a figure out of what answers bring; `ask` is called when it comes to be seen. */
export function separate(key, ask) {
  figures.get(key).apart = ask;
}

/** What an answer has to bring: the pictures to be seen now, or all that are unfolded. */
export function visibleKeys(quick = true) {
  for (const own of figures.values())
    own.asked = !own.apart && !own.element.hidden && (quick ? own.visible : own.element.open);
  return [...figures.values()].filter((own) => own.asked).map((own) => own.key);
}

/** Show only those that suit the cases. */
export function offerPictures(keys) {
  for (const own of figures.values()) if (!own.apart) own.element.hidden = !keys.includes(own.key);
}

/** Say of pictures that they are not of the present case. */
export function stalePictures(keys) {
  for (const key of keys) {
    const own = figures.get(key);
    own?.element.classList.add("stale");
    if (own) own.current = false;
  }
}

/** Take over pictures of an answer; they are drawn in the next frame. */
export function showPictures(answer) {
  const late = [];
  const isApart = Object.keys(answer).some((key) => figures.get(key)?.apart);
  for (const [key, own] of figures) {
    if (answer[key]) {
      Object.assign(own, { next: answer[key], current: true, asked: false });
      own.element.classList.toggle("empty", answer[key].empty); // at once: its place among others follows
    } else if (!own.apart && !isApart) late.push(key); // of an earlier case
  }
  stalePictures(late);
  later();
}

/** Draw all anew, in the colours of another theme. */
export function retheme() {
  theme = {};
  for (const own of figures.values()) if (own.now) own.next ??= { ...own.now, anew: true };
  later();
}

const later = () => (frame ||= requestAnimationFrame(draw));

function draw() {
  frame = 0;
  const middle = innerHeight / 2;
  const distance = (own) => Math.abs(own.element.getBoundingClientRect().top - middle);
  const due = [...figures.values()].filter((own) => own.next && own.visible && !own.element.hidden)
    .map((own) => [distance(own), own]).sort((a, b) => a[0] - b[0]).map(([, own]) => own);
  const began = performance.now();
  const full = due.filter((own) => !traced(own));
  full.forEach((own, n) => { // the nearest at once, however long it takes
    if (n === 0 || performance.now() - began < BUDGET) drawn(own);
    else later();
  });
}

/** Draw a figure's next picture by tracing alone, if only its numbers differ from the last. */
function traced(own) {
  const picture = own.next;
  if (picture.anew || picture.empty || own.frame !== frameOf(picture) || !fits(own.ends, endsOf(picture)) || !trace(own.plot, picture.data)) return false;
  own.next = null;
  own.rough = true;
  clearTimeout(resting);
  resting = setTimeout(settle, REST);
  told(own, picture);
  return true;
}

function settle() {
  for (const own of figures.values()) {
    if (own.rough) own.next ??= { ...own.now, anew: true };
  }
  later();
}

function drawn(own) {
  const picture = own.next;
  own.next = null;
  own.rough = false;
  Object.assign(own, picture.empty ? { frame: "" } : { frame: frameOf(picture), ends: endsOf(picture) });
  told(own, picture);
  if (picture.empty) {
    Plotly.purge(own.plot);
    return;
  }
  own.plot.classList.toggle("tall", Boolean(picture.layout.polar || picture.layout.yaxis2));
  const data = coloured(picture.data);
  const layout = layoutOf(picture.layout, own.plot, data);
  legendOf(own, data);
  Plotly.react(own.plot, data, layout, { ...CONFIG, locale: language });
}

const isLine = ({ type, mode }) => type.startsWith("scatter") && mode !== "markers";

/** What stands around the numbers of a picture but how far its axes go: where two are alike, tracing is enough. */
const frameOf = ({ data, layout }) => JSON.stringify([layout, data.map((one) => isLine(one)
  ? { ...one, x: one.x?.length, y: one.y?.length, r: one.r?.length, theta: one.theta?.length } : one)], (name, one) => (["range", "dtick", "angle"].includes(name) ? null : one));

const endsOf = ({ layout: { polar, ...axes } }) => Object.values({ ...axes, ...polar }).map((one) => one?.range).filter(Array.isArray);

/** Whether what goes so far can be seen on axes that were drawn, and fills a fair part of them. */
const fits = (drawn, ends) => ends.every(([low, high], n) => low >= drawn[n][0] && high <= drawn[n][1] && high - low > LEAST_FILLED * (drawn[n][1] - drawn[n][0]));

function told(own, picture) {
  own.now = picture;
  if (own.current) own.element.classList.remove("stale");
  if (own.caption.textContent !== picture.summary) {
    own.caption.textContent = picture.summary;
    own.plot.setAttribute("aria-label", `${own.label}. ${picture.summary}`);
  }
  own.table.hidden = Boolean(picture.layout.meta?.drawing);
  if (!own.numbers.hidden) fillTable(own);
}

// --- lines alone -------------------------------------------------------------------------------

/** Put the lines and marks of a drawn picture where other numbers lie; false if it cannot be done. */
function trace(plot, data) {
  const paths = [];
  for (const [n, one] of data.entries()) {
    const full = plot._fullData?.[n];
    const group = full && plot.querySelector(`.trace${full.uid}`);
    if (!group || full.type !== one.type) return false;
    if (!isLine(one)) continue; // as it was: `frameOf` says so
    const at = one.type === "scatterpolar" ? polar(plot._fullLayout.polar?._subplot, one) : cartesian(plot._fullLayout, full, one);
    const places = at && one[one.r ? "r" : "x"].map((_, place) => at(place));
    const lines = group.querySelectorAll("path.js-line");
    const points = group.querySelectorAll("path.point");
    const fill = one.fill ? group.querySelector("path.js-fill") : null;
    const runs = places && runsOf(places);
    const there = runs?.flat() ?? [];
    if (!runs || lines.length !== runs.length || (points.length && points.length !== there.length) || (one.fill && !fill)) return false;
    paths.push(() => {
      runs.forEach((run, line) => lines[line].setAttribute("d", `M${run.join("L")}`));
      fill?.setAttribute("d", runs.map((run) => `M${run.join("L")}Z`).join(""));
      there.forEach((place, point) => points[point]?.setAttribute("transform", `translate(${place})`));
    });
  }
  for (const set of paths) set();
  return true;
}

function cartesian(layout, full, { x, y }) {
  const [across, upright] = [full.xaxis, full.yaxis].map((id) => layout[id.replace(/^([xy])/, "$1axis")]);
  if (!across?.d2p || !upright?.d2p) return null;
  return (n) => (x[n] === null || y[n] === null ? null : [across.d2p(x[n]), upright.d2p(y[n])].map(brief));
}

function polar(subplot, { r, theta }) {
  if (!subplot?.radialAxis?.c2g || !subplot.angularAxis?.c2g || !subplot.xaxis?.c2p) return null;
  return (n) => {
    const [far, angle] = [subplot.radialAxis.c2g(r[n]), subplot.angularAxis.c2g((theta[n] * Math.PI) / 180)];
    return [subplot.xaxis.c2p(far * Math.cos(angle)), subplot.yaxis.c2p(far * Math.sin(angle))].map(brief);
  };
}

const brief = (value) => value.toFixed(2);

/** Cut places into runs without a gap. */
function runsOf(places) {
  const runs = [[]];
  for (const place of places) {
    if (place) runs.at(-1).push(place);
    else if (runs.at(-1).length) runs.push([]);
  }
  return runs.at(-1).length ? runs : runs.slice(0, -1);
}

// --- colours, frame, legend, table --------------------------------------------------------------

/** The colour of a name in the present theme; "inner-band": faint, below lines. */
function colour(name) {
  return (theme[name] ??= (() => {
    const [plain, band] = name.split("-");
    const found = getComputedStyle(document.documentElement).getPropertyValue(`--picture-${plain}`).trim();
    return found && band ? `${found}2e` : found || name;
  })());
}

/** Replace names of colours, wherever they stand. */
function coloured(value, key = "") {
  if (key.endsWith("color") && typeof value === "string") return colour(value);
  if (Array.isArray(value)) return typeof value[0] === "object" && value[0] ? value.map((one) => coloured(one)) : value;
  if (value && typeof value === "object")
    return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, coloured(one, name)]));
  return value;
}

/** Break a text into lines of so many letters. */
const wrapped = (text, letters) => text.split(" ").reduce((lines, word) => {
  if (lines.length && `${lines.at(-1)} ${word}`.length <= Math.max(letters, 8)) lines.push(`${lines.pop()} ${word}`);
  else lines.push(word);
  return lines;
}, []).join("<br>");

function layoutOf(given, { offsetWidth: width, offsetHeight: height }, data) {
  const line = { gridcolor: colour("line"), zerolinecolor: colour("line"), linecolor: colour("grey"), automargin: false,
    fixedrange: true, exponentformat: "none", separatethousands: true, ticks: "outside", tickcolor: colour("grey"), ticklen: 4 };
  const layout = coloured(given);
  for (const name of Object.keys(layout).filter((one) => /^[xy]axis/.test(one))) {
    const axis = layout[name];
    const room = (name[0] === "x" ? width - 80 : height - 70) * (axis.domain ? axis.domain[1] - axis.domain[0] : 1);
    layout[name] = { ...line, ...axis, title: { standoff: 6, ...axis.title, text: wrapped(axis.title?.text ?? "", room / 6.4) } };
    if (name === "yaxis" && data[0].type === "bar") {
      const names = [...new Set(data.flatMap((one) => one.y))];
      Object.assign(layout.yaxis, { tickmode: "array", tickvals: names, ticktext: names.map((one) => wrapped(one, width / 22)) });
    }
  }
  if (layout.polar) {
    const round = { gridcolor: colour("line"), linecolor: colour("grey"), exponentformat: "none", separatethousands: true };
    layout.polar = { bgcolor: "rgba(0,0,0,0)", angularaxis: { ...round, ...layout.polar.angularaxis },
      radialaxis: { ...round, tickfont: { size: 10 }, ...layout.polar.radialaxis, title: { text: "" } } };
  }
  const long = layout.yaxis?.type === "log" && layout.yaxis.range?.[1] > 5.2; // "10 000 000"
  return {
    autosize: true, showlegend: false, dragmode: false, hovermode: "closest", paper_bgcolor: colour("paper"), plot_bgcolor: "rgba(0,0,0,0)",
    margin: layout.polar ? { l: 44, r: 44, t: 32, b: 36 } : { l: long ? 92 : layout.yaxis.title.text.includes("<br>") ? 78 : 64, r: 14, t: 12, b: layout.xaxis.title.text.includes("<br>") ? 62 : 48 },
    font: { family: getComputedStyle(document.body).fontFamily, size: 12, color: colour("ink") },
    hoverlabel: { bgcolor: colour("paper"), bordercolor: colour("grey"), font: { color: colour("ink") } },
    ...layout,
  };
}

function legendOf(own, data) {
  const names = new Map(data.filter((one) => one.name).map((one) => [one.name, one]));
  const text = JSON.stringify([...names].map(([name, one]) => [name, one.line, one.marker?.color, one.marker?.symbol]));
  if (own.legendText === text) return;
  own.legendText = text;
  own.legend.replaceChildren(...[...names].map(([name, one]) => {
    const stroke = one.line?.color ?? one.marker?.color ?? colour("ink");
    const [shape, open] = (one.marker?.symbol ?? "circle").split("-open");
    const marks = !one.line || one.mode?.includes("markers")
      ? `<path d="${MARKS[shape] ?? MARKS.circle}" fill="${open === undefined ? stroke : "none"}" stroke="${stroke}"/>` : "";
    const dash = one.line ? `<path d="M1 6H31" stroke="${stroke}" stroke-width="2" fill="none" stroke-dasharray="${DASHES[one.line.dash] ?? "none"}"/>` : "";
    const item = make("li");
    item.innerHTML = `<svg viewBox="0 0 32 12" aria-hidden="true">${one.type === "bar" ? `<rect x="8" width="16" height="12" fill="${stroke}"/>` : dash + marks}</svg>`;
    item.append(name);
    return item;
  }));
}

function fillTable(own) {
  if (own.numbers.hidden || !own.now || own.now.empty) return;
  const { data, layout } = own.now;
  const write = new Intl.NumberFormat(language, { maximumSignificantDigits: 5 });
  const text = (value) => (typeof value === "number" ? write.format(value) : (value ?? "–"));
  const plain = (axis) => axis?.title?.text?.replace(/<[^>]*>/g, " ") ?? "";
  const heads = layout.polar ? [say("pictures.azimuth"), plain(layout.polar.radialaxis)] : [plain(layout.xaxis), plain(layout.yaxis)];
  const rows = data.flatMap((one) => {
    const { from = 0, to } = one.meta ?? {};
    const [first, second] = (one.r ? [one.theta, one.r] : one.type === "bar" ? [one.y, one.text ?? one.x] : [one.x, one.meta?.told ? one.text : one.y]).map((all) => all.slice(from, to));
    return first.map((value, n) => [one.name, text(value), text(second[n])]);
  });
  if (data[0]?.type === "bar") heads.reverse();
  const line = (cells, tag) => make("tr", {}, ...cells.map((cell) => make(tag, { textContent: cell })));
  own.numbers.replaceChildren(make("table", {}, make("thead", {}, line([say("pictures.line"), ...heads], "th")),
    make("tbody", {}, ...rows.map((cells) => line(cells, "td")))));
}

function resized(plot) {
  if (!plot.offsetWidth || plot._fullLayout === undefined || !plot.data) return;
  if (Math.abs(plot._fullLayout.width - plot.offsetWidth) > 1 || Math.abs(plot._fullLayout.height - plot.offsetHeight) > 1)
    for (const own of figures.values()) if (own.plot === plot && own.now) own.next ??= { ...own.now, anew: true };
  later();
}
