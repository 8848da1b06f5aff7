// The form of a case, made from the description of its fields that the server hands over.

import { make, remember, remembered, say } from "./ask.js";
import { valueAt, withValue } from "./store.js";
import {
  chooseUnit, exampleOf, fromSi, parted, reach, rounded, shown, toSi, typed, unitChosen, unitNamed,
  unitsOf,
} from "./units.js";

const STEPS = 400;
const OPEN_AT_FIRST = ["bearing", "duty", "lubricant", "temperature"];
const FLAT = ["lubricant", "bearing.preload"]; // tables whose fields stand among those of their group
const FIRST_OF_ENTRY = 4;

let serial = 0;

/**
 * Where a control reads and writes: `read()` the raw value, `counted()` {value, text, origin,
 * source} or undefined, `write(value, quick)`, null takes the value away; `pending()` if known:
 * whether a change is not taken yet.
 * @typedef {{read: Function, counted: Function, write: Function}} Place
 */

/** One field: label, control, help, origin, error. */
class Control {
  constructor(field, place, rivals = () => []) {
    Object.assign(this, { field, place, rivals, id: `f${++serial}`, isGiven: false, expanded: false });
    const { label } = field;
    this.help = make("p", { className: "help", id: `${this.id}-help`, hidden: true });
    this.help.textContent = helpOf(field);
    this.origin = make("p", { className: "origin", id: `${this.id}-origin` });
    this.error = make("p", { className: "error", id: `${this.id}-error`, role: "alert" });
    this.what = make("button", {
      type: "button", className: "what", textContent: "?", "aria-expanded": "false",
      "aria-controls": this.help.id, "aria-label": say("form.about", { label }),
      hidden: !this.help.textContent,
      onclick: () => {
        this.help.hidden = !this.help.hidden;
        this.what.setAttribute("aria-expanded", String(!this.help.hidden));
      },
    });
    this.clear = make("button", {
      type: "button", className: "clear", textContent: "×", hidden: true,
      "aria-label": say("form.clear", { label }), title: say("form.clear", { label }),
      onclick: () => this.commit(null),
    });
    this.control = this.makeControl();
    this.control.id = this.id;
    this.control.setAttribute("aria-describedby",
      `${this.help.id} ${this.origin.id} ${this.error.id}`);
    const row = make("div", { className: "row" }, this.slider, this.control, this.units, this.clear);
    const head = make("div", { className: "line" },
      make("label", { for: this.id }, ...indexed(label)), this.what);
    this.instead = make("button", {
      type: "button", className: "instead", hidden: true,
      onclick: () => {
        this.expanded = true;
        this.show();
        this.control.focus();
      },
    });
    this.instead.append(...indexed(say("form.instead", { label })));
    this.body = make("div", {}, head, row, this.origin, this.help);
    this.element = make("div", { className: `field ${field.kind}` }, this.body, this.instead, this.error);
    this.element.dataset.name = field.name;
  }

  makeControl() {
    return textInput(this, this.field.suggestions);
  }

  /** Ask for a value. */
  commit(value, quick = false) {
    if (value === null) this.expanded = false;
    this.fail(null);
    this.place.write(value, quick);
    if (!quick) this.show();
  }

  /** What was typed, as a case takes it; undefined where it was refused here. */
  understood(text) {
    return text.trim();
  }

  typedIn(text) {
    this.control.dataset.put = this.control.value; // no longer being typed
    if (!text.trim()) {
      this.commit(null);
      return;
    }
    const value = this.understood(text);
    if (value !== undefined) this.commit(value);
  }

  /** Show what the case says now; what is being typed stays. */
  show() {
    const raw = this.place.read();
    const counted = raw === null ? undefined : this.place.counted();
    const own = raw !== undefined && raw !== null && typeof raw !== "object";
    this.isGiven = own || counted?.origin === "given";
    this.hasValue = own || counted !== undefined;
    this.clear.hidden = !(raw !== undefined && raw !== null);
    if (this.isGiven) this.gone = "";
    this.origin.textContent = this.gone || (this.isGiven || !counted ? "" : originOf(counted));
    this.origin.classList.toggle("gone", Boolean(this.gone));
    const replaced = !this.hasValue && !this.expanded && this.rivals().some((one) => one.hasValue);
    this.body.hidden = replaced;
    this.instead.hidden = !replaced;
    this.element.classList.toggle("given", this.isGiven);
    this.showValue(own ? raw : undefined, counted);
  }

  showValue(raw, counted) {
    const text = counted === undefined ? "" : String(counted.text);
    put(this.control, raw !== undefined ? String(raw) : this.isGiven ? text : "");
    this.control.placeholder = text;
  }

  /** Say that it gave way to another field, until it says something again. */
  give(label) {
    this.gone = say("form.gave", { label });
    this.show();
  }

  /** Show what is wrong with it; null: nothing. */
  fail(error) {
    this.control.setAttribute("aria-invalid", String(Boolean(error)));
    const example = String(error?.example ?? "").replace(/^[\w.]+ *= */, "").replace(/^"|"$/g, "");
    this.error.replaceChildren(...(error ? [error.rule ?? error.message] : []));
    if (!error) return;
    this.body.hidden = false;
    if (!example || /[={[]/.test(example) || !("value" in this.control)) return;
    this.error.append(" ", make("button", {
      type: "button", className: "instead", textContent: say("form.use", { example: this.field.choices.find(({ value }) => value === example)?.label ?? example }),
      onclick: () => {
        this.control.value = example;
        this.typedIn(example);
      },
    }));
  }
}

/** A quantity or a ratio, with its unit and a slider. */
class NumberControl extends Control {
  makeControl() {
    const { field } = this;
    const choices = unitsOf(field.dimension);
    if (choices.length > 1) {
      this.units = make("select", {
        className: "unit", "aria-label": say("form.unit", { label: field.label }),
        onchange: () => {
          chooseUnit(field, this.units.value);
          this.element.dispatchEvent(new CustomEvent("units", { bubbles: true }));
        },
      }, ...choices.map((one) => make("option", { value: one.unit, textContent: one.label })));
    } else {
      this.units = make("span", { className: "unit", textContent: choices[0]?.label ?? "" });
    }
    this.slider = make("input", {
      type: "range", min: 0, max: STEPS, step: 1,
      "aria-label": say("form.slider", { label: field.label }),
      oninput: () => this.slid(),
      onchange: () => this.arrange(true),
    });
    return textInput(this, [], "decimal");
  }

  /** Up to where a value is likely, as the server says of the case. */
  likely() {
    return this.place.likely?.();
  }

  get unit() {
    const { dimension, unit } = this.field;
    return unitChosen(this.field) ?? this.ownUnit ?? unitNamed(dimension, unit) ?? unitsOf(dimension)[0]
      ?? { unit: "", label: "", factor: 1, offset: 0 };
  }

  understood(text) {
    const found = typed(text);
    if (found.doubt) {
      this.fail({ rule: say("number.doubt", found.doubt), example: found.doubt.whole });
      return undefined;
    }
    if (found.number === undefined) return found.text;
    if (!this.field.dimension) return found.unit ? found.text : Number(found.number);
    return found.unit ? found.text : `${found.number} ${this.unit.unit}`;
  }

  showValue(raw, counted) {
    const { dimension } = this.field;
    const found = raw === undefined ? null : parted(raw);
    const own = found && (dimension ? unitNamed(dimension, found.unit) : { factor: 1, offset: 0 });
    this.ownUnit = dimension && own ? own : null;
    this.si = own ? toSi(found.number, own) : counted?.value;
    const { unit } = this;
    if (this.units.tagName === "SELECT") this.units.value = unit.unit;
    const text = Number.isFinite(this.si)
      ? shown(own && own.unit === unit.unit ? found.number : fromSi(this.si, unit), own ? 12 : 7) : "";
    const isOdd = raw !== undefined && !own && (!text || this.place.pending?.()); // wrong, or not answered yet
    put(this.control, isOdd ? String(raw) : this.isGiven ? text : "");
    this.control.placeholder = text;
    this.arrange();
  }

  /** Put the slider where the value is; its range stays while the value is within. */
  arrange(atEnds = false) {
    const { field, slider } = this;
    const bound = field.limits.at_least ?? 0;
    const start = ["force", "moment", "angular_speed", "time"].includes(field.dimension) && bound <= 0;
    const value = this.si ?? (start ? 0 : exampleOf(field));
    slider.hidden = !Number.isFinite(value) || (!field.first && this.si === undefined);
    if (slider.hidden) return;
    const range = this.range;
    const inside = range && value >= range.low && value <= range.high;
    const end = atEnds && (value >= range?.high * 0.999 || value <= range?.low);
    const { most = 0 } = this.likely() ?? {};
    if (!inside || end || this.most !== most) this.range = reach(field, value, most);
    this.most = most;
    const place = placeOf(value, this.range);
    if (document.activeElement !== slider || end) slider.value = place;
    slider.classList.toggle("unsaid", this.si === undefined);
    slider.setAttribute("aria-valuetext", `${shown(fromSi(value, this.unit), 4)} ${this.unit.label}`);
  }

  slid() {
    const { range, unit } = this;
    const part = this.slider.value / STEPS;
    const si = valueOf(part, range);
    const near = valueOf(part < 1 ? part + 1 / STEPS : part - 1 / STEPS, range);
    const step = Math.abs(near - si);
    const number = rounded(fromSi(si, unit), step / unit.factor);
    this.control.value = shown(number);
    this.slider.setAttribute("aria-valuetext", `${shown(number, 4)} ${unit.label}`);
    this.commit(this.field.dimension ? `${number} ${unit.unit}` : number, true);
  }
}

class CountControl extends Control {
  makeControl() {
    return textInput(this, [], "numeric");
  }

  understood(text) {
    return /^\d{1,9}$/.test(text.trim()) ? Number(text) : text.trim();
  }
}

/** One of several words. */
class ChoiceControl extends Control {
  makeControl() {
    this.unsaid = make("option", { value: "" });
    const choices = this.field.choices.map(({ value, label }) => make("option", { value, textContent: label }));
    return make("select", {
      onchange: () => this.commit(this.control.value || null),
    }, this.unsaid, ...choices);
  }

  showValue(raw, counted) {
    const chosen = this.field.choices.find(({ value }) => value === counted?.text);
    const unsaid = counted && !this.isGiven ? chosen?.label ?? counted.text : "";
    this.unsaid.textContent = unsaid ? say("form.unsaid", { value: unsaid }) : "–";
    this.control.value = raw ?? (this.isGiven ? (counted?.text ?? "") : "");
  }
}

class SwitchControl extends Control {
  makeControl() {
    return make("input", { type: "checkbox", onchange: () => this.commit(this.control.checked) });
  }

  showValue(raw, counted) {
    this.control.checked = Boolean(raw ?? counted?.value);
  }
}

/** A list of quantities or words, parted by semicolons. */
class ListControl extends Control {
  understood(text) {
    return text.split(";").map((one) => typed(one).text).filter(Boolean);
  }

  showValue() {
    const raw = this.place.read();
    this.isGiven = Array.isArray(raw);
    put(this.control, this.isGiven ? raw.join("; ") : "");
    this.control.placeholder = "";
  }
}

/** A list of tables: the rows of a set, the points of a viscosity. */
class TablesControl extends Control {
  makeControl() {
    this.entries = [];
    return make("div", { className: "entries", role: "group", "aria-label": this.field.label });
  }

  get list() {
    const raw = this.place.read();
    return Array.isArray(raw) ? raw : [];
  }

  showValue() {
    const { list, control, place } = this;
    if (control.childElementCount !== list.length + 1) {
      this.entries = list.map((_, at) => this.makeEntry(at));
      control.replaceChildren(...this.entries.map((one) => one.element), make("button", {
        type: "button", className: "button", textContent: say("form.add", { label: this.field.label }),
        onclick: () => this.commit([...this.list, { ...this.list.at(-1) }]),
      }));
    }
    for (const entry of this.entries) for (const one of entry.controls) one.show();
    this.isGiven = Array.isArray(place.read());
  }

  makeEntry(at) {
    const { field, place } = this;
    const controls = field.entries.map((own) => makeControl(own, {
      read: () => valueAt(this.list[at] ?? {}, own.name),
      counted: () => place.counted(`.${at}.${own.name}`),
      write: (value, quick) => {
        const list = this.list.map((entry, n) => (n === at ? withValue(entry, own.name, value) : entry));
        place.write(list, quick);
      },
    }));
    const given = this.list[at];
    const ahead = controls.filter(({ field: own }, n) =>
      n < FIRST_OF_ENTRY || valueAt(given, own.name) !== undefined);
    const label = `${field.label} ${at + 1}`;
    const remove = make("button", {
      type: "button", className: "button", textContent: say("form.remove", { label }),
      onclick: () => {
        const rest = this.list.filter((_, n) => n !== at);
        this.commit(rest.length ? rest : null);
      },
    });
    const element = make("fieldset", {}, make("legend", { textContent: label }),
      ...ahead.map((one) => one.element), more(controls.filter((one) => !ahead.includes(one))), remove);
    return { element, controls };
  }
}

function makeControl(field, place, rivals) {
  const kinds = { number: NumberControl, count: CountControl, switch: SwitchControl };
  const Kind = field.kind === "list" ? (field.entries.length ? TablesControl : ListControl)
    : field.choices.length && !field.suggestions.length ? ChoiceControl : (kinds[field.kind] ?? Control);
  return new Kind(field, place, rivals);
}

/**
 * Make the form of the edited case.
 * @param {HTMLElement} root
 * @param {object} start   what `GET /page/start` hands over
 * @param {import("./store.js").Store} store
 * @param {(name: string, value: any, quick: boolean) => void} changed
 */
export function makeForm(root, start, store, changed) {
  const controls = new Map();
  const gaveWay = new Map(); // by field: the label of the one that took its place
  const fields = start.form.groups.flatMap((group) => group.fields);
  const byName = new Map(fields.map((one) => [one.name, one]));

  function placeOfField({ name }) {
    return {
      read: () => {
        const slot = store.current;
        return name in slot.changes ? slot.changes[name] : valueAt(slot.case, name);
      },
      pending: () => name in store.current.changes,
      likely: () => store.current.likely?.[name],
      counted: (inner = "") => store.current.inputs[`${name}${inner}`],
      write: (value, quick) => {
        const given = value === null ? [] : (byName.get(name)?.replaces ?? []).map((rival) => controls.get(rival))
          .filter((other) => other?.isGiven);
        changed(name, value, quick);
        for (const other of given) gaveWay.set(other.field.name, byName.get(name).label);
      },
    };
  }

  /** Tell of fields that another one took the place of, once the answer says so. */
  function tellOfThose() {
    for (const [name, label] of gaveWay) {
      const control = controls.get(name);
      if (control && !control.isGiven) control.give(label);
      if (!control || !control.isGiven) gaveWay.delete(name);
    }
  }

  /** A table that is also given by a word needs no field for the word where its own say it. */
  const isSaidByOthers = (one) => one.kind === "text" && !one.suggestions.length && !one.choices.length
    && fields.some((other) => other.name.startsWith(`${one.name}.`));

  function makeGroup(group) {
    const own = group.fields.filter((one) => !isSaidByOthers(one)).map((field) => {
      const rivals = () => field.replaces.map((name) => controls.get(name))
        .filter((other) => other?.field.replaces.includes(field.name));
      const control = makeControl(field, placeOfField(field), rivals);
      controls.set(field.name, control);
      return control;
    });
    for (const one of own) one.show();
    const ahead = own.filter((one) => one.field.first || one.isGiven || one.field.name === "title");
    const rest = own.filter((one) => !ahead.includes(one));
    const tables = { "": [] };
    for (const one of rest) (tables[tableOf(one.field.name)] ??= []).push(one);
    const { "": loose, ...tabled } = tables;
    const inner = Object.entries(tabled).map(([name, ones]) => more(ones, byName.get(name).label));
    const details = make("details", {
      className: "group", open: remembered(`group.${group.key}`, OPEN_AT_FIRST.includes(group.key)),
      ontoggle: () => root.classList.contains("filtering") || remember(`group.${group.key}`, details.open),
    }, make("summary", {}, make("h3", { textContent: group.label })),
    ...ahead.map((one) => one.element), more(loose, "", inner));
    return details;
  }

  /** The table of a field that is folded up as one, such as a material. */
  function tableOf(name) {
    for (let at = name.lastIndexOf("."); at > 0; at = name.lastIndexOf(".", at - 1)) {
      const table = name.slice(0, at);
      if (byName.has(table) && !FLAT.includes(table)) return table;
    }
    return "";
  }

  function rebuild() {
    controls.clear();
    root.replaceChildren(...start.form.groups.map(makeGroup));
    show();
  }

  /** Show what the case says: of all fields, or of some and those that they replace. */
  function show(names) {
    const all = names?.flatMap((name) => [name, ...(byName.get(name)?.replaces ?? [])]) ?? [...controls.keys()];
    for (const one of all.map((name) => controls.get(name)).filter(Boolean)) {
      one.element.classList.toggle("unsuited", !suits(one.field, store.current));
      one.show();
    }
    tellOfThose();
    fail(store.current.error);
  }

  /** Show an error beside its field; false where no field here is meant. */
  function fail(error) {
    for (const one of controls.values()) one.fail(null);
    if (!error?.field) return false;
    let name = error.field;
    while (!controls.has(name) && name.includes(".")) name = name.slice(0, name.lastIndexOf("."));
    const inside = [...controls.values()].filter((one) => one.field.name.startsWith(`${name}.`));
    const own = controls.get(name) ?? inside.find((one) => one.field.name in store.current.changes) ?? inside[0];
    if (!own || own.element.matches(".unsuited")) return false;
    own.fail(error.field === own.field.name ? error : { ...error, example: "" });
    for (let at = own.element; at !== root; at = at.parentElement) if (at.tagName === "DETAILS") at.open = true;
    return true;
  }

  /** Show only fields whose label or name holds a text. */
  function filter(text) {
    const wanted = folded(text.trim());
    root.classList.toggle("filtering", Boolean(wanted));
    for (const one of controls.values()) {
      const { label, name } = one.field;
      one.element.classList.toggle("passed-over", Boolean(wanted) && !folded(`${label} ${name}`).includes(wanted));
    }
    for (const details of root.querySelectorAll("details")) {
      if (wanted && details.dataset.was === undefined) details.dataset.was = details.open ? "open" : "";
      const found = details.querySelector(".field:not(.passed-over)");
      details.classList.toggle("passed-over", Boolean(wanted) && !found);
      details.open = wanted ? Boolean(found) : (details.dataset.was ?? (details.open ? "open" : "")) === "open";
      if (!wanted) delete details.dataset.was;
    }
  }

  root.onsubmit = (event) => event.preventDefault();
  root.addEventListener("units", () => show());
  return { rebuild, show, filter };
}

// --- pieces ------------------------------------------------------------------------------------

function more(controls, label = "", inner = []) {
  if (!controls.length && !inner.length) return null;
  return make("details", { className: "more" },
    make("summary", { textContent: label || say("form.more") }),
    ...controls.map((one) => one.element), ...inner);
}

function textInput(control, suggestions, inputMode = "text") {
  const input = make("input", {
    type: "text", inputMode, autocomplete: "off", spellcheck: false, maxLength: 200,
    onchange: () => control.typedIn(input.value),
  });
  if (suggestions.length) {
    const id = `${control.id}-known`;
    input.setAttribute("list", id);
    control.units = make("datalist", { id }, ...suggestions.map((value) => make("option", { value })));
  }
  return input;
}

/** Put a text into a control unless somebody is typing there. */
export function put(input, text) {
  if (document.activeElement === input && input.value !== input.dataset.put) return;
  if (input.value !== text) input.value = text;
  input.dataset.put = text;
}

/** A text with its symbols' indices set low: e_C. */
export const indexed = (text) => text.split(/(?<=\p{L})_(\w+)/u)
  .map((part, n) => (n % 2 ? make("sub", { textContent: part }) : part));

const placeOf = (value, { low, high, log, power = 1 }) => {
  if (log) return Math.round((STEPS * Math.log(value / low)) / Math.log(high / low));
  const part = (value - low) / (high - low);
  return Math.round(STEPS * (low < 0 && power > 1 ? 1 - (1 - part) ** (1 / power) : part ** (1 / power)));
};

/** The value at a part of a slider's way. */
const valueOf = (part, { low, high, log, power = 1 }) => {
  if (log) return low * (high / low) ** part;
  return low + (high - low) * (low < 0 && power > 1 ? 1 - (1 - part) ** power : part ** power);
};

const folded = (text) => text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();

/** Whether several rows stand on one shaft. */
export function isSet({ case: { bearing }, inputs }) {
  return Boolean(bearing?.arrangement || inputs["bearing.arrangement"] || bearing?.rows?.length > 1);
}

/** What rolls in a case: "ball", "roller" or both. */
export const kindsOf = ({ elements }) => elements.map((one) => (one === "ball" ? "ball" : "roller"));

function suits(field, slot) {
  return field.of.some((one) => kindsOf(slot).includes(one)) && (!field.of_sets || isSet(slot));
}

function helpOf({ meaning, limits_text: limits, example }) {
  const parts = [document.documentElement.lang.startsWith("en") ? meaning : "",
    limits ? say("form.limits", { limits }) : "", example ? say("form.example", { example }) : ""];
  return parts.filter(Boolean).join(" ");
}

let origins = {};

/** The words for where a value comes from. */
export function useOrigins(known) {
  origins = known;
}

function originOf({ origin, source }) {
  return source ? `${origins[origin] ?? origin}: ${source}` : (origins[origin] ?? origin);
}
