"""No page of a command loses a number, in any language."""

from __future__ import annotations

import pytest
from tests.regression.golden import load_kernels
from tests.regression.pages import PAGES, missing

from rolamento.words import languages


@pytest.fixture(scope="module", autouse=True)
def compiled() -> None:
    load_kernels()


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.sweep] if place % 3 else [])
        for place, name in enumerate(PAGES)
    ],
)
def test_a_page_still_holds_its_numbers(name: str, language: str) -> None:
    assert missing(name, language) == []
