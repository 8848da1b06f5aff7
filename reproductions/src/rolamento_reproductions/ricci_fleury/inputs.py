"""The inputs, and what is said of the paper."""

from __future__ import annotations

from typing import Final

from rolamento_reproductions.given import Given
from rolamento_reproductions.text import Prose

GIVEN: Final = Given("ricci_fleury")
said: Final = Prose(GIVEN.name)
