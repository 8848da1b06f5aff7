// What the app draws with: Plotly.js' core without its own style sheet (page/vendor/plotly.css is
// served as a file), without menus, sliders and 3D, and with three kinds of traces beside scatter.
"use strict";

const { register } = require("plotly.js/src/registry");
const api = require("plotly.js/src/plot_api");

// nothing is sent anywhere, whatever a page asks for
const { configAttributes } = require("plotly.js/src/plot_api/plot_config");
configAttributes.plotlyServerURL.dflt = "";
configAttributes.showSendToCloud.dflt = false;

for (const [name, fn] of Object.entries(api)) register({ moduleType: "apiMethod", name, fn });
register([
  require("plotly.js/src/traces/scatter"),
  require("plotly.js/lib/scatterpolar"),
  require("plotly.js/lib/bar"),
  require("plotly.js/lib/heatmap"),
]);
register([
  require("plotly.js/src/components/annotations"),
  require("plotly.js/src/components/selections"),
  require("plotly.js/src/components/shapes"),
  require("plotly.js/src/components/errorbars"),
  require("plotly.js/src/components/colorscale"),
  require("plotly.js/src/components/colorbar"),
  require("plotly.js/src/components/legend"), // after shapes
  require("plotly.js/src/components/fx"), // after legend
  require("plotly.js/src/components/modebar"),
]);
register([
  require("plotly.js/src/locale-en"),
  require("plotly.js/src/locale-en-us"),
  require("plotly.js/lib/locales/pt-br"),
]);

module.exports = {
  version: require("plotly.js/src/version").version,
  newPlot: api.newPlot,
  react: api.react,
  relayout: api.relayout,
  restyle: api.restyle,
  update: api.update,
  purge: api.purge,
  downloadImage: api.downloadImage,
  Plots: { resize: require("plotly.js/src/plots/plots").resize },
  Fx: { hover: require("plotly.js/src/components/fx").hover },
};
