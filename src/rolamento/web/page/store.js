// The cases that the page holds: what each says, what is not answered yet, what can be undone.

import { remember, remembered } from "./ask.js";

const MOST_STEPS = 200;
export const MOST = 4;
export const LONGEST_NAME = 40;
const LETTERS = "ABCD";

/**
 * @typedef {object} Slot
 * @property {object} case      tables as a file has them, as last answered
 * @property {object} opened    the same as opened, for a reset
 * @property {number} source    which opening it came from: the form is made anew for another
 * @property {Object<string, any>} changes  by field: asked for, and not yet taken
 * @property {?object} error    what the server says is wrong with the changes
 * @property {Object<string, any>} inputs   by field: {value, text, origin, source}
 * @property {string[]} elements  what rolls
 * @property {?object} status
 */

export class Store {
  /** @type {Slot[]} */ slots = [];
  active = 0;
  #past = [];
  #future = [];
  #sources = 0;
  #moved = "";

  /** kept: under which name the next visit finds them. */
  constructor(kept = "cases") {
    this.kept = kept;
  }

  /** The slot that is edited. */
  get current() {
    return this.slots[this.active] ?? null;
  }

  /** The cases as the next request takes them. */
  get asked() {
    const names = this.names;
    return this.slots.map((one, n) => ({ case: one.case, changes: { ...one.changes }, name: names[n] }));
  }

  /** How many cases may stand side by side. */
  get most() {
    return MOST;
  }

  /** What the cases are called: as the reader says, or by letters. */
  get names() {
    return this.slots.map((one, n) => one.name || LETTERS[n]);
  }

  /** Give a case a name; an empty one gives its letter back. */
  call(n, name) {
    this.slots[n].name = name.trim().slice(0, LONGEST_NAME);
    this.settled();
  }

  /** Take one of several cases out. */
  drop(n) {
    this.slots = this.slots.filter((_, place) => place !== n);
    this.active = Math.min(this.active > n ? this.active - 1 : this.active, this.slots.length - 1);
    this.settled();
  }

  /** Put opened cases in place of all, or one in place of the edited one. */
  open(answers, active = 0, names = []) {
    const fresh = answers.map((answer, n) => ({
      case: answer.case, opened: answer.case, name: names[n] ?? "", source: ++this.#sources, changes: {}, error: null,
      inputs: answer.inputs, elements: answer.elements, status: null,
    }));
    if (fresh.length === 1 && this.slots.length > 1) this.slots[this.active] = { ...fresh[0], name: this.slots[this.active].name };
    else [this.slots, this.active] = [fresh, active];
    this.settled();
  }

  /** Ask for a change of the edited case; null takes the value back to what is unsaid. */
  change(name, value) {
    if (name !== this.#moved) this.settled(); // what was taken of another field is a step of its own
    this.#moved = name;
    this.current.changes[name] = value;
  }

  /** Take an answer; `asked` is what was sent. */
  take(answers, asked) {
    answers.forEach((answer, place) => {
      const slot = this.slots[place];
      slot.error = answer.error;
      if (answer.error) return;
      slot.case = answer.case;
      slot.status = answer.status;
      slot.elements = answer.elements;
      slot.title = answer.title;
      if (answer.likely) slot.likely = answer.likely;
      if (answer.inputs) slot.inputs = answer.inputs;
      for (const [name, value] of Object.entries(asked[place].changes))
        if (slot.changes[name] === value) delete slot.changes[name];
    });
  }

  /** Set a mark to which undo returns. */
  settled() {
    const now = this.#snapshot();
    if (now === this.#past.at(-1)) return;
    this.#past.push(now);
    this.#past.splice(0, this.#past.length - MOST_STEPS);
    this.#future = [];
    this.keep();
  }

  get canUndo() {
    return this.#past.length > 1 || this.slots.some((one) => one.error);
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** Go back one mark; what is wrong and was never taken goes first. */
  undo() {
    if (!this.slots.some((one) => one.error) && this.#past.length > 1)
      this.#future.push(this.#past.pop());
    this.#restore(this.#past.at(-1));
  }

  redo() {
    if (!this.#future.length) return;
    this.#past.push(this.#future.pop());
    this.#restore(this.#past.at(-1));
  }

  /** The edited case as it was opened. */
  reset() {
    const slot = this.current;
    [slot.case, slot.changes, slot.error] = [slot.opened, {}, null];
  }

  /** One more beside those there are: a copy of the edited case, which is edited from now on. */
  compare() {
    if (this.slots.length >= MOST) return;
    const { opened, ...slot } = this.current;
    this.slots = [...this.slots, { ...slot, name: "", opened: slot.case, changes: {}, error: null, source: ++this.#sources }];
    this.active = this.slots.length - 1;
    this.settled();
  }

  /** Go on with the edited case alone. */
  single() {
    this.slots = [this.current];
    this.active = 0;
    this.settled();
  }

  /** The cases as a link and the next visit have them. */
  get given() {
    return { cases: this.slots.map((one) => one.case), names: this.slots.map((one) => one.name ?? ""), active: this.active };
  }

  /** Remember the cases for the next visit. */
  keep() {
    remember(this.kept, this.given);
  }

  static kept(name = "cases") {
    const kept = remembered(name);
    return Array.isArray(kept?.cases) && kept.cases.length ? kept : null;
  }

  #snapshot() {
    const slots = this.slots.map(({ case: tables, opened, source, name = "" }) => ({ case: tables, opened, source, name }));
    return JSON.stringify({ slots, active: this.active });
  }

  #restore(text) {
    const { slots, active } = JSON.parse(text);
    const nothing = { inputs: {}, elements: [], status: null };
    this.slots = slots.map((one, place) => ({
      ...nothing, ...this.slots[place], ...one, changes: {}, error: null,
    }));
    this.active = active;
    this.keep();
  }
}

/** A value by its dotted name in tables; undefined where there is none. */
export function valueAt(tables, name) {
  return name.split(".").reduce((found, part) => (typeof found === "object" ? found?.[part] : undefined), tables);
}

/** Tables with one value put in or, being null, taken out; the given ones stay as they are. */
export function withValue(tables, name, value) {
  const [part, ...rest] = name.split(".");
  const copy = { ...tables };
  if (rest.length) copy[part] = withValue(typeof copy[part] === "object" ? copy[part] : {}, rest.join("."), value);
  else if (value === null) delete copy[part];
  else copy[part] = value;
  return copy;
}
