"""`rolamento weibull` and `weibull-plan`: what they print, write and draw, and how they end."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from rolamento.cli.app import app
from rolamento.weibull import published_text

Run = Callable[..., tuple[int, str, str]]
FEW = ("--samples", "200")
CAMPANHA = ("weibull", "--example", "campanha-2008", *FEW)


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run a command in a directory that holds two life tests."""
    monkeypatch.chdir(tmp_path)
    for name in ("campanha_2008", "lieblein_zelen_1956"):
        (tmp_path / f"{name}.csv").write_text(published_text(name), encoding="utf-8")

    def runner(*arguments: str, given: str | bytes | None = None) -> tuple[int, str, str]:
        result = CliRunner().invoke(app, arguments, input=given, env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, result.stderr

    return runner


def strict(text: str) -> Any:
    def refuse(constant: str) -> None:
        raise AssertionError(f"{constant} in JSON")

    return json.loads(text, parse_constant=refuse)


def wrong(outcome: tuple[int, str, str]) -> str:
    """Return the one line that wrong input ends with."""
    code, out, err = outcome
    assert (code, out) == (2, "")
    assert err.count("\n") == 1
    assert "Traceback" not in err
    return err


# --- weibull ---------------------------------------------------------------------------------


def test_the_report_tells_of_fits_bounds_and_groups(run: Run) -> None:
    code, out, err = run(*CAMPANHA)
    assert (code, err) == (0, "")
    assert "24 bearings, 6 failed, 18 suspended; 2 groups; 38.2 to 627.6 h" in out
    assert "I: 14 bearings, 6 failed, 8 suspended" in out
    assert "II: 10 bearings, none failed" in out
    (line,) = re.findall(r"  maximum likelihood +(.*)", out)
    assert line.split() == ["2.001", "508.4", "165.1", "423.3", "450.5"]
    assert "10/9, the shape of the rating standards" in out
    assert "Comparison of the groups" in out
    assert "For an assumed shape" in out


def test_a_file_and_the_example_tell_the_same(run: Run) -> None:
    by_example = run(*CAMPANHA, "--json")[1]
    by_file = run("weibull", "campanha_2008.csv", *FEW, "--json")[1]
    piped = run("weibull", "-", *FEW, "--json", given=published_text("campanha_2008"))[1]
    assert by_example == by_file == piped


def test_json_holds_numbers_of_the_engine(run: Run) -> None:
    from rolamento.weibull import all_bounds, published_life_test

    code, out, err = run(
        "weibull", "lieblein_zelen_1956.csv", *FEW, "--json", "--calculated-life", "C=58e6 rev"
    )
    assert (code, err) == (0, "")
    data = strict(out)
    assert (data["kind"], data["unit"], data["failures"]) == ("weibull", "Mrev", 23)
    (group,) = data["groups"]
    (bound,) = all_bounds(published_life_test("lieblein_zelen_1956"), ["L10"], samples=200)
    told = next(one for one in group["bounds"] if one["quantity"] == "L10")
    assert (told["lower"], told["upper"]) == (bound.lower, bound.upper)
    assert group["calculated"]["C"]["calculated"] == pytest.approx(58.0)
    assert group["calculated"]["C"]["verdict"] == "data contradict calculation"
    assert len(group["points"]) == 23


def test_json_beside_the_report(run: Run, tmp_path: Path) -> None:
    code, out, _ = run(*CAMPANHA, "--json", "out.json")
    assert code == 0
    assert "24 bearings" in out
    assert strict((tmp_path / "out.json").read_text("utf-8"))["size"] == 24
    code, out, _ = run("weibull", "--json", "other.json", "campanha_2008.csv", *FEW)
    assert code == 0
    assert (tmp_path / "other.json").exists()


def test_the_seed_decides(run: Run) -> None:
    first, again = (run(*CAMPANHA, "--only", "I", "--json", "--seed", "3")[1] for _ in range(2))
    assert first == again
    assert first != run(*CAMPANHA, "--only", "I", "--json", "--seed", "4")[1]


def test_large_tests_are_drawn_less_often(run: Run) -> None:
    data = "time,count\n5,600\n6,400\n"
    assert strict(run("weibull", "-", "--method", "ml", "--json", given=data)[1])["samples"] == 5000
    asked = run("weibull", "-", "--method", "ml", "--json", *FEW, given=data)
    assert strict(asked[1])["samples"] == 200


def test_no_failures_is_no_result_unless_the_shape_is_known(run: Run) -> None:
    code, out, err = run(*CAMPANHA, "--only", "II")
    assert (code, err) == (1, "")
    assert "No result. There are no failures" in out
    assert "--shape 1.5" in out
    code, out, err = run(*CAMPANHA, "--only", "II", "--json")
    assert code == 1
    assert strict(out)["groups"][0]["fits"][0]["status"]["code"] == "no_failures"
    assert err.startswith("rolamento: There are no failures")
    code, out, err = run(*CAMPANHA, "--only", "II", "--shape", "1.5")
    assert (code, err) == (0, "")
    assert "With 95 % confidence, 90 % of such bearings reach 78.31 h." in out
    assert "assume the given shape of 1.5" in out
    assert "∞" not in out


def test_one_failure_takes_a_prior(run: Run) -> None:
    data = "time,status\n50,failed\n100,suspended\n100,suspended\n"
    code, out, _ = run("weibull", "-", *FEW, given=data)
    assert code == 1
    assert "One failure does not determine the shape" in out
    code, out, _ = run("weibull", "-", *FEW, "--bayes", "1..2.5", given=data)
    assert code == 0
    assert "shape lognormal, 1 to 2.5 with 90 % probability" in out
    code, out, _ = run("weibull", "-", *FEW, "--bayes", "uniform:1..2.5", given=data)
    assert "shape uniform between 1 and 2.5" in out


def test_a_calculated_life_gets_a_verdict(run: Run) -> None:
    _, out, _ = run(
        *CAMPANHA, "--only", "I", "--calculated-life", "ISO 281=58 h",
        "--calculated-life", "0.189 kh", "--calculated-life", "absurd=5 years",
    )  # fmt: skip
    assert "observed/calculated" in out
    (iso,) = [line for line in out.splitlines() if line.startswith("  ISO 281")]
    assert iso.split()[2:4] == ["58", "2.85"]
    assert iso.endswith("no")
    (plain,) = [line for line in out.splitlines() if line.startswith("  0.189 kh")]
    assert plain.split()[2] == "189"
    (absurd,) = [line for line in out.splitlines() if line.startswith("  absurd")]
    assert absurd.endswith("yes: shorter")


def test_what_is_asked_for_is_shown(run: Run) -> None:
    _, out, _ = run(
        *CAMPANHA, "--only", "I", "--method", "ml", "--three-parameter", "--reliability", "0.99",
        "--reliability", "0.5", "--time", "2 days", "--bounds", "fisher", "--confidence", "0.8",
    )  # fmt: skip
    assert "three parameters" in out
    assert "rank regression" not in out
    assert "  L1 h" in out
    assert "R(48 h) %" in out
    assert "80 % bounds by Fisher information." in out
    assert "for large samples" in out
    assert "With 90 % confidence, 99 % of such bearings" in out


@pytest.mark.parametrize("sides", ["lower", "upper"])
def test_one_side(run: Run, sides: str) -> None:
    _, out, _ = run(*CAMPANHA, "--only", "I", "--sides", sides)
    assert ("at least" if sides == "lower" else "at most") in out
    said = "of such bearings reach" if sides == "lower" else "at most 90 % of such bearings"
    assert said in " ".join(out.split())


def test_groups_by_another_column_or_none(run: Run) -> None:
    _, out, _ = run(*CAMPANHA, "--group", "procedure", "--json")
    data = strict(out)
    assert [(g["name"], g["size"], g["failures"]) for g in data["groups"]] == [
        ("I", 20, 2),
        ("II", 4, 4),
    ]
    assert data["life_ratios"][0]["groups"] == ["I", "II"]
    _, out, _ = run(*CAMPANHA, "--pooled", "--json")
    (pooled,) = strict(out)["groups"]
    assert (pooled["name"], pooled["failures"]) == ("", 6)


def test_it_speaks_portuguese(run: Run) -> None:
    code, out, _ = run(*CAMPANHA, "--lang", "pt", "--calculated-life", "ISO 281=58 h")
    assert code == 0
    assert "24 rolamentos, 6 falharam, 18 suspensos" in out
    assert "Com 95 % de confiança, 90 % destes rolamentos atingem" in out
    assert "observada/calculada" in out
    assert "Sem resultado. Não há falhas" in out


def test_pictures(run: Run, tmp_path: Path) -> None:
    code, _, err = run(*CAMPANHA, "--plot", "paper.png", "--contour", "region.svg")
    assert (code, err) == (0, "")
    assert (tmp_path / "paper.png").read_bytes().startswith(b"\x89PNG")
    assert b"<svg" in (tmp_path / "region.svg").read_bytes()
    code, _, _ = run(*CAMPANHA, "--only", "II", "--plot", "none.png", "--contour", "none.pdf")
    assert code == 1
    assert (tmp_path / "none.png").exists()
    assert (tmp_path / "none.pdf").exists()


def test_the_example_can_be_copied(run: Run, tmp_path: Path) -> None:
    code, out, _ = run("weibull", "--example", "campanha_2008", "--write", "mine.csv")
    assert (code, out) == (0, "Wrote mine.csv\n")
    assert (tmp_path / "mine.csv").read_text("utf-8") == published_text("campanha_2008")
    again = wrong(run("weibull", "--example", "campanha-2008", "--write", "mine.csv"))
    assert "already exists; choose another name" in again


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((), "give a CSV file or --example"),
        (("campanha_2008.csv", "--example", "campanha-2008"), "not both"),
        (("nothere.csv",), "cannot be opened"),
        (("--example", "campanha"), "must be one of campanha-2008"),
        (("campanha_2008.csv", "--write", "x.csv"), "goes with --example alone"),
        (
            ("campanha_2008.csv", "--json", "campanha_2008.csv"),
            "is one of the input files; choose another name",
        ),
        (("campanha_2008.csv", "--plot", "x.png", "--contour", "x.png"), "only one of"),
        (("campanha_2008.csv", "--plot", "x.gif"), "must end in .png, .svg or .pdf"),
        (("campanha_2008.csv", "--method", "eye"), "must be one of ml"),
        (("campanha_2008.csv", "--bounds", "guess"), "must be one of pivotal"),
        (
            ("campanha_2008.csv", "--bounds", "pivotal", "--shape", "1.5"),
            "cannot be combined with --shape, which has its own bounds",
        ),
        (("campanha_2008.csv", "--shape", "-1"), "must be a number greater than 0"),
        (("campanha_2008.csv", "--shape", "nan"), "must be a number"),
        (("campanha_2008.csv", "--confidence", "90"), "between 0 and 1"),
        (("campanha_2008.csv", "--reliability", "1"), "between 0 and 1"),
        (("campanha_2008.csv", "--sides", "both"), "must be one of two"),
        (("campanha_2008.csv", "--samples", "10"), "from 100"),
        (("campanha_2008.csv", "--bayes", "2.5..1"), "greater than low"),
        (("campanha_2008.csv", "--bayes", "one"), "must be LOW..HIGH"),
        (("campanha_2008.csv", "--bayes", "a..b"), "must be LOW..HIGH"),
        (("campanha_2008.csv", "--time", "100"), "needs a unit"),
        (("campanha_2008.csv", "--time", "-1 h"), "must be positive"),
        (("campanha_2008.csv", "--time", "1 Mrev"), "in the unit of the data, h"),
        (("campanha_2008.csv", "--calculated-life", "ISO=h"), "number with its unit"),
        (("campanha_2008.csv", "--calculated-life", "1e999 h"), "must be positive"),
        (
            ("campanha_2008.csv", *(("--calculated-life", "A=58 h") * 2)),
            "gives two lives of the same name",
        ),
        (("campanha_2008.csv", *(("--calculated-life", "8 h") * 9)), "may be given at most"),
        (("campanha_2008.csv", "--only", "III"), "is not a group of the data; the groups are"),
        (("campanha_2008.csv", "--group", "colour"), "is not a column of the file"),
        (
            ("campanha_2008.csv", "--group", "bearing"),
            "to be shown one by one; choose another column, or all",
        ),
        (("campanha_2008.csv", "--contour", "x.png", "--contour-of", "shape"), "scale or a life"),
    ],
)
@pytest.mark.thirds
def test_wrong_wishes_end_with_one_line(run: Run, arguments: tuple[str, ...], said: str) -> None:
    few = () if "--samples" in arguments else FEW
    assert said in wrong(run("weibull", *arguments, *few))


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"\n\n",
        b"\x00\x01\x02",
        b"\xff\xfet\x00i\x00",
        b"time\n",
        b"time,status\n",
        b"time,status\n1,2,3\n",
        b"time,status\n-5,failed\n",
        b"time,status\nnan,failed\n",
        b"time,status\n1e400,failed\n",
        b"time,status\n12,exploded\n",
        b'time,status\n"12,failed\n',
        b"status\nfailed\n",
        b"time,time\n1,2\n",
        b"time,count\n5,0\n",
        b"time,count\n5,1e12\n",
        b"time,lower\n5,6\n",
        b"time,group\n5," + b"x" * 100 + b"\n",
        b"time,group\n5,a\x1b[31m\n",
        b"time,rig,status\n5,a,failed\n6,a,failed\n",
        b"time," + b"x" * 10_000 + b"\n1,2\n",
        b",".join([b"c"] * 500) + b"\n",
        b"<html><body>404</body></html>",
        "tempo,situação\n12,5,falhou\n".encode(),
    ],
)
@pytest.mark.thirds
def test_hostile_files_end_with_one_line(run: Run, tmp_path: Path, content: bytes) -> None:
    (tmp_path / "bad.csv").write_bytes(content)
    wrong(run("weibull", "bad.csv", *FEW))
    wrong(run("weibull", "-", *FEW, given=content))


def test_titles_cannot_write_on_the_terminal(run: Run) -> None:
    data = "# title: a\x1b[31mred\x07\n# source: \x9b2J\ntime\n1\n2\n3\n"
    code, out, _ = run("weibull", "-", *FEW, given=data)
    assert code == 0
    assert not set(out) & {"\x1b", "\x07", "\x9b"}
    assert "a [31mred" in out


@pytest.mark.parametrize(
    "data",
    [
        "time\n5\n",
        "time\n5\n5\n5\n",
        "time,status\n5,s\n",
        "time,lower\n5,0\n5,0\n",
        "time,lower\n5,4\n6,5\n,\n".replace(",\n,", ",4\n7,"),
        "time\n" + "\n".join(["1e-29", "1e29", "1"]) + "\n",
        "time,count\n5,500000\n6,400000\n",
        "time,status,group\n5,f,a\n6,s,b\n7,f,c\n",
    ],
)
@pytest.mark.thirds
def test_odd_but_possible_tests_have_a_page(run: Run, data: str, tmp_path: Path) -> None:
    """Whatever the data, the page, the JSON and the pictures come without a traceback."""
    pictures = ("--plot", "p.svg", "--contour", "c.svg")
    for more in (pictures, ("--shape", "1.5"), ("--bayes", "1..2.5"), ("--three-parameter",)):
        code, out, err = run(
            "weibull", "-", *FEW, "--calculated-life", "3 h", "--time", "4 h", "--json", "j.json",
            *more, given=data,
        )  # fmt: skip
        assert code in (0, 1)
        assert out
        assert "Traceback" not in err
        strict((tmp_path / "j.json").read_text("utf-8"))


# --- weibull-plan ----------------------------------------------------------------------------


def test_a_demonstration_is_planned(run: Run) -> None:
    code, out, err = run(
        "weibull-plan", "demonstration", "--life", "1000 h", "--bearings", "10", "--shape", "1.5"
    )
    assert (code, err) == (0, "")
    assert "Test 10 bearings for 1684 h each" in out
    assert "pass 10.0 % of such tests" in out
    assert "7817 h, 7.82 times" in out
    code, out, _ = run("weibull-plan", "demonstration", "--life", "1000 h")
    assert "Test 22 bearings for 1000 h each" in out
    assert "does not depend on the shape" in out
    code, out, _ = run(
        "weibull-plan", "demonstration", "--life", "1 Mrev", "--time", "5e5 rev",
        "--failures-allowed", "1", "--json",
    )  # fmt: skip
    data = strict(out)
    assert (data["unit"], data["time"], data["failures_allowed"]) == ("Mrev", 0.5, 1)
    assert data["shown"] >= 0.9


def test_a_demonstration_that_shows_too_little(run: Run) -> None:
    arguments = ("--life", "1000 h", "--bearings", "3", "--time", "1 day")
    code, out, _ = run("weibull-plan", "demonstration", *arguments)
    assert code == 1
    assert "do not demonstrate the life" in out
    code, out, err = run("weibull-plan", "demonstration", *arguments, "--json", "--lang", "pt")
    assert code == 1
    assert strict(out)["status"]["code"] == "not_shown"
    assert "não demonstram a vida" in err


def test_precision_is_planned(run: Run) -> None:
    code, out, err = run("weibull-plan", "precision", "--ratio", "5", "--life", "1000 h", *FEW)
    assert (code, err) == (0, "")
    assert "all fail" in out
    assert "sudden death, 8 each" in out
    assert "duration h" in out
    code, out, _ = run(
        "weibull-plan", "precision", "--failures", "6", "--groups", "8", "--group-size", "4",
        "--lang", "pt", *FEW,
    )  # fmt: skip
    assert code == 0
    assert "32 rolamentos, 6 falhas" in out
    assert "os tempos são múltiplos de L10" in out
    code, out, _ = run("weibull-plan", "precision", "--ratio", "5", "--group-size", "5", "--json",
                       *FEW)  # fmt: skip
    plans = strict(out)["plans"]
    assert [plan["group_size"] for plan in plans] == [1, 1, 1, 5]


def test_plans_are_drawn(run: Run, tmp_path: Path) -> None:
    demonstration = ("weibull-plan", "demonstration", "--life", "1000 h", "--bearings", "2")
    precision = ("weibull-plan", "precision", "--ratio", "9", *FEW)
    for name, arguments in (("chance", demonstration), ("cost", precision)):
        code, _, err = run(*arguments, "--plot", f"{name}.png", "--lang", "pt")
        assert (code, err) == (0, "")
        assert (tmp_path / f"{name}.png").read_bytes().startswith(b"\x89PNG")
        assert "must end in .png, .svg or .pdf" in wrong(run(*arguments, "--plot", "x.gif"))


def test_precision_out_of_reach(run: Run) -> None:
    code, out, _ = run("weibull-plan", "precision", "--ratio", "1.5", "--groups", "8", *FEW)
    assert code == 1
    assert "does not bring the bounds that close" in out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("demonstration", "--life", "1000"), "needs a unit"),
        (("demonstration", "--life", "long"), "number with its unit"),
        (("demonstration", "--life", "1 h", "--bearings", "0"), "integer"),
        (("demonstration", "--life", "1 h", "--time", "1 Mrev"), "unit of the data"),
        (("demonstration", "--life", "1 h", "--shape", "0"), "must be"),
        (("demonstration", "--life", "1 h", "--confidence", "1"), "between 0 and 1"),
        (("precision",), "give --ratio or --failures"),
        (("precision", "--ratio", "5", "--failures", "3"), "give --ratio or --failures"),
        (("precision", "--ratio", "0.5"), "must be above 1"),
        (("precision", "--failures", "5", "--groups", "3"), "from 5"),
        (("precision", "--failures", "9999"), "from 1 to 1000"),
        (("precision", "--ratio", "5", "--group-size", "0"), "from 1 to 1000"),
        (("precision", "--ratio", "5", "--samples", "1"), "from 100"),
        (
            (
                "precision",
                "--ratio",
                "5",
                "--groups",
                "9",
                "--group-size",
                "2",
                "--group-size",
                "3",
            ),
            "goes with a single group size",
        ),
    ],
)
def test_wrong_plans_end_with_one_line(run: Run, arguments: tuple[str, ...], said: str) -> None:
    assert said in wrong(run("weibull-plan", *arguments))
