"""Help and errors in the language that is asked for."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from typer.main import get_command
from typer.testing import CliRunner

import rolamento
from rolamento.cli.app import app
from rolamento.cli.grouped_help import METAVAR, as_option, paragraphs
from rolamento.words import said, said_in, speaking, spelling

EXAMPLE = Path(rolamento.__file__).parent / "examples" / "218_combined.toml"
SAME = {"N", "P", "R", "S", "G", "M", "C", "K", "H,H,…", "A,A,…", "DB", "BETA"}
"""Words that stand for a value in either language."""


def run(*arguments: str, **environment: str) -> tuple[int, str]:
    env = {"LC_ALL": "C.UTF-8", "COLUMNS": "100", **environment}
    outcome = CliRunner().invoke(app, arguments, env=env)
    if outcome.exception and not isinstance(outcome.exception, SystemExit):
        raise outcome.exception
    return outcome.exit_code, outcome.output


def commands(command: Any, *names: str) -> Iterator[tuple[tuple[str, ...], Any]]:
    yield names, command
    for name, inner in getattr(command, "commands", {}).items():
        yield from commands(inner, *names, name)


EVERY = list(commands(get_command(app)))


def flat(text: str) -> str:
    return " ".join(text.split())


@pytest.mark.parametrize(("names", "command"), EVERY, ids=[" ".join(n) for n, _ in EVERY])
@pytest.mark.thirds
def test_the_help_of_every_command_is_said(names: tuple[str, ...], command: Any) -> None:
    code, portuguese = run(*names, "--help", "--lang", "pt")
    assert code == 0
    assert run("--lang=pt", *names, "--help") == (0, portuguese)
    assert run(*names, "-h", LC_ALL="pt_BR.UTF-8") == (0, portuguese)
    english = run(*names, "--help")[1]
    assert english.startswith("Usage: root")
    assert portuguese.startswith("Uso: root")
    texts = [command.help, command.epilog, *command.groups, "Show this message and exit."]
    texts += [getattr(one, "help", None) for one in command.params]
    shown = flat(portuguese)
    for text in (part for one in texts if one for part in paragraphs(one)):
        with spelling(partial(as_option, {"changes": "--set"})):
            with speaking("pt"):
                translated = said(text)
            text = said(text)
        assert translated != text
        if "[" not in text:  # where a line may break
            assert flat(text) in flat(english) or text not in english
            assert flat(text) not in shown
        assert flat(translated).split(".")[0][:40] in shown or text in command.groups
    for one in command.params:
        if getattr(one, "metavar", None) and one.metavar not in SAME:
            with speaking("pt"):
                assert said_in(METAVAR, one.metavar) != one.metavar, one.metavar
    for word in ("Options", "Arguments", "Commands", "[required]", "[default", "COMMAND", "FILE"):
        assert not re.search(rf"(?<![\w.]){re.escape(word)}\b", portuguese), word


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (("solv",), "Erro: Comando desconhecido: solv. Você quis dizer solve?"),
        (("xyz",), "Erro: Comando desconhecido: xyz."),
        (("solve",), "Erro: Falta o argumento: CASO."),
        (("synthesise", "6205"), "Erro: Falta a opção: --output."),
        (("solve", "a", "b"), "Erro: Argumentos a mais: b"),
        (("solve", "a", "--jsn"), "Erro: Opção desconhecida: --jsn. Você quis dizer --json"),
        (("app", "--port", "x"), "inválido para --port: deve ser um número inteiro."),
        (("turn", "a", "--points"), "Erro: A opção --points precisa de um valor."),
        (("diagnose", "a", "--nominal=1"), "Erro: A opção --nominal não aceita valor."),
        (("reproduce", "--pictures", "x"), "inválido para --pictures: deve ser um de: svg, png"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_command_line(arguments: tuple[str, ...], text: str) -> None:
    code, out = run("--lang", "pt", *arguments)
    assert code == 2
    assert text in flat(out)
    english = run(*arguments)[1]
    assert text not in flat(english)
    assert english.startswith("Usage: root")


@pytest.mark.parametrize(
    ("setting", "text"),
    [
        ("bearing.ball_count=2", "bearing.ball_count = 2: deve ser no mínimo 3"),
        ("bearing.ball_count=x", 'bearing.ball_count = "x": deve ser um número inteiro'),
        ("bearing.ball_diameter=22", "precisa de uma unidade de comprimento, escrita como texto"),
        ("bearing.ball_diameter=2 kg", '"kg" não é uma unidade de comprimento'),
        ("bearing.bal_count=3", "é uma chave desconhecida; você quis dizer ball_count?"),
        ("duty.load=3", "é uma tabela; defina-a inteira ou um de seus campos: fx, fy, fz, my, mz"),
        ("bearing.ball_material=wood", "é um nome desconhecido (material); conhecidos: 100Cr6"),
        ("model.raceway_control=x", "deve ser um de: outer, inner, jones, none, friction"),
        ("duty.load.fx=1e9 kN", "deve ser no mínimo −1 000 000 kN e no máximo 1 000 000 kN"),
        ("bearing.ball_diameter=140.5 mm", "deve ser maior que o diâmetro da esfera, 140,5 mm"),
        ("bearing.inner_conformity=0.4", "deve ser no mínimo 0,501 e no máximo 1"),
    ],
)
def test_errors_of_a_case(setting: str, text: str) -> None:
    code, out = run("solve", str(EXAMPLE), "--set", setting, "--lang", "pt")
    assert code == 2
    assert out.startswith("rolamento: ")
    assert text in out
    assert "must be" not in out


@pytest.mark.parametrize(
    ("content", "text"),
    [
        ("", "case.toml: está vazio; espera-se uma tabela em TOML ou JSON"),
        ("[bearing]\nball_count = 3\n[duty\n", "case.toml, linha 3: não é TOML válido: "),
        ("[bearing]\nball_count = [3]\n", "case.toml, linha 2: bearing.ball_count = uma lista: "),
        ("title = 3\n", "linha 1: title = 3: deve ser texto (exemplo: "),
    ],
)
def test_errors_name_the_line(
    content: str, text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(content, encoding="utf-8")
    code, out = run("solve", "case.toml", "--lang", "pt")
    assert code == 2
    assert text in out


def test_files_that_cannot_be_read_or_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert (
        "não pode ser aberto: arquivo ou pasta inexistente"
        in run("solve", "no.toml", "--lang=pt")[1]
    )
    no_signal = ("diagnose", "no.wav", "--bearing=6205", "--speed=1480 rpm", "--lang=pt")
    assert "não pode ser lido: arquivo ou pasta inexistente" in run(*no_signal)[1]
    assert "é uma pasta; indique um arquivo de caso" in run("solve", ".", "--lang=pt")[1]
    out = run("solve", str(EXAMPLE), "--json", "no/where.json", "--lang", "pt")[1]
    assert "não pode ser gravado: arquivo ou pasta inexistente" in out


def test_an_error_of_the_library_is_english_unless_another_is_spoken() -> None:
    with pytest.raises(rolamento.InputError) as caught:
        rolamento.Bearing(ball_count=2)
    assert "is missing" in str(caught.value) or "at least 3" in str(caught.value)
    with speaking("pt"), pytest.raises(rolamento.InputError) as caught:
        rolamento.Bearing(ball_count=2)
    assert "falta" in str(caught.value) or "no mínimo 3" in str(caught.value)


def test_prose_has_decimal_commas() -> None:
    """What is no code, no option and no number of a chapter is written as the language has it."""
    help_of = flat(run("weibull", "--help", "--lang", "pt")[1])
    assert "0,9 para L10; por padrão 0,9 e 0,5." in help_of
    assert not re.search(r"como \d\.\d", help_of)


@pytest.mark.parametrize(
    "arguments", [("--help",), ("--version",), ("solve", "-h"), ("solve", "6305")]
)
def test_a_language_that_is_not_known_is_refused_everywhere(arguments: tuple[str, ...]) -> None:
    code, text = run(*arguments, "--lang", "xx")
    assert code == 2
    assert "must be one of en, pt (example: --lang pt)" in flat(text)
    assert run(*arguments[:1], "--help", LC_ALL="xx_YY.UTF-8")[0] == 0  # a locale may be any
