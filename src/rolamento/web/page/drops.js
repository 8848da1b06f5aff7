// The pages of files: a vibration record, a life test, a planned test. What is asked for beside a
// file comes described from the server (tasks/asked.py); what is found is shown as the server set it.

import { download, make, Refused, setHtml, Silent } from "./ask.js";
import { inMark } from "./units.js";

const METHODS = { signal: ["PUT", "/page/signal"], weibull: ["PUT", "/page/weibull"], plan: ["POST", "/page/weibull/plan"] };
const LABELS = { html: "HTML", pdf: "PDF", md: "Markdown", txt: "TXT", csv: "CSV", xlsx: "XLSX", json: "JSON" };
const NUMBERS = ["fraction", "number", "numbers", "list"]; // kinds of fields
const MOST_SHOWN = 200_000; // bytes of a table that is shown where it can be edited

const written = ({ kind }, text) => (NUMBERS.includes(kind) ? inMark(text) : text);

/** Make the page of one kind ("signal" or "weibull") inside root. */
export function startDrops(root, kind, described, tools) {
  root.append(new Drop(kind, described, tools).element);
  if (kind === "weibull") root.append(new Drop("plan", described, tools).element);
}

/** Have a report made, of `{cases}` or by `path` of `{machine}`, and save it. Rejects with the error object. */
export async function saveReport(of, format, { lang, path = "report" }) {
  const body = JSON.stringify({ ...of, format });
  keep(await send("POST", `/page/${path}?lang=${lang}`, body, { "Content-Type": "application/json" }));
}

class Drop {
  constructor(kind, described, { lang, currentCase }) {
    Object.assign(this, { kind, described, lang, currentCase, file: null, name: "", sending: null });
    this.words = described.words;
    this.fields = new Map();
    this.element = make("section", { className: `drop panel ${kind}` }, make(kind === "plan" ? "h2" : "h1", {}, this.words[`title_${kind}`]));
    this.form = make("form", { noValidate: true });
    this.form.append(...(kind === "plan" ? [] : this.fileParts()), ...this.optionParts(), this.endParts());
    this.form.addEventListener("submit", (event) => { event.preventDefault(); this.run(); });
    this.form.addEventListener("input", (event) => {
      if (event.target !== this.input) this.touched();
    });
    this.form.addEventListener("focusin", () => this.nameCase());
    this.nameCase();
    this.result = make("div", { className: "drop-result", hidden: true, tabIndex: -1, role: "region",
      "aria-label": this.words.result });
    this.element.append(this.form, this.result);
  }

  /** Show which case on the page is taken where no bearing is named. */
  nameCase() {
    if (this.kind !== "signal") return;
    const { one, control } = this.fields.get("bearing");
    control.placeholder = this.currentCase()?.title || one.example;
  }

  // --- what is asked ---------------------------------------------------------------------------

  fileParts() {
    const { kind, words, described } = this;
    const id = `drop-file-${kind}`;
    this.input = make("input", { type: "file", id, accept: described.endings[kind].join(",") });
    this.input.addEventListener("change", () => this.input.files[0] && this.take(this.input.files[0]));
    this.chosen = make("output", { className: "drop-chosen", for: id });
    this.remove = button(words.remove, () => { this.forget(); this.input.focus(); });
    this.remove.hidden = true;
    const zone = make("div", { className: "drop-zone" },
      make("label", { for: id }, words[`drop_${kind}`]), this.input,
      make("p", { className: "help" }, words[`formats_${kind}`]),
      make("p", {}, this.chosen, " ", this.remove));
    this.fileError = make("p", { className: "error", id: `${id}-error` });
    this.input.setAttribute("aria-describedby", this.fileError.id);
    zone.append(this.fileError);
    for (const type of ["dragenter", "dragover", "dragleave", "drop"]) {
      zone.addEventListener(type, (event) => {
        event.preventDefault();
        zone.classList.toggle("over", type === "dragenter" || type === "dragover");
        if (type === "drop" && event.dataTransfer.files[0]) this.take(event.dataTransfer.files[0]);
      });
    }
    const examples = described.examples[kind].map((one) => button(one.label, () => this.tryOut(one)));
    const parts = [zone, make("div", { className: "tools drop-examples" }, make("span", {}, words.examples), ...examples)];
    if (kind !== "weibull") return parts;
    this.table = make("textarea", { id: "drop-table", rows: 8, spellcheck: false, placeholder: words.paste_example });
    this.table.addEventListener("input", () => { if (this.file) this.forget(true); });
    parts.push(make("div", { className: "field" }, make("label", { for: "drop-table" }, words.paste), this.table));
    return parts;
  }

  optionParts() {
    const groups = this.described[this.kind];
    const seen = groups.flatMap((group) => group.options).filter((one) => one.essential);
    const parts = [make("div", { className: "drop-options" }, ...seen.map((one) => this.field(one)))];
    const more = make("details", { className: "drop-more" }, make("summary", {}, this.words.more));
    for (const group of groups) {
      const rest = group.options.filter((one) => !one.essential);
      if (!rest.length) continue;
      more.append(make("fieldset", {}, make("legend", {}, group.label),
        make("div", { className: "drop-options" }, ...rest.map((one) => this.field(one)))));
    }
    return more.children.length > 1 ? [...parts, more] : parts;
  }

  field(one) {
    const id = `drop-${this.kind}-${one.name}`;
    const error = make("p", { className: "error", id: `${id}-error` });
    const help = make("p", { className: "help", id: `${id}-help` }, one.meaning);
    let control, read, label = make("label", { for: id }, one.label);
    if (one.kind === "choices") {
      const boxes = one.choices.map(({ value, label: text }) => {
        const box = make("input", { type: "checkbox", value });
        return [box, make("label", { className: "drop-box" }, box, " ", text)];
      });
      control = make("div", { id, role: "group", "aria-label": one.label }, ...boxes.map(([, text]) => text));
      label = make("span", { className: "label" }, one.label);
      read = () => boxes.filter(([box]) => box.checked).map(([box]) => box.value);
    } else if (one.kind === "choice") {
      control = make("select", { id }, ...(one.default ? [] : [make("option", { value: "" }, this.words.none)]),
        ...one.choices.map(({ value, label: text }) => make("option", { value, defaultSelected: value === one.default }, text)));
      read = () => [control.value];
    } else if (one.kind === "switch") {
      control = make("input", { id, type: "checkbox", defaultChecked: one.default === "true" });
      read = () => [String(control.checked)];
    } else {
      control = make("input", { id, type: "text", defaultValue: written(one, one.default), autocomplete: "off", spellcheck: false,
        placeholder: written(one, one.example), inputMode: one.kind === "count" ? "numeric" : "text" });
      read = () => [control.value];
    }
    control.setAttribute("aria-describedby", `${help.id} ${error.id}`);
    this.fields.set(one.name, { one, control, error, read });
    return make("div", { className: `field drop-${one.kind}` }, label, control, help, error);
  }

  endParts() {
    this.start = make("button", { type: "submit", className: "button main" }, this.words[`run_${this.kind}`]);
    this.stop = button(this.words.cancel, () => this.sending?.abort());
    this.stop.hidden = true;
    this.bar = make("progress", { hidden: true, max: 1 });
    this.clock = make("span", { className: "drop-clock" });
    this.state = make("span", { className: "drop-state", role: "status" });
    return make("div", { className: "tools drop-end" }, this.start, this.stop, this.bar, this.state, this.clock);
  }

  // --- the file --------------------------------------------------------------------------------

  async take(file) {
    this.forget();
    this.name = file.name;
    const held = new DataTransfer(); // a file that is dropped stands where a chosen one does
    held.items.add(file);
    this.input.files = held.files;
    const text = this.table && file.size <= MOST_SHOWN ? await file.text() : "\0";
    if (/[\0\uFFFD]/.test(text)) this.file = file; // what is not plain text is read by the server
    else this.table.value = text;
    this.chosen.textContent = `${file.name} (${size(file.size, this.lang)})`;
    this.remove.hidden = false;
    this.touched();
  }

  forget(keepTable = false) {
    this.file = null;
    this.name = "";
    this.input.value = "";
    this.chosen.textContent = "";
    this.remove.hidden = true;
    if (this.table && !keepTable) this.table.value = "";
    this.complain({});
  }

  async tryOut(example) {
    await this.during(this.words.working, async () => {
      const { blob, name } = await send("GET", `/page/example/${this.kind}/${example.name}?lang=${this.lang}`, null, {}, this.hooks());
      this.form.reset(); // what was typed for another file
      await this.take(new File([blob], name));
      for (const [key, value] of Object.entries(example.typed)) this.fields.get(key).control.value = value;
    });
    if (this.name) await this.run();
  }

  // --- asking ----------------------------------------------------------------------------------

  address(format = "") {
    const [, path] = METHODS[this.kind];
    const query = new URLSearchParams({ lang: this.lang });
    for (const [name, { one, read }] of this.fields) {
      const usual = written(one, one.default) || (one.kind === "switch" ? "false" : "");
      for (const text of read()) if (text.trim() && text !== usual) query.append(name, text);
    }
    const current = this.kind === "signal" && !query.has("bearing") ? this.currentCase() : null;
    if (current) query.append("case", JSON.stringify(current.case));
    if (format) query.append("format", format);
    return `${path}?${query}`;
  }

  body() {
    if (this.kind === "plan") return null;
    return this.file ?? (this.table && this.table.value.trim() ? new Blob([this.table.value]) : null);
  }

  async request(format) {
    const body = this.body();
    if (this.kind !== "plan" && !body) throw this.wrong(this.table ? "no_table" : "no_file");
    if (body && body.size > this.described.largest[this.kind]) throw this.wrong("too_large");
    const headers = this.name ? { "X-File-Name": encodeURIComponent(this.name) } : {};
    return send(METHODS[this.kind][0], this.address(format), body, headers, this.hooks());
  }

  wrong(word) {
    return new Refused({ field: "file", message: this.words[word], rule: this.words[word] });
  }

  async run() {
    await this.during(this.words[this.file ? "sending" : "working"], async () => {
      const { json } = await this.request("");
      return this.show(json);
    });
  }

  hooks() {
    return {
      begun: (request) => { this.sending = request; },
      sent: (part) => {
        this.bar.value = part;
        if (part >= 1) { this.bar.removeAttribute("value"); this.state.textContent = this.words.working; }
      },
    };
  }

  async during(text, action) {
    if (this.busy) return;
    this.busy = true;
    this.complain({});
    const began = performance.now();
    const ticking = setInterval(() => { this.clock.textContent = `${Math.round((performance.now() - began) / 1000)} s`; }, 1000);
    this.stop.hidden = this.bar.hidden = false;
    this.start.disabled = true;
    this.state.textContent = text;
    try {
      this.state.textContent = (await action()) ?? "";
    } catch (error) {
      this.state.textContent = error.name === "AbortError" ? this.words.cancelled : "";
      if (error instanceof Refused) this.complain(error.error);
      else if (error instanceof Silent) this.complain({ message: this.words.no_answer });
      else if (error.name !== "AbortError") throw error;
    } finally {
      clearInterval(ticking);
      this.busy = false;
      this.sending = null;
      this.clock.textContent = "";
      this.stop.hidden = this.bar.hidden = true;
      this.start.disabled = false;
      this.bar.removeAttribute("value");
    }
  }

  // --- what comes back -------------------------------------------------------------------------

  show({ verdict, html, files }) {
    const page = make("div", { className: "rolamento" });
    setHtml(page, html);
    this.stale = make("p", { className: "banner", hidden: true }, this.words.of_options);
    const saving = files.map((format) => button(LABELS[format], () =>
      this.during(this.words.working, async () => keep(await this.request(format)))));
    this.result.replaceChildren(this.stale, make("div", { className: "tools drop-save" },
      make("span", {}, this.words.save_as), ...saving), page);
    this.result.hidden = false;
    this.result.focus({ preventScroll: true });
    this.result.scrollIntoView({ block: "start" });
    return verdict.text;
  }

  touched() {
    if (this.stale) this.stale.hidden = false;
  }

  complain(error) {
    for (const { control, error: place } of this.fields.values()) {
      place.textContent = "";
      control.removeAttribute("aria-invalid");
    }
    if (this.fileError) this.fileError.textContent = "";
    this.general ??= make("p", { className: "error drop-general", role: "alert" });
    this.general.textContent = "";
    if (!error.message) return;
    const field = this.fields.get(error.field);
    if (field) {
      const example = error.example ? ` (${error.example})` : "";
      field.error.textContent = `${error.rule}${example}`;
      field.control.setAttribute("aria-invalid", "true");
      const more = field.control.closest("details");
      if (more) more.open = true;
      field.control.focus();
    } else if (error.field === "file" && this.fileError) {
      this.fileError.textContent = error.rule;
      this.input.focus();
    } else {
      this.general.textContent = error.message;
      this.form.append(this.general);
    }
  }
}

// --- helpers -----------------------------------------------------------------------------------

function button(text, action) {
  const element = make("button", { type: "button", className: "button" }, text);
  element.addEventListener("click", action);
  return element;
}

function size(bytes, lang) {
  const [worth, unit] = bytes < 1e6 ? [1e3, "kB"] : [1e6, "MB"];
  return `${(bytes / worth).toLocaleString(lang, { maximumSignificantDigits: 3 })} ${unit}`;
}

const keep = ({ blob, name }) => download(blob, name, blob.type);

/** Send with progress and abort, which fetch does not tell. Gives {json} or {blob, name}. */
function send(method, address, body, headers, { begun, sent } = {}) {
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.open(method, address);
    request.responseType = "blob";
    for (const [name, value] of Object.entries(headers)) request.setRequestHeader(name, value);
    request.upload.onprogress = (event) => event.lengthComputable && sent?.(event.loaded / event.total);
    request.upload.onload = () => sent?.(1);
    request.onabort = () => reject(new DOMException("", "AbortError"));
    request.onerror = () => reject(new Silent());
    request.onload = async () => {
      const file = /filename="([^"]+)"/.exec(request.getResponseHeader("Content-Disposition") ?? "");
      if (request.status === 200 && file) return resolve({ blob: request.response, name: file[1] });
      const json = await request.response.text().then(JSON.parse).catch(() => null);
      if (request.status === 200 && json) resolve({ json });
      else reject(new Refused(json?.error ?? { message: `${request.status}` }, request.status));
    };
    begun?.(request);
    request.send(body);
  });
}
