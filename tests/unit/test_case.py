from __future__ import annotations

import io
import os
import sys
import time
from pathlib import Path

import pytest

from rolamento import (
    Case,
    FileError,
    InputError,
    UnitError,
    UnknownKeyError,
    case_to_json,
    case_to_toml,
    load_case,
    override,
    parse_case,
    save_case,
)

TOML = """\
title = "a case"

[bearing]
ball_count = 16
ball_diameter = "22.23 mm"
pitch_diameter = "125.26 mm"
contact_angle = "40 deg"
inner_conformity = 0.5232
outer_conformity = 0.5232

[duty]
inner_speed = "10000 rpm"
load.fx = "20 kN"

[duty.displacement]
ry = "0.05 deg"
"""


def refused(text: str, **arguments: object) -> InputError:
    with pytest.raises(InputError) as caught:
        parse_case(text, source="case.toml", **arguments)  # type: ignore[arg-type]
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 600
    return caught.value


class TestReading:
    def test_every_shipped_example_is_a_case(self, examples: Path) -> None:
        files = sorted(examples.glob("*.toml"))
        assert len(files) >= 4
        for file in files:
            case = load_case(file)
            assert case.title
            assert parse_case(case_to_toml(case)) == parse_case(case_to_json(case)) == case

    def test_the_example_is_the_218(self, examples: Path, case_218: Case) -> None:
        case = load_case(examples / "218_combined.toml")
        assert case.bearing == case_218.bearing
        assert case.duty == case_218.duty

    def test_the_format_is_told_by_the_first_character(self, case_218: Case) -> None:
        assert parse_case(case_to_json(case_218)) == parse_case(case_to_toml(case_218))

    def test_standard_input(self, monkeypatch: pytest.MonkeyPatch, case_218: Case) -> None:
        stream = io.TextIOWrapper(io.BytesIO(case_to_json(case_218).encode()))
        monkeypatch.setattr(sys, "stdin", stream)
        assert load_case("-") == case_218

    def test_a_byte_order_mark_and_other_line_ends(self, tmp_path: Path) -> None:
        file = tmp_path / "case.toml"
        file.write_bytes(b"\xef\xbb\xbf" + TOML.replace("\n", "\r\n").encode())
        assert load_case(file) == parse_case(TOML)

    @pytest.mark.parametrize("name", ["case.toml", "case.JSON"])
    def test_saved_and_loaded(self, tmp_path: Path, case_218: Case, name: str) -> None:
        save_case(case_218, tmp_path / name)
        assert load_case(tmp_path / name) == case_218

    def test_saving_where_it_cannot_be(self, tmp_path: Path, case_218: Case) -> None:
        with pytest.raises(FileError, match=r"must end in \.toml or \.json"):
            save_case(case_218, tmp_path / "case.txt")
        with pytest.raises(FileError, match="no such file or directory"):
            save_case(case_218, tmp_path / "nowhere" / "case.toml")


class TestLines:
    @pytest.mark.parametrize(
        ("old", "new", "line", "field"),
        [
            ('"22.23 mm"', "22.23", 5, "bearing.ball_diameter"),
            ('"22.23 mm"', '"22.23 kg"', 5, "bearing.ball_diameter"),
            ("ball_diameter", "ball_diametre", 5, "bearing.ball_diametre"),
            ('contact_angle = "40 deg"', "", 3, "bearing.contact_angle"),
            ("ball_count = 16", "", 3, "bearing.ball_count"),
            ("ball_count = 16", "ball_count = 99", 4, "bearing.ball_count"),
            ('"20 kN"', "nan", 13, "duty.load.fx"),
            ('load.fx = "20 kN"', "load = { fx = 3 }", 13, "duty.load.fx"),
            ('ry = "0.05 deg"', 'x = "0 mm"', 16, "duty.displacement.x"),
            ('ry = "0.05 deg"', 'y = "1 m"', 16, "duty.displacement.y"),
            ("[duty]", "[dutty]", 11, "dutty"),
            ('"a case"', '"""a\ncase"""', 1, "title"),
            ('"a case"', "3", 1, "title"),
            ('"40 deg"', "2021-01-01", 7, "bearing.contact_angle"),
        ],
    )
    def test_toml(self, old: str, new: str, line: int, field: str) -> None:
        error = refused(TOML.replace(old, new, 1))
        assert (error.field, error.line) == (field, line)
        assert str(error).startswith(f"case.toml, line {line}: {field}")

    def test_json(self, case_218: Case) -> None:
        text = case_to_json(case_218).replace('"15 kN"', "15")
        error = refused(text)
        assert error.field == "duty.load.fz"
        assert '"fz": 15' in text.split("\n")[(error.line or 0) - 1]

    def test_a_bare_number_is_refused_with_an_example(self) -> None:
        error = refused(TOML.replace('"22.23 mm"', "22.23"))
        assert isinstance(error, UnitError)
        assert str(error) == (
            "case.toml, line 5: bearing.ball_diameter = 22.23: needs a unit of length, written as"
            ' text (example: ball_diameter = "22.23 mm")'
        )

    def test_a_misspelt_key_is_refused_with_the_nearest(self) -> None:
        error = refused(TOML.replace("ball_diameter", "ball_diametre"))
        assert isinstance(error, UnknownKeyError)
        assert "did you mean ball_diameter?" in str(error)


class TestBadFiles:
    @pytest.mark.parametrize(
        ("content", "message"),
        [
            (b"", "is empty"),
            (b" \n\n", "is empty"),
            (b"\x89PNG\r\n\x1a\n\0\0\0", "binary"),
            (b'title = "\xe9"\n', "line 1: is not UTF-8"),
            ("title = 'x'".encode("utf-16"), "is UTF-16 text; save it as UTF-8"),
            (b"x" * 1_000_001, "larger than 1 MB"),
            (b"title = ", "line 1: is not valid TOML"),
            (b"title = 1\ntitle = 2", "line 2: is not valid TOML"),
            (b"x = " + b"[" * 100_000, "nested too deep"),
            (b"x = " + b"9" * 100_000, "too many digits"),
            (b"a." * 200_000 + b"b = 1", "more than 100 dots"),
            (b"[[bearing]]\n", "must be a table"),
        ],
    )
    def test_toml(self, tmp_path: Path, content: bytes, message: str) -> None:
        self.check(tmp_path / "case.toml", content, message)

    @pytest.mark.parametrize(
        ("content", "message"),
        [
            (b"", "is empty"),
            (b"{", "line 1: is not valid JSON"),
            (b"[]", "must contain a table"),
            (b"3", "must contain a table"),
            (b'{"title": NaN}', "contains NaN"),
            (b'{"title": -Infinity}', "contains -Infinity"),
            (b'{"title": "a", "title": "b"}', 'gives the key "title" twice'),
            (b'{"x": ' + b"[" * 100_000, "nested too deep"),
            (b'{"x": ' + b'{"x": ' * 100_000, "nested too deep"),
            (b'{"x": ' + b"9" * 100_000 + b"}", "too many digits"),
            (b'{"title": "\\ud800"}', "must be text"),
            (b'{"bearing": null}', "must be a table"),
        ],
    )
    def test_json(self, tmp_path: Path, content: bytes, message: str) -> None:
        self.check(tmp_path / "case.json", content, message)

    @staticmethod
    def check(file: Path, content: bytes, message: str) -> None:
        file.write_bytes(content)
        start = time.monotonic()
        with pytest.raises(InputError) as caught:
            load_case(file)
        assert time.monotonic() - start < 5.0
        assert message in str(caught.value)
        assert str(file) in str(caught.value)

    def test_no_file_to_read(self, tmp_path: Path) -> None:
        with pytest.raises(FileError, match="no such file"):
            load_case(tmp_path / "nothing.toml")
        with pytest.raises(FileError, match="is a directory"):
            load_case(tmp_path)
        with pytest.raises(FileError, match="is not a valid file name"):
            load_case("a\0b")
        with pytest.raises(FileError, match="cannot be opened"):
            load_case("a" * 10_000 + ".toml")

    @pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes on this system")
    def test_a_pipe_does_not_hang(self, tmp_path: Path) -> None:
        os.mkfifo(tmp_path / "pipe.toml")
        with pytest.raises(FileError, match="not a regular file"):
            load_case(tmp_path / "pipe.toml")

    @pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="root reads everything")
    def test_no_permission(self, tmp_path: Path) -> None:
        file = tmp_path / "case.toml"
        file.write_text(TOML)
        file.chmod(0)
        with pytest.raises(FileError, match="permission denied"):
            load_case(file)

    def test_many_headers_take_bounded_time(self) -> None:
        start = time.monotonic()
        refused("".join("[" + "a." * 99 + f"b{i}]\n" for i in range(4_500)))
        assert time.monotonic() - start < 10.0


class TestOverrides:
    def test_values_are_written_as_in_a_file(self, case_218: Case) -> None:
        case = override(
            case_218,
            [
                'duty.load.fz="10 kN"',
                "duty.inner_speed=0 rpm",
                "bearing.ball_count = 15",
                "bearing.inner_conformity=0.52",
                "bearing.ring_material=52100",
                "model.centrifugal_force=false",
                "model.raceway_control=jones",
                "title=2024",
            ],
        )
        assert case.duty.load.fz == 10e3
        assert case.duty.inner_speed == 0.0
        assert case.bearing.ball_count == 15
        assert case.bearing.inner_conformity == 0.52
        assert not case.model.centrifugal_force
        assert case.model.raceway_control == "jones"
        assert case.title == "2024"
        assert case_218.duty.load.fz == 15e3

    def test_a_setting_replaces_its_rival(self, case_218: Case) -> None:
        case = override(case_218, ["bearing.diametral_clearance=0.5 mm", "duty.displacement.x=0 m"])
        assert case.bearing.contact_angle is None
        assert case.bearing.diametral_clearance == 0.5e-3
        assert case.duty.free[0] is False
        back = override(case, ["bearing.contact_angle=40 deg", "duty.load.fx=20 kN"])
        assert back == case_218

    def test_a_fault_in_the_file_may_be_set_right(self) -> None:
        text = TOML.replace('"22.23 mm"', "22.23")
        case = parse_case(text, overrides=["bearing.ball_diameter=22.23 mm"])
        assert case == parse_case(TOML)

    def test_a_table_in_the_file_may_be_set_in_part(self) -> None:
        ceramic = '[bearing.ball_material]\nyoungs_modulus="310 GPa"\npoisson_ratio=0.26\n'
        case = parse_case(TOML + ceramic, overrides=["bearing.ball_material.density=3.2 g/cm^3"])
        assert case.bearing.ball_material.density == 3200.0

    @pytest.mark.parametrize(
        ("setting", "message"),
        [
            ("nonsense", "must be KEY=VALUE"),
            ("=3", "must be KEY=VALUE"),
            ("title=" + "x" * 3000, "must be KEY=VALUE"),
            ("duty.load.fz=10", "duty.load.fz = 10: needs a unit"),
            ("duty.load.fz=", 'duty.load.fz = ""'),
            ("duty.load.fzz=10 N", "did you mean fz"),
            ("duty.load=3", "is a table; set all of it, or one of its fields: fx"),
            ("duty.load.fz.x=3", "duty.load.fz is not a table"),
            ("duty..fz=3", "known: inner_speed"),
            ("bearing.ball_count=16.5", "must be an integer"),
            ("bearing.ball_count=" + "9" * 250, "must be at most 500"),
            ("bearing.inner_conformity=nan", "must be a finite number"),
            ("bearing.ball_material.density=3.2 mm", "is not a unit of density"),
            ("model.raceway_control=oter", "must be one of"),
        ],
    )
    def test_wrong_settings_are_refused(self, case_218: Case, setting: str, message: str) -> None:
        with pytest.raises(InputError) as caught:
            override(case_218, [setting])
        assert message in str(caught.value)
        assert str(caught.value).startswith("--set: ")

    def test_two_settings_that_contradict_each_other(self, case_218: Case) -> None:
        settings = ["duty.load.my=3 N m", "duty.displacement.ry=0 deg"]
        with pytest.raises(
            InputError, match=r"--set: duty\.displacement\.ry .* cannot be combined with"
        ):
            override(case_218, settings)


def test_a_displacement_of_a_whole_ball_is_refused(case_218: Case) -> None:
    with pytest.raises(InputError, match="at most the ball diameter"):
        override(case_218, ["duty.displacement.x=0.03 m"])


def test_importing_the_package_imports_nothing_heavy() -> None:
    import subprocess

    script = (
        "import sys, rolamento;"
        "print(sorted({'numba', 'numpy', 'scipy', 'pydantic', 'pint'} & set(sys.modules)))"
    )
    result = subprocess.run([sys.executable, "-c", script], capture_output=True, check=True)
    assert result.stdout.strip() == b"[]"


@pytest.mark.parametrize("form", ['"k{n:07d}": 1', "k{n:07d} = 1"])
def test_heaps_of_names_are_refused_at_once(form: str) -> None:
    """Whoever looks for each name among all of them takes a minute for these."""
    names = [form.format(n=n) for n in range(52_000)]
    text = "{" + ", ".join(names) + "}" if form.startswith('"') else "\n".join(names)
    begin = time.monotonic()
    with pytest.raises(InputError, match="has a table of more than 1000 keys"):
        parse_case(text)
    assert time.monotonic() - begin < 20.0
