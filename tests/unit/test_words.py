"""What is said to people: catalogues, numbers in texts, notes; and the catalogues themselves."""

from __future__ import annotations

import gettext
import importlib.util
import json
import pickle
import re
import sys
from collections.abc import Iterator
from functools import partial
from math import nan, pi
from pathlib import Path
from threading import Barrier, Thread
from types import ModuleType

import numpy as np
import pytest
from babel.messages.pofile import read_po
from typer.main import get_command

from rolamento import tasks
from rolamento.case import Case, RollerBearing
from rolamento.case.fields import fields_of
from rolamento.cli.app import app
from rolamento.cli.grouped_help import as_option
from rolamento.web.form import as_labelled
from rolamento.words import (
    Manner,
    Note,
    counted,
    language,
    language_asked,
    language_of,
    languages,
    manner,
    marked,
    said,
    said_in,
    speaking,
    spelling,
)

NAME = re.compile(r"`([^`]+)`")
SPEAKING = sys.modules["rolamento.words.speaking"]
ROOT = Path(__file__).parents[2]


@pytest.fixture
def scripts() -> ModuleType:
    """The script that keeps the catalogues."""
    spec = importlib.util.spec_from_file_location("words_script", ROOT / "scripts" / "words.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def catalogues(
    tmp_path: Path, scripts: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Path]:
    """A catalogue of Portuguese and one of a language with three forms of the plural."""
    for name, rule, entries in (
        ("pt_BR", "nplurals=2; plural=(n > 1)", PORTUGUESE),
        ("pl", THREE_FORMS, POLISH),
    ):
        folder = tmp_path / name / "LC_MESSAGES"
        folder.mkdir(parents=True)
        head = 'msgid ""\nmsgstr ""\n"Content-Type: text/plain; charset=utf-8\\n"\n'
        head += f'"Language: {name}\\n"\n"Plural-Forms: {rule};\\n"\n\n'
        (folder / "rolamento.po").write_text(head + entries, encoding="utf-8")
    monkeypatch.setattr(scripts, "LOCALE", tmp_path)
    for name in ("pt_BR", "pl"):
        scripts.compile_(name)
    monkeypatch.setattr(SPEAKING, "CATALOGUES", tmp_path)
    _forget()
    yield tmp_path
    _forget()


def _forget() -> None:
    for kept in (SPEAKING.languages, SPEAKING._manner, SPEAKING._catalogue):
        kept.cache_clear()


PORTUGUESE = """
msgctxt "decimal mark"
msgid "."
msgstr ","

msgid "turns at {speed:.4 rpm}"
msgstr "gira a {speed:.4 rpm}"

msgctxt "race"
msgid "inner"
msgstr "interna"

msgctxt "ring"
msgid "inner"
msgstr "interno"

msgid "{n} ball"
msgid_plural "{n} balls"
msgstr[0] "{n} esfera"
msgstr[1] "{n} esferas"
"""
THREE_FORMS = (
    "nplurals=3; plural=(n==1 ? 0 : n%10>=2 && n%10<=4 && (n%100<10 || n%100>=20) ? 1 : 2)"
)
POLISH = """
msgid "{n} ball"
msgid_plural "{n} balls"
msgstr[0] "{n} kulka"
msgstr[1] "{n} kulki"
msgstr[2] "{n} kulek"
"""


@pytest.mark.usefixtures("catalogues")
class TestSaying:
    def test_english_stands_where_it_is_used(self) -> None:
        assert said("turns at {speed:.4 rpm}", speed=100.0 * pi) == "turns at 3000 rpm"
        assert said("a plain {text}") == "a plain {text}"

    def test_another_language_in_a_block(self) -> None:
        with speaking("pt"):
            assert language() == "pt"
            assert said("turns at {speed:.4 rpm}", speed=55.0 * pi / 30.0) == "gira a 55 rpm"
            assert said("turns at {speed:.4 rpm}", speed=5.25 * pi / 30.0) == "gira a 5,25 rpm"
            with speaking(None):
                assert language() == "pt"
            with speaking("en"):
                assert manner().mark == "."
            assert manner().mark == ","
        assert language() == "en"

    def test_what_is_not_translated_is_english(self) -> None:
        with speaking("pt"):
            assert said("untranslated {n:.2}", n=1.5) == "untranslated 1,5"

    def test_one_word_of_two_contexts(self) -> None:
        with speaking("pt"):
            assert said_in("race", "inner") == "interna"
            assert said_in("ring", "inner") == "interno"
        assert said_in("ring", "inner") == "inner"

    @pytest.mark.parametrize(
        ("code", "number", "text"),
        [
            ("en", 0, "0 balls"), ("en", 1, "1 ball"), ("en", 2, "2 balls"),
            ("pt", 0, "0 esfera"), ("pt", 1, "1 esfera"), ("pt", 2, "2 esferas"),
            ("pl", 1, "1 kulka"), ("pl", 3, "3 kulki"), ("pl", 5, "5 kulek"),
            ("pl", 22, "22 kulki"), ("pl", 112, "112 kulek"),
        ],
    )  # fmt: skip
    def test_forms_of_the_plural(self, code: str, number: int, text: str) -> None:
        with speaking(code):
            assert counted("{n} ball", "{n} balls", number) == text

    def test_marked_is_said_later(self) -> None:
        text = marked("turns at {speed:.4 rpm}")
        with speaking("pt"):
            assert said(text, speed=0.0).startswith("gira")

    def test_languages_are_those_of_the_catalogues(self) -> None:
        assert dict(languages()) == {"en": "en", "pt": "pt_BR", "pl": "pl"}
        assert language_of("pl") == "pl"
        assert language_of("xx") == "en"
        assert language_of(None, {"LANG": "pt_BR.UTF-8"}) == "pt"
        assert language_of(None, {"LC_ALL": "C", "LANG": "pt_BR.UTF-8"}) == "en"
        assert language_of(None, {}) == "en"

    @pytest.mark.parametrize(
        ("arguments", "code"),
        [
            (("solve", "a.toml", "--lang", "pt"), "pt"),
            (("--lang=pt", "--help"), "pt"),
            (("--lang", "en", "solve", "--lang", "pt"), "pt"),
            (("solve", "--", "--lang", "pt"), "en"),
            (("solve", "--lang"), "en"),
            ((), "en"),
        ],
    )
    def test_the_language_that_a_command_line_asks_for(
        self, arguments: tuple[str, ...], code: str, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("LC_ALL", "C.UTF-8")
        assert language_asked(arguments) == code

    def test_each_thread_speaks_its_own(self) -> None:
        meet, heard = Barrier(2), {}

        def speak(code: str) -> None:
            with speaking(code):
                for _ in range(50):
                    meet.wait()
                    heard.setdefault(code, set()).add(said_in("race", "inner"))

        threads = [Thread(target=speak, args=(code,)) for code in ("en", "pt")]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert heard == {"en": {"inner"}, "pt": {"interna"}}

    def test_a_catalogue_that_is_missing_is_english(self, catalogues: Path) -> None:
        (catalogues / "pt_BR" / "LC_MESSAGES" / "rolamento.mo").unlink()
        _forget()
        with speaking("pt"):
            assert said("turns at {speed:.4 rpm}", speed=0.0) == "turns at 0 rpm"

    def test_a_broken_catalogue_is_english(self, catalogues: Path) -> None:
        (catalogues / "pt_BR" / "LC_MESSAGES" / "rolamento.mo").write_bytes(b"no catalogue")
        _forget()
        with speaking("pt"):
            assert said("turns at {speed:.4 rpm}", speed=0.0) == "turns at 0 rpm"


@pytest.mark.parametrize(
    ("value", "form", "english", "portuguese"),
    [
        (12345, "", "12 345", "12 345"),
        (-1234, "", "−1234", "−1234"),
        (2**63 + 8, "", "9 223 372 036 854 775 816", "9 223 372 036 854 775 816"),
        (1234.5, "", "1234", "1234"),
        (0.52321, ".3", "0.523", "0,523"),
        (2.0, ".2f", "2.00", "2,00"),
        (2.0, ".4", "2", "2"),
        (1.5e-9, ".1e", "1.5e-9", "1,5e-9"),
        (1.83e18, ".2e", "1.83e18", "1,83e18"),
        (1e9, ".6g", "1e9", "1e9"),
        (-1e9, ".3r", "−1.00e9", "−1,00e9"),
        (-0.25, ".6g", "−0.25", "−0,25"),
        (1.5, "+.2f", "+1.50", "+1,50"),
        (pi, ".4 rpm", "30 rpm", "30 rpm"),
        (pi, ".4 [rpm]", "30", "30"),
        (343.15, ".4 °C", "70 °C", "70 °C"),
        (pi / 4, ".3 °", "45°", "45°"),
        (0.5, ".3 %", "50 %", "50 %"),
        (nan, ".3", "–", "–"),
        ("text", ".3 rpm", "text", "text"),
        ([0.5, 1.0], ".2", "0.5, 1", "0,5, 1"),
        (np.array([1, 2]), "", "1, 2", "1, 2"),
        (list(range(9)), "", "0, 1, 2, 3, 4, 5, 6, 7 …", "0, 1, 2, 3, 4, 5, 6, 7 …"),
    ],
)
def test_specifications_of_numbers(value: object, form: str, english: str, portuguese: str) -> None:
    template = "{value:" + form + "}"
    assert Manner(".").format(template, value=value) == english
    assert Manner(",").format(template, value=value) == portuguese


def test_a_specification_that_is_none() -> None:
    with pytest.raises(ValueError, match="is no specification"):
        Manner(".").number(1.0, ".3 furlong")


class TestNotes:
    NOTE = Note("not_converged", {"residual": 1e-3, "tolerance": 1e-9})

    def test_as_json_and_back(self) -> None:
        with speaking("pt"):
            mapping = json.loads(json.dumps(self.NOTE.to_mapping()))
            assert self.NOTE.text != mapping["text"]
        assert mapping["text"] == self.NOTE.text == str(self.NOTE)
        assert Note.from_mapping(mapping) == self.NOTE

    def test_they_are_values(self) -> None:
        assert pickle.loads(pickle.dumps(self.NOTE)) == self.NOTE
        assert len({self.NOTE, Note("not_converged", dict(self.NOTE.values))}) == 1
        with pytest.raises(TypeError):
            self.NOTE.values["residual"] = 0.0  # type: ignore[index]


class TestScript:
    def test_it_finds_what_is_said(self, scripts: ModuleType) -> None:
        found = scripts.template()
        assert found.get("must be one of {known}") is not None
        assert found.get("Show the version.") is not None
        assert found.get("FILE", "metavar") is not None
        assert found.get("Inside the bearing") is not None
        assert found.get("is not a readable {kind}: {reason}") is not None  # of a private package

    def test_it_complains(
        self, scripts: ModuleType, catalogues: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        from babel.messages.catalog import Catalog

        wanted = Catalog()
        wanted.add("turns at {speed:.4 rpm}")
        wanted.add(("{n} ball", "{n} balls"))
        wanted.add("missing here")
        wanted.add("inner", context="race")
        monkeypatch.setattr(scripts, "template", lambda: wanted)
        path = catalogues / "pt_BR" / "LC_MESSAGES" / "rolamento.po"
        text = path.read_text(encoding="utf-8")
        text = text.replace("gira a {speed:.4 rpm}", "gira a {spede}")
        text = text.replace('msgctxt "race"', '#, fuzzy\nmsgctxt "race"')
        path.write_text(text, encoding="utf-8")
        told = "\n".join(scripts.complaints("pt_BR"))
        assert "missing: 'missing here'" in told
        assert "unused: '.'" in told
        assert "fuzzy: 'inner'" in told
        assert "filled in otherwise: 'turns at {speed:.4 rpm}'" in told

    def test_what_is_counted_now_is_to_be_translated_anew(
        self, scripts: ModuleType, catalogues: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        from babel.messages.catalog import Catalog

        wanted = Catalog()
        wanted.add(("turns at {speed:.4 rpm}", "turn at {speed:.4 rpm}"))
        monkeypatch.setattr(scripts, "template", lambda: wanted)
        found = scripts.merged("pt_BR").get("turns at {speed:.4 rpm}")
        assert not any(found.string)

    @pytest.mark.sweep
    def test_a_further_language_is_one_file(
        self, scripts: ModuleType, catalogues: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(sys, "argv", ["words.py", "--new", "fr"])
        assert scripts.main() == 0
        path = catalogues / "fr" / "LC_MESSAGES" / "rolamento.po"
        assert "Plural-Forms: nplurals=" in path.read_text(encoding="utf-8")
        _forget()
        assert "fr" in languages()
        with speaking("fr"):
            assert said("untranslated") == "untranslated"
        assert isinstance(gettext.translation("rolamento", catalogues, ["fr"]), object)

    def test_plural_forms_are_those_of_the_catalogue_not_of_the_babel_that_compiles_it(
        self, scripts: ModuleType, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        """Babel 2.19 has three of Portuguese, 2.18 two; the messages are numbered by one of them.

        Compiled with the other, a count had no translation.
        """
        three = (3, "(n == 0 || n == 1) ? 0 : n != 0 && n % 1000000 == 0 ? 1 : 2")
        monkeypatch.setattr("babel.messages.catalog.get_plural", lambda locale: three)
        for catalogue in (scripts.translated("pt_BR"), scripts.merged("pt_BR")):
            assert catalogue.plural_forms == "nplurals=2; plural=(n > 1);"

    def test_every_place_of_a_translation_is_one_of_the_english(self, scripts: ModuleType) -> None:
        wrong = []
        for message in scripts.translated("pt_BR"):
            allowed = scripts._places(message.id)
            wrong += [t for t in scripts._texts(message.string) if scripts._places(t) - allowed]
        assert not wrong


def test_names_in_texts_are_spelled_by_whoever_says_them() -> None:
    text = "give `speed`, such as `shape=1.5`, or `life.cleanliness` ({share:.2})"
    assert said(text, share=0.25) == "give speed, such as shape=1.5, or life.cleanliness (0.25)"
    with spelling(lambda name: f"<{name}>"):
        assert said(text, share=0.25).startswith("give <speed>, such as <shape=1.5>, or <life.")
        assert said("no name") == "no name"
    assert said("`speed`") == "speed"


def test_a_command_line_spells_names_as_its_options() -> None:
    as_typed = partial(as_option, {"machine_class": "--class", "changes": "--set"})
    assert as_typed("full_scale") == "--full-scale"
    assert as_typed("machine_class") == "--class"
    assert as_typed("changes") == "--set"
    assert as_typed("scale='5 g'") == "--scale '5 g'"
    assert as_typed("life.cleanliness") == "life.cleanliness"
    assert as_typed("bearing.roller_count=N") == "--set bearing.roller_count=N"
    assert as_typed("rolamento life") == "rolamento life"


def test_a_page_spells_names_as_its_labels() -> None:
    as_shown = partial(as_labelled, {"speed": "“Shaft speed”"})
    assert as_shown("speed") == "“Shaft speed”"
    assert as_shown("speed=5 rpm") == "“Shaft speed” = 5 rpm"
    assert as_shown("slip") == "slip"


def test_every_name_in_a_text_is_one_of_the_program() -> None:
    """Of an input, a field of a case, or a command: no face could spell any other."""
    with (SPEAKING.CATALOGUES / "pt_BR" / "LC_MESSAGES" / "rolamento.po").open("rb") as file:
        texts = [one for message in read_po(file) for one in np.atleast_1d(message.id)]
    named = {name.partition("=")[0] for text in texts for name in NAME.findall(text)}
    requests = [one for one in map(tasks.__getattr__, tasks.__all__) if hasattr(one, "products")]
    inputs = {"changes", "scheduler", "restart"}  # of a study's run
    inputs |= {name for one in requests for name in (*one.inputs(), *one.products)}
    rollers = (f"bearing.{name}" for name in fields_of(RollerBearing))
    fields = {*Case.fields(), *rollers}
    fields |= {field.rpartition(".")[0] for field in fields}
    commands = {f"rolamento {name}" for name in get_command(app).commands}
    assert len(named) > 60
    assert named <= {*inputs, *fields, *commands, "rolamento catalogue show"}
