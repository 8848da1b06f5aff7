// Opening a case: by its designation, from a file, as an example.

import { Refused, Silent, ask, make, say } from "./ask.js";
import { shown } from "./units.js";

const MOST_BYTES = 500_000;
const PAUSE = 150;

/**
 * The panel from which a case is opened.
 * @param {object} of  `panel`, `button`: elements; `open(request)`; `mayClose()`
 */
export function makeOpening({ panel, button, open, mayClose }) {
  const [wanted, found, count, wrong, file] = ["wanted", "found", "found-count", "wanted-error", "file"]
    .map((id) => document.getElementById(id));
  let timer = 0;
  let latest = 0;

  function show(isOpen) {
    panel.hidden = !isOpen;
    button.setAttribute("aria-expanded", String(isOpen));
    if (isOpen) {
      wrong.textContent = "";
      wanted.focus();
    }
  }

  async function opened(request) {
    try {
      await open(request);
      wanted.value = file.value = "";
      found.replaceChildren();
      count.textContent = "";
      document.getElementById("content").focus({ preventScroll: true });
      scrollTo(0, 0);
    } catch (error) {
      if (!(error instanceof Refused || error instanceof Silent)) throw error;
      wrong.textContent = error instanceof Silent ? say("server.silent") : error.message;
      show(true);
      wrong.textContent = error instanceof Silent ? say("server.silent") : error.message;
    }
  }

  const entry = (title, text, request) => make("li", {}, make("button", {
    type: "button", onclick: () => opened(request),
  }, make("strong", { textContent: title }), text ? ` ${text}` : null));

  async function search() {
    const text = wanted.value.trim();
    const mine = ++latest;
    wrong.textContent = "";
    if (!text) {
      found.replaceChildren();
      count.textContent = "";
      return;
    }
    let answer;
    try {
      answer = await ask("search", { text });
    } catch (error) {
      if (mine === latest) wrong.textContent = error instanceof Silent ? say("server.silent") : error.message;
      return;
    }
    if (mine !== latest) return;
    const { bearings, more } = answer;
    count.textContent = say(more ? "open.many" : "open.found", { n: bearings.length });
    found.replaceChildren(...bearings.map((one) => entry(one.designation, sizes(one), { designation: one.designation })));
  }

  async function read(one) {
    if (!one) return;
    if (one.size > MOST_BYTES) {
      wrong.textContent = say("open.large");
      return;
    }
    const format = /\.json$/i.test(one.name) ? "json" : /\.toml$/i.test(one.name) ? "toml" : undefined;
    await opened({ text: await one.text(), format, name: one.name });
  }

  function arrange(examples) {
    const list = examples.map((one) => entry(one.name, one.title, { example: one.name }));
    document.getElementById("examples").replaceChildren(...list);
    search();
  }

  button.onclick = () => show(panel.hidden || !mayClose());
  document.getElementById("finder").onsubmit = (event) => {
    event.preventDefault();
    if (wanted.value.trim()) opened({ designation: wanted.value.trim() });
  };
  wanted.oninput = () => {
    clearTimeout(timer);
    timer = setTimeout(search, PAUSE);
  };
  file.onchange = () => read(file.files[0]);
  panel.onkeydown = (event) => {
    if (event.key !== "Escape" || !mayClose()) return;
    show(false);
    button.focus();
  };
  const view = document.getElementById("case");
  view.addEventListener("dragover", (event) => event.preventDefault());
  view.addEventListener("drop", (event) => {
    event.preventDefault();
    read(event.dataTransfer.files[0]);
  });
  return { show, arrange };
}

function sizes({ kind, bore, outside_diameter: outside, width, dynamic_rating: rating }) {
  const lengths = [bore, outside, width].filter(Boolean).map((one) => shown(one * 1e3, 6)).join(" × ");
  const parts = [kind, lengths && `${lengths} mm`, rating && `C ${shown(rating / 1e3, 4)} kN`];
  return parts.filter(Boolean).join(", ");
}
