// What leads the results: the drawing, key figures with their limits, what is asked for first, what
// differs between cases, and what would help.

import { Refused, ask, make, say, setHtml } from "./ask.js";
import { indexed } from "./form.js";
import { parted, shown, typed } from "./units.js";

const FIRST = ["duty.load.fz", "duty.load.fx", "duty.inner_speed"];
const IN_A_ROW = 5; // figures of each case where several stand side by side
const AHEAD = ["life", "extremes.max_pressure", "analysis.life.loads.static_safety", "analysis.film.viscosity_ratio", "analysis.friction.power"];
const REST = 600; // ms without a change, after which is asked what would help

const $ = (id) => document.getElementById(id);

/**
 * @param {object} of  `fields`: all of the form; `change(changes)`: put values into the edited
 *   case; `current()`: its slot; `names()`: what the cases are called
 */
export function makeLead({ fields, change, current, names }) {
  const byName = new Map(fields.map((one) => [one.name, one]));
  let timer = 0;
  let asked = "";

  // --- the drawing -----------------------------------------------------------------------------

  function showDrawing(svg) {
    const [place, caption] = $("drawing").children;
    if (!svg || place.dataset.shown === svg) return;
    place.dataset.shown = svg;
    place.innerHTML = svg;
    const title = place.querySelector("title");
    caption.textContent = title?.textContent ?? "";
    title?.remove(); // it would cover the drawing wherever the pointer rests
  }

  // --- key figures -----------------------------------------------------------------------------

  const gauge = (share) => {
    const bar = make("i");
    bar.style.width = `${Math.min(100 * share, 100)}%`;
    return make("div", { className: "gauge", "aria-hidden": "true" }, bar);
  };

  function figure(one) {
    const value = make("dd", {}, one.value);
    if (one.unit) value.append(" ", make("small", { textContent: one.unit }));
    const limit = make("dd", { className: "limit", textContent: one.limit });
    const element = make("dl", { className: `figure ${one.tone} ${one.key === "theory" ? "theory" : ""}` },
      make("dt", {}, ...indexed(one.label)), value);
    element.dataset.key = one.key;
    element.style.margin = "0";
    if (one.limit) element.append(make("div", {}, gauge(one.share ?? 0)), limit);
    return element;
  }

  function showFigures(all, active) {
    const root = $("figures");
    if (all.length === 1) {
      const rank = (one) => (one.key === "life" ? 0 : one.limit ? 1 : 2); // limits in one row
      root.replaceChildren(...[...all[0]].sort((a, b) => rank(a) - rank(b)).map(figure));
      return;
    }
    const there = [...new Set(all.flat().map((one) => one.key))].filter((key) => key !== "theory");
    const keys = [...AHEAD.filter((key) => there.includes(key)), ...there.filter((key) => !AHEAD.includes(key))].slice(0, IN_A_ROW);
    const labels = new Map(all.flat().map((one) => [one.key, one]));
    const head = make("tr", {}, make("td"), ...keys.map((key) => make("th", { scope: "col" }, ...indexed(labels.get(key).label))));
    const rows = all.map((own, n) => make("tr", { className: n === active ? "edited" : "" },
      make("th", { scope: "row", textContent: names()[n] }), ...keys.map((key) => {
        const one = own.find((known) => known.key === key);
        return make("td", { className: one?.tone ?? "", textContent: one ? `${one.value} ${one.unit}`.trim() : "–", title: one?.limit ?? "" });
      })));
    root.replaceChildren(make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows)));
  }

  // --- several cases ---------------------------------------------------------------------------

  function showCompared(answer, slots) {
    const many = slots.length > 1;
    $("compared").hidden = !many;
    if (!many) return;
    const said = (slot, name) => {
      const text = slot.inputs[name]?.text;
      const found = text === undefined ? null : parted(text);
      return found ? `${shown(found.number)} ${found.unit}`.trim() : (text ?? "–");
    };
    const changed = [...new Set(slots.flatMap((one) => Object.keys(one.inputs)))]
      .filter((name) => byName.has(name) && name !== "title" && new Set(slots.map((one) => said(one, name))).size > 1);
    const head = make("tr", {}, make("td"), ...names().map((name) => make("th", { scope: "col", textContent: name })));
    $("changed").replaceChildren(changed.length ? make("table", { className: "plain" }, make("thead", {}, head),
      make("tbody", {}, ...changed.map((name) => make("tr", {}, make("th", { scope: "row" }, ...indexed(byName.get(name).label)),
        ...slots.map((one) => make("td", { textContent: said(one, name) })))))) : make("p", { textContent: say("compare.alike") }));
    setHtml($("summary"), answer.summary);
    setHtml($("same").lastElementChild, answer.same);
    $("same").hidden = !answer.same;
  }

  // --- what is asked for first -----------------------------------------------------------------

  function showFirst(slots, active) {
    const slot = slots[active];
    const empty = !slot.error && slot.status?.code === "converged" && slot.status.unloaded;
    const form = $("first");
    $("results").classList.toggle("unloaded", Boolean(empty) || slots.every((one) => !one.error && one.status && !one.status.converged));
    if (form.hidden === !empty) return;
    form.hidden = !empty;
    if (!empty) return;
    form.querySelector(".fields").replaceChildren(...FIRST.map((name) => byName.get(name)).filter(Boolean).map((field) => {
      const id = `first-${field.name}`;
      return make("div", {}, make("label", { for: id }, ...indexed(capital(field.label))),
        make("input", { id, name: field.name, type: "text", inputMode: "decimal", autocomplete: "off", placeholder: `${slot.likely?.[field.name]?.example ?? field.example}` }));
    }));
  }

  $("first").onsubmit = (event) => {
    event.preventDefault();
    const found = {};
    for (const input of $("first").querySelectorAll("input")) {
      const text = input.value.trim();
      if (!text) continue;
      const field = byName.get(input.name);
      const { number, doubt, unit, text: read } = typed(text);
      const value = number ?? doubt?.whole; // it is shown at once, on the drawing too
      found[input.name] = value === undefined ? read : `${value} ${unit || (field.unit === "µm" ? "um" : field.unit)}`;
    }
    if (Object.keys(found).length) change(found);
    else $("first").querySelector("input").focus();
  };

  // --- what would help -------------------------------------------------------------------------

  function askHelps() {
    clearTimeout(timer);
    const slot = current();
    if (!slot?.status || slot.error || slot.status.unloaded) {
      $("helps").hidden = true;
      asked = "";
      return;
    }
    const text = JSON.stringify(slot.case);
    if (text === asked) return;
    $("helps").classList.add("late");
    timer = setTimeout(async () => {
      asked = text;
      let answer;
      try {
        answer = await ask("helps", { case: slot.case });
      } catch (error) {
        if (!(error instanceof Refused)) asked = "";
        $("helps").hidden = true;
        return;
      }
      if (text !== asked) return;
      $("helps").classList.remove("late");
      $("helps").hidden = !answer.trials.length;
      $("helps").querySelector("ul").replaceChildren(...answer.trials.map((one) => {
        const can = Object.keys(one.changes).length > 0;
        return make("li", {}, make("span", { textContent: one.label }),
          make("span", { className: `times ${one.ratio > 1.005 ? "" : "less"}`, textContent: one.times }),
          can ? make("button", { type: "button", className: "button", textContent: say("helps.try"), "aria-label": `${say("helps.try")}: ${one.label}`, onclick: () => change(one.changes, slot.status.converged) }) : make("span"));
      }));
    }, REST);
  }

  function show(answer, quick, { slots, active }) {
    showDrawing(answer.cases[active]?.drawing);
    showFigures(answer.figures, active);
    showCompared(answer, slots);
    if (quick) return;
    showFirst(slots, active);
    setHtml($("leading").lastElementChild, answer.leading);
    $("leading").hidden = !answer.leading.trim();
    askHelps();
  }

  return { show };
}

const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
