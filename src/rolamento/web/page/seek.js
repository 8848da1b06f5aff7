// A design question: which value of an input gives a result the value that it should have.

import { Refused, ask, make, say } from "./ask.js";
import { newFigure, separate, showPictures, stalePictures } from "./pictures.js";
import { typed } from "./units.js";

const KEY = "seek";

/** Offer what may be chosen, what is asked for most first; what was chosen stays. */
export function choices(select, all) {
  const chosen = select.value;
  const option = ({ name, label }) => make("option", { value: name, textContent: label.replaceAll("_", "") }); // no letters are lowered there
  const group = (word, ones) => (ones.length ? make("optgroup", { label: say(word) }, ...ones.map(option)) : null);
  select.replaceChildren(...[group("seek.usual", all.filter((one) => one.usual)), group("seek.others", all.filter((one) => !one.usual))].filter(Boolean));
  if (all.some((one) => one.name === chosen)) select.value = chosen;
}

/** The message of a problem with a question: the rule alone where there is one. */
export const problemOf = (problem) => (problem instanceof Refused ? (problem.error.rule ?? problem.message) : say("server.silent"));

/** A control with its word above it. */
export const labelled = (word, ...controls) => make("label", {}, make("span", { textContent: say(word) }), ...controls);

/** Make it in `root`; `current()` is the edited slot, `use(field, value)` puts a value into it. */
export function startSeek(root, { current, use }) {
  const [field, output] = ["vary", "output"].map((name) => make("select", { name }));
  const wanted = make("input", { type: "text", name: "wanted", autocomplete: "off", spellcheck: false });
  const unit = make("span", { className: "unit" });
  const go = make("button", { type: "submit", className: "button main", textContent: say("seek.go") });
  const error = make("p", { className: "error", role: "alert", hidden: true });
  const statement = make("p", { className: "statement", role: "status" });
  const found = make("div", { className: "tools" });
  const form = make("form", { className: "tools", noValidate: true }, labelled("seek.vary", field), labelled("seek.output", output),
    labelled("seek.wanted", make("span", { className: "row" }, wanted, unit)), go, error);
  root.className = "seek";
  root.replaceChildren(newFigure(KEY, say("seek"), false, [make("p", { className: "help", textContent: say("seek.help") }), form, statement, found]));
  separate(KEY, offer);
  const figure = root.querySelector("details");
  const plot = root.querySelector("figure");
  plot.hidden = true;
  figure.querySelector(".does").hidden = true;
  let known = null;
  let units = new Map();

  async function offer() {
    const slot = current();
    if (!slot || !figure.open) return;
    const text = JSON.stringify(slot.case);
    if (known === text) return;
    known = text;
    try {
      fill(await ask("seek", { case: slot.case }));
    } catch (problem) {
      complain(problem);
    }
  }

  function fill({ fields, outputs }) {
    units = new Map(outputs.map((one) => [one.name, one.unit]));
    choices(field, fields);
    choices(output, outputs);
    unit.textContent = units.get(output.value) ?? "";
  }

  function complain(problem) {
    error.hidden = !problem;
    error.textContent = problem ? problemOf(problem) : "";
  }

  output.onchange = () => {
    unit.textContent = units.get(output.value) ?? "";
    wanted.value = "";
  };
  figure.addEventListener("toggle", offer);
  form.onsubmit = async (event) => {
    event.preventDefault();
    if (!wanted.value.trim()) {
      wanted.focus();
      return;
    }
    const read = typed(wanted.value);
    const value = read.number !== undefined && !read.unit ? `${read.number} ${unit.textContent}`.trim() : read.text;
    go.disabled = true;
    statement.textContent = say("seek.looking");
    complain(null);
    found.replaceChildren();
    try {
      const answer = await ask("seek", { case: current().case, vary: field.value, output: output.value, wanted: value });
      statement.textContent = answer.statement;
      found.replaceChildren(...answer.found.map((one) => make("button", {
        type: "button", className: "button", textContent: say("seek.use", { value: one.text }), onclick: () => use(answer.field, one.value),
      })));
      plot.hidden = false;
      figure.querySelector(".does").hidden = false;
      showPictures({ [KEY]: answer.picture });
    } catch (problem) {
      statement.textContent = "";
      complain(problem);
      stalePictures([KEY]);
    } finally {
      go.disabled = false;
    }
  };
}
