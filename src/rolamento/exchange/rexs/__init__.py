"""REXS, FVA's exchange format of gear units: `files`, the `model`, and machines from and to it.

https://www.rexs.info; the names of attributes, units and bearing types are those of REXS 1.0 to
2.0, (c) FVA GmbH, published under the Apache License 2.0.
"""

from __future__ import annotations

from rolamento.exchange.rexs.files import (
    check_ending,
    parse_rexs,
    read_rexs,
    rexs_bytes,
    write_rexs,
)
from rolamento.exchange.rexs.model import (
    Attribute,
    Component,
    LoadCase,
    Ref,
    Relation,
    RexsModel,
)
from rolamento.exchange.rexs.reading import Imported, Remark, machine_of_rexs
from rolamento.exchange.rexs.writing import Exported, rexs_of_machine

__all__ = [
    "Attribute",
    "Component",
    "Exported",
    "Imported",
    "LoadCase",
    "Ref",
    "Relation",
    "Remark",
    "RexsModel",
    "check_ending",
    "machine_of_rexs",
    "parse_rexs",
    "read_rexs",
    "rexs_bytes",
    "rexs_of_machine",
    "write_rexs",
]
