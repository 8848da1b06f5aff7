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
  let drawings = null;
  let latestFound = null; // what the last search found, and of which text

  function show(isOpen) {
    panel.hidden = !isOpen;
    button.setAttribute("aria-expanded", String(isOpen));
    const starts = isOpen && !mayClose();
    document.body.classList.toggle("starting", starts);
    document.getElementById("opening-head").setAttribute("aria-level", starts ? 1 : 2);
    if (isOpen) {
      wrong.textContent = "";
      wanted.focus();
      draw();
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

  const entry = (title, text, request, tag = "") => make("li", {}, make("button", {
    type: "button", className: tag ? "best" : "", onclick: () => opened(request),
  }, tag ? make("span", { className: "tag", textContent: tag }) : null, tag ? " " : null,
  make("strong", { textContent: title }), text ? ` ${text}` : null));

  /** An example as a picture with its title. */
  const card = (one) => make("li", {}, make("button", {
    type: "button", className: "card", onclick: () => opened({ example: one.name }),
  }, make("span", { className: "thumb", "data-example": one.name }), make("span", { className: "hidden", textContent: `${one.name}: ` }),
  make("span", { textContent: one.title })));

  /** Fetch the drawings of the examples when they are first seen. */
  async function draw() {
    drawings ??= ask("drawings").catch(() => (drawings = null));
    const known = await drawings;
    if (!known) return;
    for (const place of document.querySelectorAll("#examples .thumb"))
      if (!place.firstChild && known[place.dataset.example]) {
        place.innerHTML = known[place.dataset.example];
        place.firstChild.setAttribute("aria-hidden", "true");
        place.firstChild.removeAttribute("role");
        place.querySelector("title")?.remove();
      }
  }

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
    const { bearings, more, opens, why, near } = answer;
    const plain = (one) => one.replace(/[\s/-]/g, "").toLowerCase();
    const isListed = opens && bearings.some((one) => plain(one.designation) === plain(opens.designation));
    latestFound = { text, opens, bearings };
    count.textContent = opens && !isListed && !bearings.length ? ""
      : bearings.length ? say(more ? "open.many" : "open.found", { n: bearings.length })
        : why ? capital(why) + (near.length ? `. ${say("open.near")}` : "") : say("open.found", { n: 0 });
    found.replaceChildren(
      ...(opens && !isListed ? [entry(opens.designation, [opens.arrangement, sizes(opens)].filter(Boolean).join(", "), { designation: text }, say("open.as"))] : []),
      ...bearings.map((one) => entry(one.designation, sizes(one), { designation: one.designation })),
      ...near.map((one) => entry(one, "", { designation: one })));
  }

  /** Open what was typed; sizes are no designation: the bearing that has them, or a choice. */
  async function submitted(text) {
    if (/^[\d.,]+\s*[x×]\s*[\d.,]+(\s*[x×]\s*[\d.,]+)?$/i.test(text)) {
      if (latestFound?.text !== text) await search();
      const { bearings = [] } = latestFound ?? {};
      if (bearings.length === 1) return opened({ designation: bearings[0].designation });
      if (bearings.length) {
        wrong.textContent = say("open.choose");
        found.querySelector("button")?.focus();
        return undefined;
      }
    }
    return opened({ designation: text });
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
    document.getElementById("examples").replaceChildren(...examples.map(card));
    if (!panel.hidden) draw();
    search();
  }

  button.onclick = () => show(panel.hidden || !mayClose());
  document.getElementById("finder").onsubmit = (event) => {
    event.preventDefault();
    clearTimeout(timer);
    const text = wanted.value.trim();
    if (text) submitted(text);
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

const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

function sizes({ kind, bore, outside_diameter: outside, width, dynamic_rating: rating }) {
  const lengths = [bore, outside, width].filter(Boolean).map((one) => shown(one * 1e3, 6)).join(" × ");
  const parts = [kind, lengths && `${lengths} mm`, rating && `C ${shown(rating / 1e3, 4)} kN`];
  return parts.filter(Boolean).join(", ");
}
