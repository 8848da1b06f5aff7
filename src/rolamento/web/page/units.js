// Numbers and their units, as people type and read them.

import { remember, remembered } from "./ask.js";

const SAME = { um: "µm" };
const QUANTITY = /^([-+\u2212]?(?:\d{1,3}(?:[\u00a0 ]\d{3})+(?:[.,]\d*)?|[\d.,]*\d[.,]?)(?:e[-+]?\d+)?)\s*(.*)$/i;

const FINE = 2.5; // of a slider's place: a tenth of the way is a three-hundredth of the range

let table = {};
let mark = ".";

/** Take the units of `GET /page/start`, and the decimal mark of its language. */
export function useUnits(units, decimalMark) {
  [table, mark] = [units, decimalMark];
}

/** The units of a dimension to choose from. */
export const unitsOf = (dimension) => (table[dimension] ?? []).filter((one) => !(one.unit in SAME));

/** A unit of a dimension by its name or label. */
export function unitNamed(dimension, name) {
  const known = SAME[name] ?? name;
  return unitsOf(dimension).find((one) => one.unit === known || one.label === known) ?? null;
}

/** Number and unit of a text as a file has it; null of what is none. */
export function parted(text) {
  const match = QUANTITY.exec(String(text).trim());
  const number = match ? Number(match[1].replace("\u2212", "-")) : NaN;
  return Number.isFinite(number) ? { number, unit: match[2] } : null;
}

export const toSi = (number, unit) => number * unit.factor + unit.offset;
export const fromSi = (value, unit) => (value - unit.offset) / unit.factor;

/** A number as it is shown: its decimal mark, no more digits than are read. */
export function shown(number, digits = 7) {
  return String(Number(number.toPrecision(digits))).replace(".", mark);
}

/** A text of numbers as people here write them. */
export const inMark = (text) => text.replace(/(?<=\d)\.(?=\d)/g, mark);

/**
 * What a person typed, its number with a decimal point as files have it.
 * `doubt`: {decimal, whole} where a point may part thousands in this language.
 */
export function typed(text) {
  const match = QUANTITY.exec(text.trim());
  if (!match) return { text: text.trim() };
  let number = match[1].replace("\u2212", "-");
  if (mark === ",") {
    if (number.includes(",")) number = number.replace(/[.\u00a0 ]/g, "").replace(",", ".");
    else if (/^[-+]?[1-9]\d{0,2}(\.\d{3})+$/.test(number))
      return { text, doubt: { decimal: number.replace(".", ","), whole: number.replaceAll(".", "") }, unit: match[2] };
  }
  number = number.replace(/[\u00a0 ]/g, "");
  return { text: `${number} ${match[2]}`.trim(), number, unit: match[2] };
}

/** The unit that the reader chose for such a field, if any. */
export const unitChosen = (field) =>
  unitNamed(field.dimension, remembered(`unit.${field.dimension}.${field.unit}`));

export const chooseUnit = (field, unit) => remember(`unit.${field.dimension}.${field.unit}`, unit);

/**
 * Between what a slider of a field moves, in SI, and whether by ratios; `power`: fine near zero.
 * most: up to where a value is likely, if that is known.
 */
export function reach(field, value, most = 0) {
  if (most > 0) {
    const end = Math.max(most, 1.25 * Math.abs(value));
    return { low: value < 0 ? -end : 0, high: value < 0 ? 0 : end, log: false, power: FINE };
  }
  const low = field.limits.at_least ?? field.limits.above ?? -Infinity;
  const high = field.limits.at_most ?? field.limits.below ?? Infinity;
  const size = Math.abs(value) || Math.abs(exampleOf(field)) || 1;
  if (!field.dimension && low > 0 && high <= 1)
    return { low, high: Math.min(high, low + 4 * (value - low) || high), log: false };
  if (field.dimension === "temperature")
    return { low: Math.max(low, value - 60), high: Math.min(high, value + 60), log: false };
  const positive = low > 0 || "above" in field.limits;
  if (positive && value > 0)
    return { low: Math.max(low, value / 8), high: Math.min(high, value * 8), log: true };
  const both = low < 0 && (field.dimension === "length" || (value === 0 && field.dimension !== "angular_speed"));
  return {
    low: value < 0 || both ? Math.max(low, -3 * size) : Math.max(low, 0),
    high: value < 0 && !both ? Math.min(high, 0) : Math.min(high, 3 * size),
    log: false,
  };
}

/** A number of two or three digits, near one within a range: what a slider gives. */
export function rounded(number, step) {
  const nice = 10 ** Math.floor(Math.log10(Math.abs(step)));
  const unit = [5, 2, 1].map((one) => one * nice).find((one) => one <= Math.abs(step)) ?? nice;
  return Number((Math.round(number / unit) * unit).toPrecision(9));
}

/** The example of a field in SI; NaN of none. */
export function exampleOf(field) {
  const found = parted(field.example);
  if (!found) return NaN;
  const unit = field.dimension ? unitNamed(field.dimension, found.unit) : null;
  return unit ? toSi(found.number, unit) : found.number;
}
