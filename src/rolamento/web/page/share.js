// The whole case in the link: packed, and never sent to a server.

import { LONGEST_NAME, MOST } from "./store.js";

const MOST_LETTERS = 200_000;
const MOST_BYTES = 500_000;

/** The part behind `#case=` that holds cases, `{cases, names, active}`: base64url of deflated JSON. */
export async function packed(given) {
  const text = JSON.stringify(given);
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  let letters = "";
  for (const byte of bytes) letters += String.fromCharCode(byte);
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

const calledIn = (name) => (typeof name === "string" ? name.trim().slice(0, LONGEST_NAME) : "");

/** The cases of such a part; rejects where it is none, or too long. */
export async function unpacked(text) {
  if (text.length > MOST_LETTERS || !/^[\w-]+$/.test(text)) throw new Error("link");
  const letters = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(letters, (one) => one.charCodeAt(0));
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const parts = [];
  let size = 0;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    size += part.value.length;
    if (size > MOST_BYTES) {
      await reader.cancel();
      throw new Error("link"); // what is packed small may be large
    }
    parts.push(part.value);
  }
  const found = JSON.parse(await new Blob(parts).text());
  const cases = found?.cases;
  const tables = (one) => one !== null && typeof one === "object" && !Array.isArray(one);
  if (!Array.isArray(cases) || cases.length < 1 || cases.length > MOST || !cases.every(tables))
    throw new Error("link");
  const names = cases.map((_, n) => calledIn(found.names?.[n]));
  return { cases, names, active: Number.isInteger(found.active) && found.active > 0 && found.active < cases.length ? found.active : 0 };
}
