"""What Rolamento wrote of a machine for which REXS has no word."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from rolamento.errors import FileError
from rolamento.exchange.rexs.model import Component
from rolamento.exchange.rexs.reader import (
    CUSTOM,
    DIGEST,
    Part,
    Reader,
    is_valid,
)
from rolamento.exchange.rexs.values import placed
from rolamento.words import said

__all__ = ["Restorer"]


class Restorer(Reader):
    """Puts back what REXS had no word for."""

    def restored(self, parts: Iterable[Part]) -> Iterator[Part]:
        """Put back what REXS had no word for, where the rest is still as it was written."""
        read: dict[int, list[Part]] = {}
        for part in parts:
            read.setdefault(part.component, []).append(part)
        digests = [one.attributes[DIGEST].text for one in self.model.of_type("gear_unit")
                   if DIGEST in one.attributes]  # fmt: skip
        self._untouched = bool(digests) and digests[0] == self.whole.digest(CUSTOM)
        for component in self.model.components:
            own = read.pop(component.id, [])
            attribute = component.attributes.get(CUSTOM)
            if attribute is None:
                yield from own
                continue
            self._use(component, CUSTOM)
            count = len(self.remarks)
            yield from self._mended(component, own, attribute.text)
            if len(self.remarks) == count:  # nothing was changed: what was inferred does not count
                also = (
                    {oil.id for oil in self.model.of_type("lubricant")}
                    if component.type == "gear_unit"
                    else set()
                )
                self.remarks = [
                    one for one in self.remarks if one.component not in {component.id, *also}
                ]
        for left in read.values():
            yield from left

    def _mended(self, component: Component, own: list[Part], text: str) -> Iterator[Part]:
        try:
            entries = json.loads(text)
            changes = [
                (str(kind), {str(k): (was, now) for k, (was, now) in keys.items()})
                for kind, keys in entries
            ]
        except (ValueError, TypeError, AttributeError, RecursionError):
            raise placed(
                FileError(said("is not what Rolamento writes there")), component, CUSTOM
            ) from None
        for place, (kind, keys) in enumerate(changes):
            part = own[place] if place < len(own) else None
            table = {} if part is None else dict(part.table)
            plain = _as_json(table)
            stale = [
                key
                for key, (was, _) in keys.items()
                if plain.get(key) != was and not self._untouched
            ]
            other_kind = part is None or part.kind != kind
            if stale:
                self._note("left", component, "rexs_changed", keys=", ".join(stale))
                if other_kind and part is not None:
                    yield part
                    continue
                if other_kind:
                    continue
            for key, (_, now) in keys.items():
                if key in stale:
                    continue
                if now is None:
                    table.pop(key, None)
                else:
                    table[key] = now
            if stale and part is not None and not is_valid(kind, table):
                table = part.table  # what is left of the keys does not go with what was changed
            if table or kind == "machine":
                yield Part(kind, component.id, table)
        yield from own[len(changes) :]


def _as_json(table: Mapping[str, Any]) -> dict[str, Any]:
    """A table as it comes back from JSON: lists instead of tuples."""
    found: dict[str, Any] = json.loads(json.dumps(table))
    return found
