// Talking to the server of this page, and to the reader in the words that it hands over.

/** An answer that says what is wrong: `error` = {field, message, example …}. */
export class Refused extends Error {
  constructor(error, status) {
    super(error.message);
    this.error = error;
    this.status = status;
  }
}

/** No answer: the server has ended, or cannot be reached. */
export class Silent extends Error {}

let language = "";
let words = {};

/** Speak what `GET /page/start` hands over. */
export function speak(start) {
  language = start.lang;
  words = start.words;
}

/** The word of a key, the places in braces filled in. */
export function say(key, values = {}) {
  const text = words[key] ?? key;
  return text.replace(/\{(\w+)\}/g, (place, name) => values[name] ?? place);
}

/** Ask `/page/<path>`: with a body by POST, else by GET; lang only before words are known. */
export async function ask(path, body, { signal, lang = language } = {}) {
  const json = { method: "POST", headers: { "Content-Type": "application/json" } };
  const request = body === undefined ? {} : { ...json, body: JSON.stringify(body) };
  const query = lang ? `?lang=${encodeURIComponent(lang)}` : "";
  let response, answer;
  try {
    response = await fetch(`/page/${path}${query}`, { ...request, signal, cache: "no-store" });
    answer = await response.json();
  } catch (error) {
    if (error.name === "AbortError") throw error;
    if (!response) throw new Silent();
  }
  if (response.ok && answer) return answer;
  throw new Refused(answer?.error ?? { message: say("server.failed") }, response.status);
}

/** Put words on all that asks for them: text, label, what a picture shows. */
export function fillIn(root) {
  for (const one of root.querySelectorAll("[data-word]")) one.textContent = say(one.dataset.word);
  for (const one of root.querySelectorAll("[data-label]"))
    one.setAttribute("aria-label", say(one.dataset.label));
  for (const one of root.querySelectorAll("[data-alt]")) one.alt = say(one.dataset.alt);
}

/** Show the server's HTML; its styles go through the object model, as the policy asks. */
export function setHtml(element, html) {
  element.innerHTML = html.replaceAll(' style="', ' data-style="');
  for (const one of element.querySelectorAll("[data-style]")) one.style.cssText = one.dataset.style;
  for (const one of element.querySelectorAll("figure")) one.tabIndex = 0; // it may scroll
}

/** Make an element: properties, `on…` listeners, attributes with a dash or role; then children. */
export function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.includes("-") || ["role", "list", "for"].includes(name)) element.setAttribute(name, value);
    else element[name] = value;
  }
  element.append(...children.filter((one) => one != null));
  return element;
}

/** Hand a text or bytes to the reader as a file. */
export function download(content, name, type = "text/plain") {
  const address = URL.createObjectURL(new Blob([content], { type }));
  make("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** What this browser remembers; a browser that forbids it forgets. */
export function remembered(key, otherwise = null) {
  try {
    return JSON.parse(localStorage.getItem(`rolamento.${key}`)) ?? otherwise;
  } catch {
    return otherwise;
  }
}

/** Remember a value; null forgets it. */
export function remember(key, value) {
  try {
    if (value === null) localStorage.removeItem(`rolamento.${key}`);
    else localStorage.setItem(`rolamento.${key}`, JSON.stringify(value));
  } catch {
    // full, or forbidden
  }
}
