"""Files dropped on the page: what is read, what is refused, and that nothing else gets through."""

from __future__ import annotations

import io
import json
import struct
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import anyio
import httpx
import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.tasks import (
    DemonstrationTest,
    LifeTestEvaluation,
    Request,
    VibrationDiagnosis,
    VibrationSeverity,
)
from rolamento.tasks.bearing import designated
from rolamento.web import drops, limits
from rolamento.web.server import Settings, create_app

HERE = "http://127.0.0.1:8000"
TABLE = b"time (h),status,group\n" + b"".join(
    f"{100 + 37 * i},{'failed' if i % 3 else 'suspended'},{'AB'[i % 2]}\n".encode()
    for i in range(12)
)


@pytest.fixture(autouse=True)
def _here(monkeypatch: pytest.MonkeyPatch) -> None:
    """Do the work in this process: that others end it is tested with the limits."""

    async def slow(function: Callable[..., Any], *args: Any, seconds: float = 0.0) -> Any:
        return function(*args)

    monkeypatch.setattr(drops, "slow", slow)


@pytest.fixture(scope="module")
def record() -> bytes:
    content: bytes = drops.example_file("signal", "outer_race")["content"]
    return content


def ask(method: str, address: str, **more: Any) -> httpx.Response:
    async def asked() -> httpx.Response:
        transport = httpx.ASGITransport(create_app(Settings(warm=False)))
        async with httpx.AsyncClient(transport=transport, base_url=HERE) as client:
            return await client.request(method, address, **more)

    return anyio.run(asked)


def drop(
    content: bytes, name: str, *, kind: str = "signal", lang: str = "en", **typed: Any
) -> httpx.Response:
    headers = {"x-file-name": name, "origin": HERE}
    params = {"lang": lang, **typed}
    return ask("PUT", f"/page/{kind}", content=content, headers=headers, params=params)


def test_a_record_says_what_is_damaged_as_the_command_does(record: bytes, tmp_path: Path) -> None:
    from rolamento import tasks

    answer = drop(record, "motor%20drive.npz", bearing="6205").json()
    path = tmp_path / "own.npz"
    path.write_bytes(record)
    own = tasks.diagnose(path, designated("6205"))
    assert answer["verdict"] == {
        "code": "fault",
        "text": own.statement[0].text,
        "tone": "bad-strong",
    }
    assert "motor drive.npz" in answer["html"]
    assert "data:image/svg+xml;base64," in answer["html"]
    assert "rolamento-" not in answer["html"]
    assert "<script" not in answer["html"]


def test_a_record_is_judged_in_the_language_of_the_reader(record: bytes) -> None:
    typed = {"bearing": "6205", "unit": "m/s^2", "power": "45 kW", "format": "txt"}
    answer = drop(record, "x.npz", lang="pt", **typed).text
    assert "pista externa" in answer
    assert "ISO 20816-3" in answer


def test_the_case_on_the_page_is_the_bearing_where_none_is_named(record: bytes) -> None:
    case = {"bearing": {"designation": "6205"}, "duty": {"load": {"fz": "1 kN"}}}
    answer = drop(record, "x.npz", case=json.dumps(case), format="json").json()
    assert answer["frequencies"]["source"] == "loaded"
    assert answer["verdict"] == "fault"


@pytest.fixture(scope="module")
def samples(record: bytes) -> Any:
    return max(np.load(io.BytesIO(record)).values(), key=np.size)[:24_000]


def _csv(samples: Any) -> bytes:
    return b"acceleration (m/s^2)\n" + b"\n".join(b"%.6g" % one for one in samples)


def _wav(samples: Any) -> bytes:
    data = (samples / np.abs(samples).max() * 30000).astype("<i2").tobytes()
    head = struct.pack("<4sIHHIIHH", b"fmt ", 16, 1, 1, 12000, 24000, 2, 16)
    body = b"WAVE" + head + b"data" + struct.pack("<I", len(data)) + data
    return b"RIFF" + struct.pack("<I", len(body)) + body


def _mat(samples: Any) -> bytes:
    import scipy.io

    scipy.io.savemat(file := io.BytesIO(), {"DE_time": samples, "RPM": 1797.0})
    return file.getvalue()


def _hdf5(samples: Any) -> bytes:
    import h5py

    with h5py.File(file := io.BytesIO(), "w") as group:
        group["acc"] = samples
    return file.getvalue()


def _npy(samples: Any) -> bytes:
    np.save(file := io.BytesIO(), samples)
    return file.getvalue()


def _parquet(samples: Any) -> bytes:
    import pyarrow as pa
    import pyarrow.parquet as pq

    pq.write_table(pa.table({"acc": samples}), file := io.BytesIO())
    return file.getvalue()


def _uff(samples: Any) -> bytes:
    lines = ["    -1", "    58", "acc", "NONE", "NONE", "NONE", "NONE"]
    lines.append(f"{1:5d}{0:10d}{1:5d}{0:10d} {'NONE':10s}{1:10d}{3:4d} {'NONE':10s}{0:10d}{0:4d}")
    count = len(samples)
    lines.append(f"{2:10d}{count:10d}{1:10d}{0.0:13.5E}{1 / 12000:13.5E}{0.0:13.5E}")
    axis = f"{17:10d}{0:5d}{0:5d}{0:5d} {'NONE':20s} {'NONE':20s}"
    own = f"{12:10d}{0:5d}{0:5d}{0:5d} {'acc':20s} {'m/s^2':20s}"
    empty = f"{0:10d}{0:5d}{0:5d}{0:5d} {'NONE':20s} {'NONE':20s}"
    lines += [axis, own, empty, empty]
    lines += ["".join(f"{one:13.5E}" for one in samples[at : at + 6]) for at in range(0, count, 6)]
    return ("\n".join([*lines, "    -1"]) + "\n").encode()


@pytest.mark.parametrize(
    ("ending", "written"),
    [
        ("csv", _csv), ("wav", _wav), ("mat", _mat), ("h5", _hdf5), ("npy", _npy),
        ("parquet", _parquet), ("uff", _uff),
    ],
)  # fmt: skip
def test_every_format_of_the_command_can_be_dropped(
    ending: str, written: Callable[[Any], bytes], samples: Any
) -> None:
    typed = {} if ending in ("wav", "uff") else {"rate": "12 kHz"}
    answer = drop(
        written(samples), f"x.{ending}", bearing="6205", speed="1797 rpm", format="json", **typed
    )
    assert answer.status_code == 200, answer.text
    assert answer.json()["faults"] == ["outer_race"]


def _damaged(record: bytes, samples: Any) -> Iterator[tuple[str, bytes]]:
    yield "x.npz", record[:5000]
    yield "x.npz", b"PK\x03\x04" + b"\0" * 100
    yield "x.wav", _wav(samples)[:30]
    yield "x.wav", b"RIFF\xff\xff\xff\xffWAVEfmt \xff\xff\xff\x7f"
    yield "x.mat", b"no MATLAB at all"
    yield "x.mat", _mat(samples)[:3000]
    yield "x.h5", _hdf5(samples)[:900]
    yield "x.csv", b"\xff\xfea\0b\0"
    yield "x.csv", b'a,b\n1,2\n"' + b"x" * 10000
    yield "x.parquet", b"PAR1" + b"\0" * 40 + b"PAR1"
    yield "x.uff", b"    -1\n    58\n" + b"x\n" * 20
    yield "x.exe", b"MZ" + b"\0" * 400
    yield "x.csv", b""


def test_a_damaged_file_gets_one_sentence_that_names_it(record: bytes, samples: Any) -> None:
    for name, content in _damaged(record, samples):
        answer = drop(content, name, bearing="6205", speed="1797 rpm", rate="12 kHz")
        assert answer.status_code == 422, (name, content[:20], answer.text[:300])
        message = answer.json()["error"]["message"]
        assert name in message, message
        assert "rolamento-" not in message
        assert "Traceback" not in message


@pytest.mark.parametrize(
    "name",
    ["../../etc/passwd", "/etc/passwd.csv", "C:\\secret\\x.csv", "a\x00b.npz", "", "x" * 5000],
)
def test_a_name_is_never_a_path(name: str, record: bytes) -> None:
    from urllib.parse import quote

    answer = drop(b"RIFF", quote(name), bearing="6205", speed="1797 rpm")
    assert answer.status_code == 422
    message = answer.json()["error"]["message"]
    assert "etc/" not in message
    assert "secret" not in message
    assert len(message) < 1000


@pytest.mark.parametrize(
    ("field", "typed"),
    [
        ("bearing", {"bearing": "nothing"}),
        ("bearing", {"bearing": "/etc/passwd"}),
        ("bearing", {"bearing": "case.toml"}),
        ("bearing", {}),
        ("speed", {"bearing": "6205", "speed": "fast"}),
        ("rate", {"bearing": "6205", "rate": "12 km"}),
        ("channel", {"bearing": "6205", "channel": "7"}),
        ("unit", {"bearing": "6205", "unit": "parsec"}),
        ("tolerance", {"bearing": "6205", "tolerance": "50 %"}),
        ("support", {"bearing": "6205", "support": "soft"}),
        ("duration", {"bearing": "6205", "duration": "900 s"}),
        ("nonsense", {"bearing": "6205", "nonsense": "1"}),
        ("power", {"bearing": "6205", "unit": "m/s^2", "power": "much"}),
    ],
)
def test_what_is_wrong_is_said_at_its_field(
    field: str, typed: dict[str, str], record: bytes
) -> None:
    answer = drop(record, "x.npz", **typed)
    assert answer.status_code == 422
    assert answer.json()["error"]["field"] == field, answer.text


def test_a_life_test_with_groups_is_compared() -> None:
    typed = {"calculated": "ISO 281=58 h", "times": "200 h", "format": "txt"}
    answer = drop(TABLE, "lives.csv", kind="weibull", **typed)
    assert answer.status_code == 200, answer.text
    assert "ISO 281" in answer.text
    assert "lives.csv" in answer.text
    assert "2 groups" in answer.text


def test_a_life_test_as_a_file_has_the_numbers_of_the_task() -> None:
    from rolamento.tasks import life_test_study
    from rolamento.weibull import parse_life_test

    answer = drop(TABLE, "x.csv", kind="weibull", format="json", confidence="0,95").json()
    own = life_test_study(parse_life_test(TABLE.decode(), "x.csv"), confidence=0.95)
    assert answer == json.loads(json.dumps(own.to_mapping()))


@pytest.mark.parametrize(
    ("field", "content", "typed"),
    [
        ("bounds", TABLE, {"bounds": "pivotal", "shape": "1.5"}),
        ("method", TABLE, {"method": "eye"}),
        ("only", TABLE, {"only": "C"}),
        ("times", TABLE, {"times": "100 parsec"}),
        ("confidence", TABLE, {"confidence": "95"}),
        ("reliabilities", TABLE, {"reliabilities": "0.9; x"}),
        ("prior", TABLE, {"prior": "one"}),
        ("header", b"120\n130\n", {}),
        ("status", b"time,status\n120,maybe\n", {}),
        ("", b"\x00\x01", {}),
    ],
)
def test_a_wrong_table_is_refused_where_it_is_wrong(
    field: str, content: bytes, typed: dict[str, str]
) -> None:
    answer = drop(content, "x.csv", kind="weibull", **typed)
    assert answer.status_code == 422, answer.text[:300]
    assert answer.json()["error"]["field"] == field, answer.text


def test_a_file_that_is_too_large_is_refused_before_it_is_read() -> None:
    answer = drop(b"time\n" + b"1\n" * 2_600_000, "x.csv", kind="weibull")
    assert answer.status_code == 413
    assert "5 MB" in answer.json()["error"]["message"]


def test_a_test_is_planned() -> None:
    answer = ask("POST", "/page/weibull/plan?life=1000%20h&bearings=10", headers={"origin": HERE})
    assert answer.json()["verdict"]["code"] == "result"
    answer = ask("POST", "/page/weibull/plan", headers={"origin": HERE})
    assert answer.json()["error"]["field"] == "life"


CASE = {
    "bearing": {"designation": "6205"},
    "duty": {"inner_speed": "1500 rpm", "load": {"fz": "2 kN"}},
}


@pytest.mark.parametrize(("form", "begins"), [("txt", b"Bearing calculation"), ("json", b"{")])
def test_a_report_of_two_cases_is_a_file(form: str, begins: bytes) -> None:
    other = {**CASE, "duty": {**CASE["duty"], "inner_speed": "3000 rpm"}}
    head = {"author": "A. Souza", "project": None}
    asked = {"cases": [CASE, other], "format": form, "head": head}
    answer = ask("POST", "/page/report?lang=en", json=asked, headers={"origin": HERE})
    assert answer.status_code == 200, answer.text
    assert answer.content.startswith(begins)
    assert answer.headers["content-disposition"].endswith(f'.{form}"')
    assert b"A. Souza" in answer.content


@pytest.mark.parametrize(
    ("field", "asked"),
    [
        ("cases", {"cases": "x"}),
        ("cases", {}),
        ("format", {"cases": [CASE], "format": "exe"}),
        ("bearing.designation", {"cases": [{"bearing": {"designation": "x"}}]}),
        ("head", {"cases": [CASE], "head": [1]}),
        ("changes", {"cases": [CASE], "head": {"changes": {"duty.load.fz": "9 kN"}}}),
        ("case", {"cases": [CASE], "head": {"case": "/etc/hostname"}}),
        ("output", {"cases": [CASE], "head": {"output": "/tmp/report.html"}}),
        ("names", {"cases": [CASE], "head": {"names": ["A"]}}),
    ],
)
def test_a_report_of_what_is_no_case_is_refused(field: str, asked: dict[str, Any]) -> None:
    answer = ask("POST", "/page/report", json=asked, headers={"origin": HERE})
    assert answer.status_code == 422
    assert answer.json()["error"]["field"] == field, answer.text


def test_a_page_calls_options_as_it_labels_them() -> None:
    """Not as the commands do, whose notes it shows."""
    one_failure = b"time,status\n100,failed\n200,suspended\n"
    answer = drop(one_failure, "x.csv", kind="weibull", format="txt").text
    assert "“Shape from experience” = 1.5" in " ".join(answer.split())
    assert " --" not in answer


@pytest.mark.parametrize(
    ("request_", "own"),
    [
        (VibrationDiagnosis, {"signal": "x.wav"}),
        (VibrationSeverity, {"signals": ["x.wav"]}),
        (LifeTestEvaluation, {"data": [1.0, 2.0]}),
        (DemonstrationTest, {}),
    ],
)
def test_every_example_of_what_is_asked_for_can_be_read(
    request_: type[Request], own: dict[str, Any]
) -> None:
    asked = {name: one for name, one in request_.inputs().items() if not one.is_local}
    examples = {name: [one.example] for name, one in asked.items() if one.example}
    for name, texts in examples.items():
        needed = {"life": ["1 h"], "bearing": ["6205"], "hours": ["1"]}
        typed = {key: one for key, one in needed.items() if key in asked} | {name: texts}
        typed.pop("hours" if name == "dates" else "", None)
        assert getattr(request_.read(typed, **own), name) is not None
    with pytest.raises(InputError):
        request_.read({"nonsense": ["1"]}, **own)


@pytest.mark.parametrize("name", ["machine", "baseline", "signal"])
def test_no_page_names_a_file(name: str) -> None:
    """What is read from the disk of the server is nothing that a visitor may choose."""
    with pytest.raises(InputError, match="is not asked for here"):
        VibrationDiagnosis.read({name: ["/etc/passwd"]}, signal="x.wav", bearing="6205")
    assert name not in str(VibrationDiagnosis.described())
    with pytest.raises(InputError, match="bearing"):
        VibrationDiagnosis.read({"bearing": ["/etc/passwd"]}, signal="x.wav")


def test_a_worker_does_the_same(record: bytes, tmp_path: Path) -> None:
    """The functions and what they return go from one process to another."""
    path = tmp_path / "x.csv"
    path.write_bytes(b"no table")

    async def refused() -> None:
        with pytest.raises(InputError, match=r"x\.csv"):
            await limits.slow(drops.life_test_page, str(path), "x.csv", {}, "")

    anyio.run(refused)


def test_no_face_speaks_of_another() -> None:
    """A command repeats an option; a page takes several values in one field."""
    forms = drops.described()
    options = [
        one
        for form in ("signal", "weibull", "plan")
        for group in forms[form]
        for one in group["options"]
    ]
    meanings = {one["name"]: one["meaning"] for one in options}
    assert not [text for text in meanings.values() if "epeat" in text or "--" in text]
    assert meanings["reliabilities"].endswith("Separate several with semicolons.")
    assert "everal with" not in meanings["confidence"]
    help_of = CliRunner().invoke(app, ["weibull", "--help"]).output
    assert "Separate several" not in help_of
    assert help_of.count("Repeatable.") == sum(
        one.is_many and not one.is_argument for one in LifeTestEvaluation.inputs().values()
    )
