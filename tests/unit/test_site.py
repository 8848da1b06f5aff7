"""The parts of the documentation site that are made from the program; `make docs` builds all."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest

from builder import api, checks, equations, navigation, reference, search
from rolamento.case import Case
from rolamento.words.sentences import sentences

DOCS = Path(__file__).resolve().parents[2] / "docs"
THEORY = sorted((DOCS / "theory").glob("*.md"))


@pytest.mark.parametrize("page", THEORY, ids=lambda page: page.stem)
def test_equations_of_the_theory_stand_as_mathematics_each_with_a_number_of_its_own(
    page: Path,
) -> None:
    text = page.read_text("utf-8")
    numbers = equations.numbers_of(text)
    assert len(numbers) == len(set(numbers))
    assert not re.search(r"^ {4,}.*\(\d+[a-z]?\)\s*$", text, re.MULTILINE), "set as mathematics"


def test_a_block_has_a_row_and_an_anchor_for_every_equation() -> None:
    html = equations.block(r"\begin{align} a &= b \tag{1} \\ c &= \frac{d}{e} \tag{2a} \end{align}")
    assert re.findall(r'<tr id="([\w-]+)"', html) == ["equation-1", "equation-2a"]
    assert html.count('class="formula" role="img"') == 4
    assert 'aria-label="= \\frac{d}{e}"' in html


@pytest.mark.parametrize("latex", [r"\frac{a}{", r"a \tag{1} \tag{2}"])
def test_what_cannot_be_set_is_refused(latex: str) -> None:
    with pytest.raises(ValueError, match=r"not understood|two numbers"):
        equations.block(latex)


def test_every_part_that_a_page_asks_for_is_made_and_no_other_is_there() -> None:
    asked = {
        part
        for page in (*DOCS.glob("*.md"), *DOCS.glob("*/*.md"))
        for part in re.findall(r"^<!-- made: ([\w-]+) -->$", page.read_text("utf-8"), re.MULTILINE)
    }
    assert asked <= reference.PARTS.keys()
    assert reference.PARTS.keys() - asked <= {"examples"}


def test_the_reference_has_every_field_note_and_command() -> None:
    from typer.main import get_command

    from rolamento.cli.app import app

    fields, notes, commands = (reference.made(part) for part in ("fields", "notes", "commands"))
    assert all(f"`{name.rpartition('.')[2]}`" in fields for name in Case.fields())
    assert "`[duty.load]`" in fields
    assert "at least −1 000 000 kN and at most 1 000 000 kN" in fields
    assert all(f"| `{key}` |" in notes for key in sentences())
    shown = set(re.findall(r"^#+ `rolamento ([\w -]+)`$", commands, re.MULTILINE))
    assert shown >= set(get_command(app).commands)  # type: ignore[attr-defined]
    assert "`--variant NAME:FIELD=VALUE`" in commands or "--variant" in commands


def test_the_reference_has_the_http_api() -> None:
    assert "POST /api/v1/solve" in reference.http_api()


def test_the_glossary_speaks_as_the_catalogue_of_words_does() -> None:
    glossary = reference.made("glossary")
    assert "| pitch diameter | diâmetro primitivo | d_m | m |" in glossary
    labels = reference.made("labels")
    assert "| `bearing.ball_count` | number of balls | número de esferas |" in labels


def test_an_openapi_document_becomes_pages() -> None:
    record = {"properties": {"fr": {"type": "string", "description": "radial load"}}}
    text = reference.operations_of(
        {
            "paths": {
                "/api/v1/solve": {
                    "post": {
                        "summary": "Solve a case.",
                        "parameters": [{"name": "lang", "in": "query", "schema": {"enum": ["en"]}}],
                        "requestBody": {
                            "content": {"application/json": {"schema": {"$ref": "#/a/Ask"}}}
                        },
                        "responses": {"200": {"description": "Solved."}},
                    }
                }
            },
            "components": {"schemas": {"Ask": record}},
        }
    )
    for piece in ("## `POST /api/v1/solve`", "| `lang` | query | `en` |", ": Ask.", "| `fr` |"):
        assert piece in text


def test_a_package_has_a_page_with_every_public_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert {"rolamento", "rolamento.case", "rolamento.vibration"} <= set(api.packages())
    chosen = ["rolamento", "rolamento.case", "rolamento.errors", "rolamento.solved"]
    monkeypatch.setattr(api, "packages", lambda: chosen)  # all of them would be imported
    api.write_pages(tmp_path)
    pages = {path.stem: path.read_text("utf-8") for path in tmp_path.glob("*.rst")}
    assert set(pages) == set(chosen)
    for package in chosen:
        for module, names in api.public_of(package):
            for name in names:
                entries = (f":: {module.__name__}.{name}\n", f"- ``{name}``: :py:obj:`rolamento.")
                assert any(entry in pages[package] for entry in entries), name
    assert "- ``Case``: :py:obj:`rolamento.case.Case`" in pages["rolamento"]
    bases = "\n   :members:\n   :show-inheritance:\n"
    assert f"rolamento.errors.InputError{bases}" in pages["rolamento.errors"]
    assert f"rolamento.solved.Solved{bases}" not in pages["rolamento.solved"], "it has none"


def test_bars_and_stars_of_a_docstring_are_no_markup_and_code_stays() -> None:
    lines = ["|Q| times a*b of `x*y`, d_ and :math:`a|b|`"]
    assert api.escaped(lines) == [r"\|Q\| times a\*b of `x*y`, d\_ and :math:`a|b|`"]


def test_a_record_is_described_by_its_fields_and_their_defaults() -> None:
    signature = api.on_signature(None, "class", "Case", Case, None, "(anything at 0x7f)", "")
    assert signature is not None
    assert signature[0].startswith("(*, title='', bearing, duty, ")
    assert "0x" not in signature[0]
    arrays = "(t: ndarray[tuple[Any, ...], dtype[float64]])"
    found = api.on_signature(None, "function", "f", len, None, arrays, "None")
    assert found == ("(t: NDArray[float64])", "None")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("ISO 281", ["ISO", "n281"]),
        ("ISO/TS 16281:2008", ["ISO", "TS", "n16281", "n2008"]),
        ("20816-3", ["n20816", "n20816_3"]),
        ("6305 at 0.5", ["n6305", "at", "n0", "n5"]),
    ],
)
def test_numbers_are_words_of_the_search(text: str, words: list[str]) -> None:
    assert search.words_of(text) == words


def test_a_question_finds_the_pages_with_all_its_words() -> None:
    index = {
        "docnames": ["life", "severity"],
        "terms": {"iso": [0, 1], "n281": 0, "n20816": [1]},
        "titleterms": {"n20816_3": 1},
    }
    assert search.asked(index, "ISO 281") == {"life"}
    assert search.asked(index, "20816-3") == {"severity"}
    assert search.asked(index, "ISO 9999") == set()
    assert '"281" does not find theory/life' in search.missing(index)


def test_the_tree_of_an_index_page_is_its_links() -> None:
    text = (DOCS / "index.md").read_text("utf-8")
    sections = dict(navigation.pages_of(text))
    assert sections["Theory"] == ["nomenclature.md", "theory/index.md"]
    shown = navigation.with_pages("index", text, DOCS)
    assert (
        "```{toctree}\n:hidden:\n:caption: Theory\n\nnomenclature.md\ntheory/index.md\n```" in shown
    )
    assert navigation.with_pages("life", text, DOCS) == text


def test_a_page_that_loads_from_elsewhere_is_found(tmp_path: Path) -> None:
    (tmp_path / "searchindex.js").write_text(
        'Search.setIndex({"docnames": [], "terms": {}, "titleterms": {}})', "utf-8"
    )
    (tmp_path / "a.html").write_text(
        '<script src="https://cdn.example.org/x.js"></script><a href="https://example.org">x</a>'
        '<link rel="canonical" href="https://example.org"><img src="own.png">',
        "utf-8",
    )
    (tmp_path / "a.css").write_text("@import 'https://fonts.example.org/a.css';", "utf-8")
    wrong = [line for line in checks.wrong_in(tmp_path) if "loads" in line]
    assert wrong == [
        "a.html loads https://cdn.example.org/x.js",
        "a.css loads https://fonts.example.org/a.css",
    ]


def test_a_page_about_a_word_weighs_more_than_one_that_mentions_it() -> None:
    index = {
        "docnames": ["heading", "mentions", "about"],
        "terms": {"life": [1, 2]},
        "titleterms": {"life": 0},
    }
    pages = {
        "heading": Counter(life=2, of=20),
        "mentions": Counter(life=1, of=200),
        "about": Counter(lifes=20, of=20),
    }
    mentions, about, heading = map(int, search.weigh(index, pages)["weights"]["life"])
    assert mentions < heading < about
