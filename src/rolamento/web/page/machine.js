// The page of a machine: its drawing, what is taken hold of and moved there, and what follows.

import { Refused, Silent, ask, download, make, remember, remembered, say, setHtml } from "./ask.js";
import { saveReport } from "./drops.js";
import { indexed, put } from "./form.js";
import { liveLoop } from "./live.js";
import { Store, valueAt } from "./store.js";
import { fromSi, parted, rounded, shown, toSi, typed, unitNamed } from "./units.js";

const SVG = "http://www.w3.org/2000/svg";
const MOST_BYTES = 500_000;
const PAPER = 0.22; // mm of the drawing's paper for a pixel: its small type is read on a screen
const SHAPES = { bearings: "M-6 5L0-5L6 5Z", loads: "M-5.5 0L0-5.5L5.5 0L0 5.5Z" };
const SHAPE = "M-5-5H5V5H-5Z";
const KEYS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10 };

const $ = (id) => document.getElementById(id);

/**
 * The page of a machine.
 * @param {object} of  `complain(error)`; `recover(error)`: waits for a server that is away; `doing(work)`; `lang()`
 * @returns {{arrange: Function, enter: Function}}  after a change of language; when it is shown
 */
export function makeMachine({ complain, recover, doing, lang }) {
  const store = new Store("machine");
  const which = make("select", { id: "machine-which", onchange: () => choose(which.value) });
  const grips = new Map(); // part → its elements on the drawing
  let fields = new Map(); // dotted name → {input, error}
  let last = null; // the last answer with a result
  let chosen = ""; // the part whose fields are shown
  let held = null; // {key, position}: what is being dragged
  let step = 0;
  let entered = false;

  const live = liveLoop(store, {
    path: "machine/live",
    request: ([one]) => ({ machine: one.case, changes: one.changes }),
    taken: (answer) => [{ ...answer, case: answer.machine }],
    wishes: (quick) => ({ step, width: paper(), pictures: quick ? [] : openPictures() }),
    root: $("machine-work"),
    show, stale, recover, complain,
  });

  // --- opening ---------------------------------------------------------------------------------

  function showOpening(isOpen) {
    $("machine-opening").hidden = !isOpen;
    $("machine-open").setAttribute("aria-expanded", String(isOpen));
    $("machine-file-error").textContent = "";
  }

  async function open(request) {
    try {
      const { machine } = await ask("machine/open", request);
      [step, last, chosen, held] = [0, null, "", null];
      store.open([{ case: machine }]);
    } catch (error) {
      if (!(error instanceof Refused || error instanceof Silent)) throw error;
      showOpening(true);
      $("machine-file-error").textContent = error instanceof Silent ? say("server.silent") : error.message;
      return;
    } finally {
      $("machine-input").value = "";
    }
    showOpening(false);
    $("machine-work").hidden = false;
    live.restart();
    buttons();
  }

  async function read(file) {
    if (!file) return;
    if (file.size > MOST_BYTES) {
      showOpening(true);
      $("machine-file-error").textContent = say("machine.large");
      return;
    }
    const format = /\.json$/i.test(file.name) ? "json" : /\.toml$/i.test(file.name) ? "toml" : undefined;
    await open({ text: await file.text(), format, name: file.name });
  }

  // --- answers ---------------------------------------------------------------------------------

  function show(answer, quick) {
    buttons();
    showStatus();
    if (answer.error) {
      stale(say("stale.wrong"));
      showFields();
      return;
    }
    last = answer;
    for (const part of answer.parts) { // moved on since it was asked
      const later = parted(store.current.changes[`${part.key}.position`] ?? "");
      const unit = later && unitNamed("length", later.unit);
      if (unit) part.position = toSi(later.number, unit);
    }
    $("machine-title").textContent = answer.title || say("machine.untitled");
    showSteps();
    showDrawing();
    choose(answer.parts.some((one) => one.key === chosen) ? chosen : (answer.parts.find((one) => one.kind === "loads") ?? answer.parts[0])?.key);
    stale("");
    showSections(answer.sections);
    for (const element of document.querySelectorAll("#machine-pictures .section")) {
      const html = answer.pictures[element.dataset.picture];
      if (html) setHtml(element.lastElementChild, html);
      mark(element, html || !element.open ? "" : say("stale.waiting"));
    }
  }

  function stale(word) {
    for (const one of [$("machine-stage"), $("machine-life"), ...document.querySelectorAll("#machine-work .section")]) mark(one, word);
  }

  function mark(element, word) {
    if (word) element.dataset.stale = word;
    else delete element.dataset.stale;
  }

  function showStatus() {
    const { status, error } = store.current;
    const good = !error && status?.converged;
    const sign = error ? "✗" : good ? "✓" : status ? "!" : "…";
    const text = error ? error.message : !status ? say("stale.waiting")
      : good ? say("status.converged") : [status.text, status.advice].filter(Boolean).join(". ");
    if ($("machine-status").textContent === `${sign} ${text}`) return;
    $("machine-status").replaceChildren(make("p", { className: error ? "bad" : good ? "good" : status ? "warning" : "faint" },
      make("span", { "aria-hidden": "true", textContent: sign }), ` ${text}`));
  }

  function showSteps() {
    const { steps } = last;
    $("machine-steps").hidden = !steps.length;
    if ($("machine-step").options.length !== steps.length || [...$("machine-step").options].some((one, n) => one.textContent !== steps[n]))
      $("machine-step").replaceChildren(...steps.map((name, value) => make("option", { value, textContent: name })));
    step = last.step;
    $("machine-step").value = String(step);
  }

  function showSections(all) {
    const life = all.find((one) => one.key === "life");
    $("machine-life").hidden = !life;
    $("machine-life-head").textContent = life?.label ?? "";
    setHtml($("machine-life").lastElementChild, life?.html ?? "");
    const isBearings = (one) => one.key === "bearings";
    fill($("machine-bearings"), all.filter(isBearings));
    fill($("machine-sections"), all.filter((one) => one !== life && !isBearings(one)));
  }

  function fill(root, sections) {
    const keys = sections.map((one) => one.key + one.label).join();
    if (root.dataset.keys !== keys) {
      root.dataset.keys = keys;
      root.replaceChildren(...sections.map(({ key, label }) => make("details", {
        className: "section", open: remembered(`machine.${key}`, key !== "frequencies"),
        ontoggle: (event) => remember(`machine.${key}`, event.target.open),
      }, make("summary", {}, make("h2", { textContent: label })), make("div", { className: "rolamento" }))));
    }
    sections.forEach(({ html }, n) => setHtml(root.children[n].lastElementChild, html));
  }

  const openPictures = () => [...document.querySelectorAll("#machine-pictures .section[open]")].map((one) => one.dataset.picture);

  // --- the drawing -----------------------------------------------------------------------------

  const paper = () => 5 * Math.round(($("machine-stage").clientWidth * PAPER) / 5);

  const drawn = (name, attributes = {}) => {
    const element = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    return element;
  };

  function showDrawing() {
    const { image, width, height, lines, times } = last.drawing;
    $("machine-image").src = image;
    $("machine-image").width = width;
    $("machine-image").height = height;
    const hold = $("machine-hold");
    hold.setAttribute("viewBox", `0 0 ${width} ${height}`);
    for (const old of hold.querySelectorAll(".bent")) old.remove();
    hold.prepend(...lines.map(({ plane, points }) => drawn("polyline", { class: `bent ${plane}`, points: points.join(" ") })));
    $("machine-legend").textContent = times ? say("machine.bent", { times: shown(times) }) : "";
    for (const [key, { element }] of grips) {
      if (last.parts.some((one) => one.key === key)) continue;
      element.remove();
      grips.delete(key);
    }
    for (const part of last.parts) showGrip(part);
  }

  const placeOf = (part, position) => last.drawing.left + last.drawing.scale * (part.start + position);
  const partOf = (key) => last?.parts.find((one) => one.key === key);

  /** A position as a field has it: in the unit that the machine has, else in mm. */
  function written(part, position) {
    const given = parted(valueAt(store.current.case, `${part.key}.position`) ?? "");
    const unit = unitNamed("length", given?.unit ?? "mm") ?? unitNamed("length", "mm");
    return { text: `${Number(fromSi(position, unit).toPrecision(9))} ${unit.unit}`, label: `${shown(fromSi(position, unit))} ${unit.label}` };
  }

  function showGrip(part) {
    let own = grips.get(part.key);
    if (!own) {
      own = {
        element: drawn("g", { class: "grip", role: "slider", tabindex: 0, "aria-orientation": "horizontal" }),
        line: drawn("line"), hit: drawn("circle", { class: "hit", r: 15 }), path: drawn("path"), text: drawn("text"),
      };
      own.element.append(own.line, own.hit, own.path, own.text);
      $("machine-hold").append(own.element);
      grips.set(part.key, own);
      listen(own.element, part.key);
    }
    const position = held?.key === part.key ? held.position : part.position;
    const x = placeOf(part, position);
    const { label } = written(part, position);
    const isBelow = part.y > part.axis; // where its name is, so that its position stands beside it
    const isLast = isBelow && x > last.drawing.width - 55;
    own.path.setAttribute("d", SHAPES[part.kind] ?? SHAPE);
    for (const one of [own.hit, own.path]) one.setAttribute("transform", `translate(${x} ${part.y})`);
    for (const [key, value] of Object.entries({ x1: x, x2: x, y1: part.axis, y2: part.y })) own.line.setAttribute(key, value);
    own.text.setAttribute("x", x + (isLast ? -9 : isBelow ? 9 : 0));
    own.text.setAttribute("y", part.y + (isBelow ? 4 : -10));
    own.text.setAttribute("text-anchor", isLast ? "end" : isBelow ? "start" : "middle");
    own.text.textContent = label;
    own.element.setAttribute("aria-label", say("machine.position", { part: part.label, shaft: part.shaft }));
    own.element.setAttribute("aria-valuemin", "0");
    own.element.setAttribute("aria-valuemax", String(1e3 * part.length));
    own.element.setAttribute("aria-valuenow", String(1e3 * position));
    own.element.setAttribute("aria-valuetext", label);
    own.element.classList.toggle("chosen", part.key === chosen);
  }

  /** Put a part somewhere along its shaft. */
  function move(key, position, quick) {
    const part = partOf(key);
    const to = Math.min(Math.max(position, 0), part.length);
    (held ?? part).position = to;
    store.change(`${key}.position`, written(part, to).text);
    showGrip(part);
    showFields();
    live.follow(quick);
    buttons();
  }

  function listen(element, key) {
    let offset = 0;
    const metres = (event) => {
      const box = $("machine-hold").getBoundingClientRect();
      return ((event.clientX - box.left) * (last.drawing.width / box.width) - last.drawing.left) / last.drawing.scale - partOf(key).start;
    };
    element.onpointerdown = (event) => {
      if (event.button || !partOf(key)) return;
      choose(key);
      element.setPointerCapture(event.pointerId);
      element.focus({ preventScroll: true });
      offset = metres(event) - partOf(key).position;
      held = { key, position: partOf(key).position, from: event.clientX, moved: false };
      event.preventDefault();
    };
    element.onpointermove = (event) => {
      if (held?.key !== key || (!held.moved && Math.abs(event.clientX - held.from) < 3)) return;
      held.moved = true;
      const pixel = last.drawing.width / $("machine-hold").clientWidth / last.drawing.scale;
      move(key, rounded(metres(event) - offset, Math.max(pixel, 1e-4)), true);
    };
    element.onpointerup = element.onpointercancel = () => {
      if (held?.key !== key) return;
      const { moved, position } = held;
      held = null;
      if (moved) move(key, position, false);
    };
    element.onkeydown = (event) => {
      const part = partOf(key);
      const by = KEYS[event.key] * (event.shiftKey ? 10 : 1) * 1e-3;
      const to = event.key === "Home" ? 0 : event.key === "End" ? part.length : part.position + by;
      if (Number.isNaN(to) || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      move(key, Number(to.toFixed(7)), true);
    };
    element.onfocus = () => choose(key);
  }

  // --- the part that is chosen -----------------------------------------------------------------

  function choose(key) {
    const part = partOf(key);
    if (!part) return;
    const isNew = key !== chosen;
    chosen = key;
    for (const [other, { element }] of grips) element.classList.toggle("chosen", other === key);
    const others = [...grips].filter(([other]) => other !== key).map(([, { element }]) => element);
    if (isNew) grips.get(key)?.element.before(...others); // it lies over them, and keeps the focus
    const names = part.fields.map((one) => one.name).join();
    if (isNew || $("machine-part").dataset.names !== names) makeFields(part, names);
    if ([...which.options].map((one) => one.textContent).join() !== last.parts.map((one) => one.label).join())
      which.replaceChildren(...last.parts.map((one) => make("option", { value: one.key, textContent: one.label })));
    which.value = key;
    showFields();
  }

  function makeFields(part, names) {
    const form = $("machine-part");
    if (!form.childElementCount)
      form.append(make("div", { className: "field" }, make("label", { for: which.id, textContent: say("machine.part") }), which), make("div"));
    form.dataset.names = names;
    fields = new Map();
    form.lastElementChild.replaceChildren(...part.fields.map(({ name, label, example }, n) => {
      const error = make("p", { className: "error", role: "alert", id: `machine-error-${n}` });
      const unit = make("span", { className: "unit" });
      const input = make("input", {
        type: "text", id: `machine-field-${n}`, autocomplete: "off", spellcheck: false, maxLength: 100,
        "aria-describedby": error.id, onchange: () => enter(name),
      });
      input.dataset.name = name;
      fields.set(name, { input, unit, error, usual: parted(example)?.unit ?? "" });
      return make("div", { className: "field" }, make("label", { for: input.id }, ...indexed(label)),
        make("div", { className: "row" }, input, unit), error);
    }));
  }

  const isQuantity = (name) => !name.endsWith(".designation");

  function showFields() {
    if (!store.current) return;
    const { changes, error } = store.current;
    for (const [name, { input, unit, error: wrong, usual }] of fields) {
      const raw = changes[name] !== undefined ? changes[name] : valueAt(store.current.case, name);
      const given = isQuantity(name) ? parted(raw ?? "") : null;
      put(input, given ? shown(given.number, 9) : String(raw ?? ""));
      input.placeholder = isQuantity(name) ? "0" : "";
      const symbol = given?.unit ?? usual;
      unit.textContent = isQuantity(name) ? symbol.replace("um", "µm").replace("deg", "°").replace(" m", "·m") : "";
      unit.dataset.unit = symbol;
      wrong.textContent = error?.field === name ? toldOf(error) : "";
      if (error?.field === name) input.setAttribute("aria-invalid", "true");
      else input.removeAttribute("aria-invalid");
    }
  }

  const toldOf = ({ rule, example }) =>
    (example ? `${rule}${/[.?!]$/.test(rule) ? "" : "."} ${say("form.example", { example })}` : rule);

  /** Take what was typed; a number alone has the unit that stands beside it. */
  function enter(name) {
    const { input, unit, error } = fields.get(name);
    input.dataset.put = input.value;
    const { text, doubt, number, unit: own } = typed(input.value);
    if (doubt && isQuantity(name)) {
      error.textContent = say("number.doubt", doubt);
      return;
    }
    const value = !text ? null : !isQuantity(name) ? input.value.trim() : number !== undefined && !own ? `${number} ${unit.dataset.unit}` : text;
    store.change(name, value);
    live.follow();
    buttons();
  }

  // --- controls --------------------------------------------------------------------------------

  function buttons() {
    $("machine-undo").disabled = !store.canUndo;
    $("machine-redo").disabled = !store.canRedo;
    for (const id of ["save", "save-json", "report-html", "report-pdf", "reset"]) $(`machine-${id}`).disabled = !store.current;
  }

  function goTo(change) {
    change();
    held = null;
    live.restart();
    showFields();
    buttons();
  }

  const save = (format, type) => doing(async () => {
    const { text, name } = await ask("machine/save", { machine: store.current.case, format });
    download(text, name, type);
  });
  $("machine-save").onclick = save("toml", "application/toml");
  $("machine-save-json").onclick = save("json", "application/json");
  for (const format of ["html", "pdf"])
    $(`machine-report-${format}`).onclick = doing(async () => {
      $(`machine-report-${format}`).disabled = true;
      try {
        await saveReport({ machine: store.current.case }, format, { lang: lang(), path: "machine/report" });
      } finally {
        buttons();
      }
    });
  $("machine-undo").onclick = () => goTo(() => store.undo());
  $("machine-redo").onclick = () => goTo(() => store.redo());
  $("machine-reset").onclick = () => goTo(() => store.reset());
  $("machine-open").onclick = () => showOpening($("machine-opening").hidden || !store.current);
  $("machine-input").onchange = doing(() => read($("machine-input").files[0]));
  $("machine-part").onsubmit = (event) => event.preventDefault();
  $("machine-step").onchange = () => {
    step = Number($("machine-step").value);
    live.follow();
  };
  const view = $("machine");
  view.addEventListener("dragover", (event) => event.preventDefault());
  view.addEventListener("drop", doing((event) => {
    event.preventDefault();
    return read(event.dataTransfer.files[0]);
  }));
  let wide = 0;
  new ResizeObserver(() => {
    if (!last || !paper() || Math.abs(paper() - wide) < 10) return;
    wide = paper();
    live.follow();
  }).observe($("machine-stage"));

  function arrange({ examples, pictures }) {
    $("machine-examples").replaceChildren(...examples.map(({ name, title }) => make("li", {}, make("button", {
      type: "button", onclick: doing(() => open({ example: name })),
      value: name, textContent: title,
    }))));
    $("machine-pictures").replaceChildren(...pictures.map(({ key, label }) => {
      const element = make("details", {
        className: "section", open: remembered(`machine.picture.${key}`, true),
        ontoggle: () => {
          remember(`machine.picture.${key}`, element.open);
          if (element.open && last && !element.lastElementChild.childElementCount) live.follow();
        },
      }, make("summary", {}, make("h2", { textContent: label })), make("div", { className: "rolamento" }));
      element.dataset.picture = key;
      return element;
    }));
    $("machine-title").textContent = last?.title || say("machine.untitled");
    $("machine-part").replaceChildren();
    chosen = "";
    buttons();
    if (entered && store.current) live.restart();
  }

  /** The page comes to be seen: the machine of the last visit, or the choice of one. */
  async function enterPage() {
    if (entered) return;
    entered = true;
    const kept = Store.kept("machine");
    if (kept) await open({ machine: kept.cases[0] });
    else showOpening(true);
  }

  return { arrange, enter: enterPage };
}
