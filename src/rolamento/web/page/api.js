// Requests of the HTTP API to try: each form sends its text and shows what comes back.

async function send(form) {
  const { method, address } = form.dataset;
  const text = form.querySelector("textarea").value.trim();
  const json = { method, body: text, headers: { "Content-Type": "application/json" } };
  const lang = document.documentElement.lang.slice(0, 2);
  const query = new URLSearchParams(method === "GET" ? text : "");
  query.set("lang", lang);
  const response = await fetch(`${address}?${query}`, method === "GET" ? {} : json);
  const kind = response.headers.get("Content-Type") ?? "";
  if (kind.includes("json")) return [response.ok, JSON.stringify(await response.json(), null, 2)];
  if (kind.includes("pdf")) return [response.ok, `${kind}, ${(await response.blob()).size} B`];
  return [response.ok, await response.text()];
}

document.addEventListener("submit", async (event) => {
  event.preventDefault();
  const form = event.target;
  const [button, output] = [form.querySelector("button"), form.querySelector("output")];
  button.disabled = true;
  let good = false, text;
  try {
    [good, text] = await send(form);
  } catch (error) {
    text = String(error);
  }
  output.textContent = text;
  output.classList.toggle("bad", !good);
  output.hidden = false;
  button.disabled = false;
});
