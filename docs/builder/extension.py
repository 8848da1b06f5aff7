"""The extension of Sphinx: mathematics, navigation, pages made from the program, search, checks."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path
from typing import Any, Final

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx
from sphinx.search.en import SearchEnglish
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util import logging
from sphinx.util.nodes import find_pending_xref_condition
from sphinx.writers.html5 import HTML5Translator

from builder import api, checks, equations, navigation, reference, search
from builder.accessible import make_accessible

_log: Final = logging.getLogger(__name__)
_MADE: Final = re.compile(r"^<!-- made: ([\w-]+) -->$", re.MULTILINE)
_CITED: Final = re.compile(r"(?<![\w(])\((\d{1,3}[a-z]?)\)(?!\w)")
_LOWERED: Final = re.compile(
    r"(?<![\w.\\])([A-Za-zΑ-Ωα-ωϵ]{1,2}\d?[′']?)_([A-Za-z0-9Α-Ωα-ω]+(?:,[A-Za-z0-9]+)*)"
    r"(?![A-Za-z0-9_Α-Ωα-ω])"
)
_RAISED: Final = re.compile(
    r"\^(?:(±?\([^()<>]{1,30}\))|([−-]?\d+(?:\.\d+)?(?:/\d+)?|[a-zβ]\b|[½¼¾⅓]))"
)
_NO_PROSE: Final = (nodes.literal, nodes.FixedTextElement, nodes.title, nodes.reference)


class Translator(HTML5Translator):
    """Indices and powers of the prose as such, and links to the equations of the page."""

    def visit_Text(self, node: nodes.Text) -> None:  # noqa: N802
        """Write a text."""
        before = len(self.body)
        super().visit_Text(node)
        docname = self.builder.current_docname
        if self.protect_literal_text or docname.startswith("reference/api/"):
            return
        parent: Any = node.parent
        while parent is not None:
            if isinstance(parent, _NO_PROSE):
                return
            parent = parent.parent
        numbers = self.builder.env.metadata.get(docname, {}).get("equations", "").split()
        written = _LOWERED.sub(r"\1<sub>\2</sub>", "".join(self.body[before:]))
        written = _RAISED.sub(_raised, written)
        self.body[before:] = [_CITED.sub(lambda found: _cited(found, numbers), written)]


def _raised(found: re.Match[str]) -> str:
    return f"<sup>{found[2] or found[1].replace('(', '').replace(')', '')}</sup>"


def _cited(found: re.Match[str], numbers: list[str]) -> str:
    if found[1] not in numbers:
        return found[0]
    return f'(<a class="equation" href="#{equations.anchor_of(found[1])}">{found[1]}</a>)'


class PlainNames(SphinxPostTransform):
    """Types as docstrings have them: a word is a word, a name that of the module it stands in."""

    default_priority = 5  # before references are resolved

    def run(self, **kwargs: Any) -> None:
        """Make a reference exact, or plain text."""
        objects = self.env.domains.python_domain.objects
        for node in list(self.document.findall(pending_xref)):
            target = node.get("reftarget", "")
            if node.get("refdomain") != "py" or "." in target:
                continue
            own = f"{node.get('py:module')}.{target}"
            if own in objects:
                node["reftarget"] = own
            elif target[:1].islower() or sum(one.endswith(f".{target}") for one in objects) > 1:
                shown = find_pending_xref_condition(node, "resolved")
                node.replace_self((shown or node).children)


class Standards(SearchEnglish):
    """English, and numbers are words too."""

    lang = "en"
    js_splitter_code = search.SPLITTER

    def split(self, input: str) -> list[str]:
        """Return the words of a text."""
        return search.words_of(input)


def _inline(translator: HTML5Translator, node: nodes.math) -> None:
    translator.body.append(_set(equations.inline, node, node.astext()))
    raise nodes.SkipNode


def _block(translator: HTML5Translator, node: nodes.math_block) -> None:
    translator.body.append(_set(equations.block, node, node.astext()))
    raise nodes.SkipNode


def _set(setter: Any, node: nodes.Node, latex: str) -> str:
    try:
        return str(setter(latex))
    except ValueError as error:
        _log.warning("%s", error, location=node)
        return ""


def _on_source(app: Sphinx, docname: str, content: list[str]) -> None:
    """Fill in what is made from the program, and the pages that a page lists."""
    text = _MADE.sub(lambda found: reference.made(found[1]), content[0])
    text = navigation.with_pages(docname, text, Path(app.srcdir))
    content[0] = text
    numbers = equations.numbers_of(text)
    if len(numbers) != len(set(numbers)):
        twice = sorted({number for number in numbers if numbers.count(number) > 1})
        _log.warning("equations with one number: %s", ", ".join(twice), location=docname)
    app.env.temp_data["equations"] = numbers


def _on_read(app: Sphinx, document: nodes.document) -> None:
    metadata: Any = app.env.metadata[app.env.docname]
    metadata["equations"] = " ".join(app.env.temp_data.get("equations", ()))
    document += nodes.meta(
        name="keywords", content=", ".join(sorted(_keywords(app.env.docname, document)))
    )


def _keywords(docname: str, document: nodes.document) -> Counter[str]:
    """What a page is found by beside its own words."""
    if docname.startswith(("reference/api/", "adr/", "gallery/")):
        return Counter()
    terms = [(english, portuguese) for english, portuguese, _ in reference.terms()]
    return search.keywords(
        docname, document.astext(), terms, reference.glossary_file()["portuguese"]
    )


def _on_finished(app: Sphinx, error: Exception | None) -> None:
    if error is None and app.builder.format == "html":
        site = Path(app.outdir)
        make_accessible(site)
        _weigh(app, site)
        for wrong in checks.wrong_in(site):
            _log.warning("%s", wrong)


def _weigh(app: Sphinx, site: Path) -> None:
    """Add to the search what each page is about."""
    index = search.index_of(site)
    pages = {}
    for docname in index["docnames"]:
        document = app.env.get_doctree(docname)
        words = Counter(map(str.lower, search.words_of(document.astext())))
        pages[docname] = words + _keywords(docname, document)
    search.write_index(site, search.weigh(index, pages))


def setup(app: Sphinx) -> dict[str, Any]:
    """Add all of it to Sphinx."""
    api.write_pages(Path(app.srcdir) / "reference" / "api")
    app.add_html_math_renderer("outlines", (_inline, None), (_block, None))
    app.set_translator("html", Translator)
    app.add_search_language(Standards)
    app.connect("source-read", _on_source)
    app.connect("doctree-read", _on_read)
    app.add_post_transform(PlainNames)
    app.connect("autodoc-process-docstring", api.on_docstring, priority=100)
    app.connect("autodoc-process-docstring", api.on_attributes, priority=600)
    app.connect("autodoc-process-signature", api.on_signature)
    app.connect("autodoc-process-bases", api.on_bases)
    app.connect("autodoc-skip-member", api.on_member)
    app.connect("build-finished", _on_finished)
    return {"parallel_read_safe": True, "parallel_write_safe": True, "version": "1"}
