// Bundles entry.js into the one file that the app serves, with the licences of all that is in it.
import { build } from "esbuild";
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const vendor = join(here, "../../src/rolamento/web/page/vendor");
const plotly = dirname(createRequire(import.meta.url).resolve("plotly.js/package.json"));
const { version } = JSON.parse(readFileSync(join(plotly, "package.json")));

// Texts for the reference of Plotly.js: its own distribution leaves them out too.
const TEXTS = /\s*description: (\[[^\]]*?\]\.join\([^)]*\)|'(?:[^'\\\n]|\\.)*'(?=,?\s*\n)),?/g;
const withoutTexts = {
  name: "without-texts",
  setup(bundle) {
    bundle.onLoad({ filter: /plotly\.js\/src\/.*(attributes|plot_config)\.js$/ }, ({ path }) => ({
      contents: readFileSync(path, "utf8").replace(TEXTS, ""),
      loader: "js",
    }));
  },
};

const { metafile, outputFiles } = await build({
  absWorkingDir: here,
  entryPoints: ["entry.js"],
  outfile: join(vendor, "plotly-rolamento.min.js"),
  bundle: true,
  minify: true,
  write: false,
  metafile: true,
  format: "iife",
  globalName: "Plotly",
  target: "es2020",
  define: { global: "window", "define.amd": "false" },
  loader: { ".css": "empty" },
  legalComments: "none",
  plugins: [withoutTexts],
  banner: {
    js: `/* Plotly.js ${version}, Copyright 2012-2026 Plotly, Inc., MIT; a part of it, ` +
      "made by scripts/plotly. The licences of all that is in it: plotly-rolamento.LICENSE.txt */",
  },
});

const used = Object.values(metafile.outputs)[0].inputs;
const folders = new Set(Object.entries(used)
  .filter(([path, { bytesInOutput }]) => bytesInOutput > 0 && !path.endsWith(".css"))
  .map(([path]) => /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1])
  .filter(Boolean));
const licences = [...folders].sort().map((folder) => {
  const path = join(here, folder);
  const about = JSON.parse(readFileSync(join(path, "package.json")));
  const file = readdirSync(path).find((name) => /^licen[cs]e/i.test(name));
  const text = file ? readFileSync(join(path, file), "utf8").trim() : "";
  return `${about.name} ${about.version} (${about.license})\n\n${text}`;
});

mkdirSync(vendor, { recursive: true });
writeFileSync(join(vendor, "plotly-rolamento.min.js"), outputFiles[0].contents);
writeFileSync(join(vendor, "plotly-rolamento.LICENSE.txt"), licences.join(`\n\n${"-".repeat(72)}\n\n`) + "\n");
const style = join(plotly, "dist/plotly.css");
if (!existsSync(style)) throw new Error("Plotly.js no longer ships its style sheet as a file");
writeFileSync(join(vendor, "plotly.css"), readFileSync(style));
console.log(`Plotly.js ${version}: ${outputFiles[0].contents.length} bytes, ${licences.length} licences`);
