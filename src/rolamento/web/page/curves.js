// The curve: any output of the present cases over any of their fields, with the case itself on it.

import { make } from "./ask.js";
import { newFigure, separate, showPictures, stalePictures } from "./pictures.js";

const KEY = "curve";
const REST = 350; // ms without a change, after which the curve follows the case

let own = null;
let timer = 0;

/** Make the curve in `root`; `cases()` gives the cases as they are now, in file form. */
export function startCurves(root, { words, lang, say, ask, cases }) {
  const pick = (name) => make("select", { name });
  const [field, output] = [pick("field"), pick("output")];
  const [low, high] = ["low", "high"].map((name) => make("input", { type: "text", name, autocomplete: "off", spellcheck: false }));
  const [scale, upright] = ["scale", "upright"].map((name) => make("input", { type: "checkbox", name }));
  const error = make("p", { className: "error", role: "alert", hidden: true });
  const labelled = (word, control) => make("label", {}, make("span", { textContent: say(word) }), control);
  const ticked = (word, control) => make("label", { className: "check" }, control, make("span", { textContent: say(word) }));
  const tools = make("div", { className: "tools" }, labelled("curve.output", output), labelled("curve.field", field),
    labelled("curve.low", low), labelled("curve.high", high), ticked("curve.scale", scale), ticked("curve.upright", upright), error);
  root.classList.add("curves");
  root.append(newFigure(KEY, say("curve"), false, [tools]));
  separate(KEY, follow);

  let flying = null;
  let ranged = false; // whether the reader chose the ends of the range

  async function follow() {
    if (!cases().length) return;
    flying?.abort();
    const mine = (flying = new AbortController());
    const request = {
      cases: cases().map((one) => ({ case: one })), field: field.value, output: output.value,
      scale: scale.checked ? "log" : "linear", upright: upright.checked ? "log" : "linear",
      ...(ranged ? { low: low.value, high: high.value } : {}),
    };
    try {
      const answer = await ask("curve", request, { signal: mine.signal });
      choices(field, answer.fields, answer.field);
      choices(output, answer.outputs, answer.output);
      [low.value, high.value] = [answer.low, answer.high].map(String);
      complain("");
      showPictures({ [KEY]: answer });
    } catch (problem) {
      if (problem.name === "AbortError") return;
      const at = problem.error?.field;
      if (request.field && (at === "outputs" || at === "field")) {
        [field, output].forEach((one) => one.replaceChildren()); // another bearing: what it has to offer
        return void follow();
      }
      complain(problem.message || say("server.silent"), at === "low" ? low : at === "high" ? high : null);
      stalePictures([KEY]);
    }
  }

  function complain(text, control = null) {
    error.hidden = !text;
    error.textContent = text;
    for (const one of [low, high]) one.setAttribute("aria-invalid", String(one === control));
  }

  const choices = (select, offered, chosen) => {
    const known = JSON.stringify(offered);
    if (select.dataset.known !== known || !select.options.length) {
      select.dataset.known = known;
      select.replaceChildren(...offered.map(({ name, label }) => make("option", { value: name, textContent: label.replaceAll("_", "") })));
    }
    select.value = chosen;
  };

  for (const one of [output, scale, upright]) one.onchange = follow;
  field.onchange = () => {
    ranged = false;
    follow();
  };
  for (const one of [low, high]) one.onchange = () => {
    ranged = Boolean(low.value || high.value);
    follow();
  };
  own = { follow, open: () => root.querySelector("details").open };
}

/** The cases have changed: the curve is not theirs any more, and follows when they rest. */
export function curvesStale() {
  if (!own) return;
  stalePictures([KEY]);
  clearTimeout(timer);
  timer = setTimeout(() => own.open() && own.follow(), REST);
}
