"""Titles of the examples: known to the catalogues of words, and those of the files."""

from __future__ import annotations

import tomllib
from pathlib import Path

from rolamento.case.labels import CHOICES, choice_label
from rolamento.tasks.examples import TITLES
from rolamento.web.form import form
from rolamento.web.page_api import opened, start
from rolamento.words import speaking


def test_titles_are_those_of_the_files(examples: Path) -> None:
    titles = {
        path.relative_to(examples).with_suffix("").as_posix(): tomllib.loads(
            path.read_text("utf-8")
        )["title"]
        for path in (*sorted(examples.glob("*.toml")), *sorted(examples.glob("machines/*.toml")))
    }
    assert titles == TITLES


def test_the_page_says_them_in_its_language() -> None:
    assert opened({"example": "6310_motor"})["title"] == TITLES["6310_motor"]
    with speaking("pt"):
        assert opened({"example": "6310_motor"})["title"].startswith("6310/C3 no lado")


def test_choices_have_labels_and_keep_their_values() -> None:
    fields = {one["name"]: one for group in form() for one in group["fields"]}
    assert {"value": "outer", "label": "outer raceway"} in fields["model.raceway_control"][
        "choices"
    ]
    assert {"value": "DB", "label": "DB"} in fields["bearing.arrangement"]["choices"]
    for name, labels in CHOICES.items():
        known = [one["value"] for one in fields[name]["choices"]]
        assert set(labels) <= set(known), name
    with speaking("pt"):
        assert choice_label("lubricant.kind", "grease") == "graxa"


def test_languages_have_their_tags() -> None:
    with speaking("pt"):
        found = start()
    assert (found["lang"], found["languages"]["pt"]) == ("pt", "pt-BR")
