// The whole case in the link: packed, and never sent to a server.

const MOST_LETTERS = 200_000;
const MOST_BYTES = 500_000;

/** The part behind `#case=` that holds cases: base64url of deflated JSON. */
export async function packed(cases, active) {
  const text = JSON.stringify({ cases, active });
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  let letters = "";
  for (const byte of bytes) letters += String.fromCharCode(byte);
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

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
  if (!Array.isArray(cases) || cases.length < 1 || cases.length > 2 || !cases.every(tables))
    throw new Error("link");
  return { cases, active: found.active === 1 && cases.length === 2 ? 1 : 0 };
}
