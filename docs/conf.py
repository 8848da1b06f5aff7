"""The settings of Sphinx for the documentation site: `make docs`."""

import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS))

from rolamento import __version__ as release  # noqa: E402

project = "Rolamento"
copyright = "the authors of Rolamento"
version = release
extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_design",
    "builder.extension",
]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
root_doc = "index"
exclude_patterns = ["_build", "builder"]
nitpicky = False
suppress_warnings: list[str] = []

# Markdown as a forge reads it: ```math blocks, links to headings by their words.
myst_enable_extensions = ["colon_fence", "deflist", "dollarmath"]
myst_fence_as_directive = {"math"}
myst_heading_anchors = 6
myst_dmath_double_inline = True

# Docstrings: numpy style, `name` in single backquotes is code, types stand in the text.
default_role = "code"
napoleon_google_docstring = False
napoleon_use_ivar = True
napoleon_use_rtype = False
napoleon_attr_annotations = False
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 88
add_module_names = False
toc_object_entries = False

html_favicon = "../src/rolamento/web/page/icon.svg"  # of the app
html_theme = "furo"
html_title = f"Rolamento {release}"
html_static_path = ["builder/static"]
html_css_files = ["site.css"]
html_math_renderer = "outlines"
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
html_use_index = True
html_search_language = "en"
html_search_scorer = str(DOCS / "builder" / "scorer.js")
pygments_style = "tango"
pygments_dark_style = "native"
highlight_language = "none"
