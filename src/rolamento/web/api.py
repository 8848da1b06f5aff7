"""The HTTP API: what a program asks, under ``/api/v1``."""

from __future__ import annotations

from typing import Final

from fastapi import APIRouter
from starlette.requests import Request
from starlette.responses import Response

import rolamento
from rolamento.web.answers import answer

__all__ = ["router"]

router: Final = APIRouter(prefix="/api/v1")


@router.get("/ready")
async def ready(request: Request) -> Response:
    """Tell whether the first request need not wait."""
    return answer(request.app.state.warmth.to_mapping())


@router.get("/version")
async def version() -> Response:
    """Tell the version."""
    return answer({"version": rolamento.__version__})
