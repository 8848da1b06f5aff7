// A design question: what the results come to when inputs scatter, each within a tolerance.

import { ask, make, say, setHtml } from "./ask.js";
import { indexed } from "./form.js";
import { newFigure, separate, showPictures, stalePictures } from "./pictures.js";
import { choices, labelled, problemOf } from "./seek.js";
import { rounded, shown, typed } from "./units.js";

const KEY = "tolerance";
const REST = 250; // ms without a move, after which it is asked
const STEPS = 100; // of a slider, up to the greatest tolerance
const FIRST = 2; // inputs that scatter before anybody chose
const MOST = 8;
const USUAL = 0.2; // of the greatest tolerance: where a slider begins

/** Make it in `root`; `current()` is the edited slot. Returns what says that the case has changed. */
export function startTolerance(root, { current }) {
  const [more, output] = ["more", "output"].map((name) => make("select", { name }));
  const add = make("button", { type: "button", className: "button", textContent: say("tolerance.add") });
  const error = make("p", { className: "error", role: "alert", hidden: true });
  const rows = make("div", { className: "scatter" });
  const table = make("div", { className: "rolamento", role: "status" });
  const tools = make("div", { className: "tools" }, labelled("tolerance.more", more), add, labelled("tolerance.output", output));
  root.className = "seek tolerance";
  root.replaceChildren(newFigure(KEY, say("tolerance"), false, [make("p", { className: "help", textContent: say("tolerance.help") }), rows, tools, error, table]));
  separate(KEY, follow);
  const figure = root.querySelector("details");
  let sizes = null; // by field: its tolerance, SI; null before anybody chose
  let known = ""; // case and tolerances that were asked for last
  let fields = new Map();
  let timer = 0;
  let flying = null;

  const scatter = () => Object.fromEntries([...(sizes ?? [])].filter(([name, size]) => fields.has(name) && size > 0));

  async function follow() {
    const slot = current();
    if (!slot || !figure.open || slot.error || !slot.status?.converged) return;
    const request = { case: slot.case, scatter: scatter(), output: output.value };
    const text = JSON.stringify(request);
    if (known === text) return;
    flying?.abort();
    const mine = (flying = new AbortController());
    known = text;
    figure.classList.add("asking");
    try {
      const answer = await ask("tolerance", request, { signal: mine.signal });
      complain("");
      offer(answer);
      if (!answer.table) return void follow(); // now it is known what may scatter
      setHtml(table, answer.table);
      showPictures({ [KEY]: answer.picture });
    } catch (problem) {
      if (problem.name === "AbortError") return;
      known = "";
      complain(problemOf(problem));
      stalePictures([KEY]);
    } finally {
      if (flying === mine) figure.classList.remove("asking");
    }
  }

  function later() {
    clearTimeout(timer);
    timer = setTimeout(follow, REST);
  }

  function complain(text) {
    error.hidden = !text;
    error.textContent = text;
  }

  function offer(answer) {
    fields = new Map(answer.fields.map((one) => [one.name, one]));
    sizes ??= new Map(answer.fields.slice(0, FIRST).map((one) => [one.name, begins(one)]));
    for (const [name, size] of sizes) if (size > (fields.get(name)?.most ?? size)) sizes.set(name, begins(fields.get(name)));
    const chosen = [...sizes.keys()].filter((name) => fields.has(name));
    if (chosen.join() !== rows.dataset.names) showRows(chosen);
    choices(more, answer.fields.filter((one) => !sizes.has(one.name)));
    choices(output, answer.outputs);
    add.disabled = !more.options.length || sizes.size >= MOST;
    if (!chosen.length) complain(say("tolerance.none"));
  }

  const begins = (field) => field.factor * rounded((USUAL * field.most) / field.factor, (0.01 * field.most) / field.factor);

  function showRows(names) {
    rows.dataset.names = names.join();
    rows.replaceChildren(...names.map((name) => rowOf(fields.get(name))));
  }

  function rowOf({ name, label, unit }) {
    const slider = make("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": say("form.slider", { label }) });
    const number = make("input", { type: "text", inputMode: "decimal", autocomplete: "off", id: `scatter-${name}` });
    const show = (moves = false) => {
      const { most, factor } = fields.get(name);
      const text = shown(sizes.get(name) / factor, 4);
      number.value = text;
      number.setAttribute("aria-invalid", "false");
      if (!moves) slider.value = Math.round((STEPS * sizes.get(name)) / most);
      slider.setAttribute("aria-valuetext", `± ${text} ${unit}`);
    };
    slider.oninput = () => {
      const { most, factor } = fields.get(name);
      sizes.set(name, factor * rounded(((slider.value / STEPS) * most) / factor, most / factor / STEPS));
      show(true);
      later();
    };
    number.onchange = () => {
      const { most, factor } = fields.get(name);
      const size = factor * Number(typed(number.value).number ?? NaN);
      if (!(size >= 0 && size <= most * (1 + 1e-9))) {
        number.setAttribute("aria-invalid", "true");
        complain(say("tolerance.most", { most: `${shown(most / factor, 4)} ${unit}`.trim() }));
        return;
      }
      complain("");
      sizes.set(name, size);
      show();
      later();
    };
    const drop = make("button", {
      type: "button", className: "close", textContent: "×", "aria-label": say("form.remove", { label }),
      onclick: () => {
        sizes.delete(name);
        rows.dataset.names = "";
        known = "";
        follow();
      },
    });
    show();
    return make("div", { className: "row" }, make("label", { for: number.id }, ...indexed(label)), slider,
      make("span", { className: "sign", textContent: "±", "aria-hidden": "true" }), number, make("span", { className: "unit", textContent: unit }), drop);
  }

  add.onclick = () => {
    const field = fields.get(more.value);
    if (!field) return;
    sizes.set(field.name, begins(field));
    known = "";
    follow();
  };
  output.onchange = follow;
  figure.addEventListener("toggle", follow);
  return () => {
    stalePictures([KEY]);
    later();
  };
}
