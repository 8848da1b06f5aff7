// The page: it starts, shows the cases and their answers, and hands each control its work.

import {
  Refused, Silent, ask, download, fillIn, make, remember, remembered, say, setHtml, speak,
} from "./ask.js";
import { startCurves, curvesStale } from "./curves.js";
import { saveReport, startDrops } from "./drops.js";
import { isSet, kindsOf, makeForm, useOrigins } from "./form.js";
import { makeLead } from "./lead.js";
import { liveLoop } from "./live.js";
import { makeMachine } from "./machine.js";
import { makeOpening } from "./opening.js";
import { offerPictures, retheme, showPictures, stalePictures, startPictures, visibleKeys } from "./pictures.js";
import { startSeek } from "./seek.js";
import { packed, unpacked } from "./share.js";
import { LONGEST_NAME, Store } from "./store.js";
import { startTolerance } from "./tolerance.js";
import { useUnits } from "./units.js";

const AGAIN = 1000; // ms until a server that does not answer is asked again
const LEFT_OUT = { friction_models: "friction", stress_volume: "lives", preload_loss: "rows" };

const $ = (id) => document.getElementById(id);
const store = new Store();
let start = null; // what GET /page/start hands over
let form = null;
let lead = null;
let shownSource = 0; // of the case that the form was made for
let toleranceStale = () => {};
let warming = 0; // timer until it is asked how far the server is

// --- starting ----------------------------------------------------------------------------------

function applyTheme() {
  const theme = remembered("theme", "");
  if (theme) document.documentElement.dataset.theme = theme;
  else delete document.documentElement.dataset.theme;
  $("theme").value = theme;
}

/** The answer of /page/start, waiting for a server that is away; one that warms up answers. */
async function started(lang) {
  for (;;) {
    try {
      const answer = await ask("start", undefined, { lang });
      speak(answer);
      banner("");
      watchWarmth(answer);
      return answer;
    } catch (error) {
      if (!(error instanceof Silent) && error.status !== 503) throw error;
      if (start) banner(say("server.silent"));
    }
    await new Promise((resolve) => setTimeout(resolve, AGAIN));
  }
}

/** Say how far a server is that still makes ready: nothing waits for it but what it calculates. */
function watchWarmth({ ready, progress }) {
  const part = Math.round(100 * (progress ?? 0));
  $("warming").hidden = ready;
  $("warming").textContent = ready ? "" : say("warming", { part });
  clearTimeout(warming);
  if (ready) return;
  warming = setTimeout(async () => {
    try {
      watchWarmth(await ask("warmth"));
    } catch {
      watchWarmth({ ready, progress });
    }
  }, AGAIN);
}

/** Put everything that has words in place; again after a change of the language. */
function arrange() {
  const root = document.documentElement;
  root.lang = start.languages[start.lang];
  useUnits(start.units, start.words["decimal.mark"]);
  useOrigins(start.origins);
  fillIn(document);
  document.title = "Rolamento";
  $("version").textContent = `Rolamento ${start.version}`;
  const names = new Intl.DisplayNames([root.lang], { type: "language" });
  $("language").replaceChildren(...Object.entries(start.languages).map(([code, tag]) => make("option", {
    value: code, selected: code === start.lang, lang: tag,
    textContent: new Intl.DisplayNames([tag], { type: "language" }).of(code) ?? names.of(code),
  })));
  if (!store.current) $("title").textContent = say("untitled");
  opening.arrange(start.examples);
  machine.arrange(start.machine);
  form = makeForm($("form"), start, store, (name, value, quick) => {
    store.change(name, value);
    live.follow(quick);
    buttons();
  });
  shownSource = 0;
  lead = makeLead({
    fields: start.form.groups.flatMap((group) => group.fields), current: () => store.current, names: () => store.names,
    change: (changes, aside = false) => {
      if (aside && store.slots.length === 1) goTo(() => store.compare()); // beside what there is
      for (const [name, value] of Object.entries(changes)) store.change(name, value);
      showCases();
      live.restart();
    },
  });
  $("pictures").replaceChildren();
  startPictures($("pictures"), start.pictures, start.words, { lang: start.lang, onVisible: () => store.current && live.follow() });
  $("curves").replaceChildren();
  startCurves($("curves"), { words: start.words, lang: start.lang, say, ask, cases: () => shownSlots().map((one) => one.case) });
  startSeek($("seek"), { current: () => store.current, use: (field, value) => {
    store.change(field, value);
    showCases();
    live.follow();
  } });
  toleranceStale = startTolerance($("tolerance"), { current: () => store.current });
  watcher.disconnect();
  $("sections").replaceChildren(...[{ key: "notes", label: say("notes") }, ...start.sections].map(makeSection));
  for (const kind of ["weibull", "signal"]) {
    $(kind).replaceChildren(make("h1", { textContent: say(`view.${kind}`) }));
    delete $(kind).dataset.started;
  }
}

function makeSection({ key, label }) {
  const body = make("div", { className: "rolamento" });
  const details = make("details", {
    className: "section", open: remembered(`section.${key}`, ["notes", "loads", "lives"].includes(key)),
    ontoggle: () => {
      remember(`section.${key}`, details.open);
      if (details.open && !body.dataset.filled && key !== "notes" && store.current) live.follow();
    },
  }, make("summary", {}, make("h2", { textContent: label })), body);
  details.dataset.section = key;
  watcher.observe(details);
  return details;
}

async function changeLanguage(lang) {
  remember("lang", lang);
  start = await started(lang);
  arrange();
  if (store.current) {
    showCases();
    live.restart();
  }
  showView();
}

// --- views -------------------------------------------------------------------------------------

function showView() {
  const wanted = location.hash.slice(1);
  const view = ["machine", "weibull", "signal"].includes(wanted) ? wanted : "case";
  for (const one of document.querySelectorAll(".view")) one.hidden = one.id !== view;
  for (const link of document.querySelectorAll("[data-view]")) {
    if (link.dataset.view === view) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  const root = $(view);
  if (view === "machine") machine.enter().catch(complain);
  else if (view !== "case" && !root.dataset.started) {
    root.dataset.started = "yes";
    startDrops(root, view, start.drops, { lang: start.lang, setHtml, currentCase });
  }
}

const currentCase = () => store.current && { case: store.current.case, title: titleOf(store.current) };

async function followAddress() {
  if (!location.hash.startsWith("#case=")) {
    showView();
    return;
  }
  const text = location.hash.slice("#case=".length);
  history.replaceState(null, "", "#case");
  showView();
  try {
    await openKept(await unpacked(text).catch(() => {
      throw new Refused({ message: say("link.broken") });
    }));
  } catch (error) {
    complain(error);
    if (!store.current) opening.show(true);
  }
}

// --- cases -------------------------------------------------------------------------------------

/** Cases of a link or of the last visit, as they were called. */
const openKept = ({ cases, names, active }) => openAll(cases.map((one) => ({ case: one })), active, names);

async function openAll(requests, active = 0, names = []) {
  const answers = [];
  for (const one of requests) answers.push(await ask("open", one));
  if (requests.length > 1) store.slots = [];
  store.open(answers, active, names);
  opening.show(false);
  banner("");
  showCases();
  live.restart();
}

/** The cases that pictures show: the first, and the edited one or the second. */
function shownSlots() {
  const { slots, active } = store;
  return slots.length > 1 ? [slots[0], slots[active || 1]] : slots;
}

const titleOf = (slot) => slot.case.title || slot.case.bearing?.designation || say("untitled");

/** Show what does not need an answer: title, the form, which case is edited. */
function showCases() {
  const { current, slots } = store;
  $("work").hidden = false;
  const titles = [...new Set(slots.map(titleOf))];
  $("title").textContent = titles.join(" · ");
  document.title = `${titleOf(current)} – Rolamento`;
  $("slots").hidden = slots.length < 2;
  $("compare").setAttribute("aria-pressed", String(slots.length > 1));
  showSlots();
  if (current.source !== shownSource) form.rebuild();
  else form.show();
  shownSource = current.source;
  offerPictures(start.pictures.filter(suitable).map((one) => one.key));
  showStatus();
  buttons();
}

/** The cases by name, of which one is edited. */
function showSlots() {
  const known = JSON.stringify([store.names, store.active]);
  if ($("slot-list").dataset.known === known) return;
  $("slot-list").dataset.known = known;
  $("add").hidden = store.slots.length >= store.most;
  $("slot-list").replaceChildren(...store.slots.map((slot, n) => make("div", { className: "slot" },
    make("input", {
      type: "radio", name: "slot", value: n, checked: n === store.active, "aria-label": say("compare.edit.one", { name: store.names[n] }),
      onchange: () => {
        store.active = n;
        store.keep();
        showCases();
        live.restart();
      },
    }),
    make("input", {
      type: "text", value: store.names[n], maxLength: LONGEST_NAME, autocomplete: "off", "aria-label": say("compare.name", { name: store.names[n] }),
      onchange: (event) => {
        store.call(n, event.target.value);
        showCases();
        live.restart();
      },
    }),
    store.slots.length > 2 ? make("button", {
      type: "button", className: "close", textContent: "×", "aria-label": say("compare.drop", { name: store.names[n] }),
      onclick: () => goTo(() => store.drop(n)),
    }) : null)));
}

function suitable({ of }) {
  const kinds = store.slots.flatMap((one) => [...kindsOf(one), isSet(one) ? "set" : ""]);
  return of.some((one) => kinds.includes(one));
}

function buttons() {
  $("undo").disabled = !store.canUndo;
  $("redo").disabled = !store.canRedo;
  for (const id of ["save", "share", "report-html", "report-pdf", "reset", "compare"]) $(id).disabled = !store.current;
}

function goTo(step) {
  step();
  showCases();
  live.restart();
}

// --- answers -----------------------------------------------------------------------------------

const sectionsOf = (state = "") => [...document.querySelectorAll(`#sections .section${state}`)];
const sectionsOpen = () => sectionsOf("[open]");

const seen = new Set(); // sections on the screen
const watcher = new IntersectionObserver((entries) => {
  for (const one of entries) {
    if (one.isIntersecting) seen.add(one.target.dataset.section);
    else seen.delete(one.target.dataset.section);
  }
});

const live = liveLoop(store, {
  wishes: (quick) => ({
    active: store.active,
    pictures: visibleKeys(quick),
    sections: sectionsOpen().map((one) => one.dataset.section)
      .filter((key) => key !== "notes" && (!quick || seen.has(key))),
  }),
  root: $("work"),
  waiting: () => {
    curvesStale();
    toleranceStale();
  },
  show: showAnswer,
  stale, recover, complain,
});

function showAnswer(answer, quick, asked) {
  if (quick) {
    form.show(Object.keys(asked[store.active]?.changes ?? {}));
  } else showCases();
  const right = answer.cases.some((one) => !one.error);
  stale(right ? "" : say("stale.wrong"));
  if (!right) {
    stalePictures(visibleKeys());
    return;
  }
  lead.show(answer, quick, store);
  showPictures(answer.pictures);
  const late = answer.cases.flatMap((one) => one.status?.left_out ?? []).map((one) => LEFT_OUT[one]);
  for (const section of sectionsOf()) {
    const key = section.dataset.section;
    const body = section.lastElementChild;
    const html = key === "notes" ? answer.notes : answer.sections[key];
    if (html || (html === "" && !(key === "notes" && quick))) {
      setHtml(body, html.trim() ? html : `<p>${say(key === "notes" ? "notes.none" : "section.none")}</p>`);
      body.dataset.filled = "yes";
    } else if (!section.open) {
      body.replaceChildren(); // nothing old comes to light
      delete body.dataset.filled;
    }
    mark(section, quick && !html ? say("stale.waiting") : late.includes(key) ? say("stale.part") : "",
      Boolean(html));
  }
}

/** Say of the results that they are not current; "" that they are. */
function stale(word) {
  showStatus();
  for (const one of [$("figures"), $("drawing"), $("compared"), $("pictures"), ...sectionsOf()]) mark(one, word);
}

function mark(element, word, isPart = false) {
  if (word) element.dataset.stale = word;
  else delete element.dataset.stale;
  element.classList.toggle("part", isPart);
}

function showStatus() {
  const many = store.slots.length > 1;
  const lines = store.slots.map((slot, n) => {
    const { status, error } = slot;
    if (!error && status?.unloaded) // what is asked for says so itself
      return make("p", { className: "faint" }, ` ${many ? `${store.names[n]}: ` : ""}${say("first.status")}`);
    const good = !error && status?.converged && !status.advice;
    const sign = error ? "✗" : good ? "✓" : status ? "!" : "…";
    const plain = error ? wrongOf(error) : !status ? say("stale.waiting")
      : good ? say("status.converged") : [status.text, status.advice].filter(Boolean).join(". ");
    const text = plain.charAt(0).toUpperCase() + plain.slice(1);
    const line = make("p", { className: error ? "bad" : good ? "good" : status ? "warning" : "faint" },
      make("span", { "aria-hidden": "true", textContent: sign }), ` ${many ? `${store.names[n]}: ` : ""}${text}`);
    return line;
  });
  const text = lines.map((one) => one.textContent).join();
  if (text === $("status").textContent) return; // it is read aloud when it changes
  $("status").replaceChildren(...lines);
}

/** What is wrong with an input, by the label of its field; there stands how to mend it. */
function wrongOf({ field, rule, message }) {
  const own = start.form.groups.flatMap((group) => group.fields).find((one) => one.name === field);
  return own && rule ? `${own.label}: ${rule}` : message;
}

function banner(text) {
  $("banner").textContent = text;
  $("banner").hidden = !text;
}

/** Wait until a server answers again that is away or has too much to do. */
async function recover(error) {
  banner(error instanceof Silent ? say("server.silent") : error.message);
  await new Promise((resolve) => setTimeout(resolve, AGAIN));
  await started(start.lang);
}

/** Tell of an error that belongs to no field. */
function complain(error) {
  if (error instanceof Silent) banner(say("server.silent"));
  else if (error instanceof Refused || !(error instanceof Error)) banner(error.message);
  else {
    banner(say("page.failed"));
    console.error(error);
  }
}

/** Let a control do something that can fail. */
const doing = (work) => async (event) => {
  try {
    banner("");
    await work(event);
  } catch (error) {
    complain(error);
  }
};

// --- controls ----------------------------------------------------------------------------------

const opening = makeOpening({
  panel: $("opening"), button: $("open"),
  open: (request) => openAll([request]),
  mayClose: () => Boolean(store.current),
});

const machine = makeMachine({ complain, recover, doing, lang: () => start.lang });

$("save").onclick = doing(async () => {
  const { text, name } = await ask("save", { case: store.current.case, format: "toml" });
  download(text, name, "application/toml");
});
for (const format of ["html", "pdf"])
  $(`report-${format}`).onclick = doing(async () => {
    $(`report-${format}`).disabled = true;
    try {
      await saveReport({ cases: store.slots.map((one) => one.case), names: store.slots.length > 1 ? store.names : [] }, format, { lang: start.lang });
    } finally {
      buttons();
    }
  });
$("share").onclick = doing(async () => {
  const part = await packed(store.given);
  $("link").value = `${location.origin}${location.pathname}#case=${part}`;
  $("copied").textContent = "";
  $("sharing").showModal();
  $("link").select();
});
$("copy").onclick = async () => {
  try {
    await navigator.clipboard.writeText($("link").value);
    $("copied").textContent = say("share.copied");
  } catch {
    $("link").select();
    $("copied").textContent = say("share.select");
  }
};
$("undo").onclick = () => goTo(() => store.undo());
$("redo").onclick = () => goTo(() => store.redo());
$("reset").onclick = () => goTo(() => store.reset());
$("compare").onclick = () => goTo(() => (store.slots.length > 1 ? store.single() : store.compare()));
$("keep").onclick = () => goTo(() => store.single());
$("add").onclick = () => goTo(() => store.compare());
$("filter").oninput = () => form.filter($("filter").value);
$("language").onchange = doing(() => changeLanguage($("language").value));
$("theme").onchange = () => {
  remember("theme", $("theme").value || null);
  applyTheme();
  retheme();
};
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", retheme);
for (const one of document.querySelectorAll(".panes button"))
  one.onclick = () => {
    document.body.dataset.pane = one.dataset.pane;
    for (const other of document.querySelectorAll(".panes button"))
      other.setAttribute("aria-pressed", String(other === one));
    if (store.current) live.follow();
  };
addEventListener("hashchange", followAddress);
addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const prefix = !$("case").hidden ? "" : !$("machine").hidden ? "machine-" : null;
  if (prefix === null) return;
  const { target } = event;
  const typing = target.matches?.("input:not([type=range], [type=checkbox], [type=radio]), textarea")
    && target.value !== (target.dataset.put ?? "");
  const key = event.key.toLowerCase();
  const wanted = key === "s" ? "save" : typing ? "" : key === "z" ? (event.shiftKey ? "redo" : "undo") : key === "y" ? "redo" : "";
  if (!wanted) return;
  event.preventDefault();
  const button = $(prefix + wanted);
  if (!button.disabled) button.click();
});

applyTheme();
try {
  start = await started(remembered("lang", ""));
  arrange();
  const kept = Store.kept();
  buttons();
  if (location.hash.startsWith("#case=")) await followAddress();
  else {
    showView();
    try {
      if (kept) await openKept(kept);
      else opening.show(true);
    } catch {
      opening.show(true); // what was kept is of another version
    }
  }
} catch (error) {
  complain(error);
}
