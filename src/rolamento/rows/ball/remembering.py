"""A batch that reckons balls and ellipses once, for whoever asks for them again."""

from __future__ import annotations

from rolamento.contact.hertz import HertzContact
from rolamento.geometry import Race
from rolamento.rows.ball.batch_state import BatchState
from rolamento.rows.ball.detail import BallTable

__all__ = ["RememberingBatch"]


class RememberingBatch(BatchState):
    """A `BatchState` that keeps what `balls` and `contact` return: memory for time."""

    def balls(self) -> BallTable:
        """Every ball of every case, as `BatchState.balls`; kept."""
        kept = self.__dict__
        if "_balls" not in kept:
            kept["_balls"] = super().balls()
        found: BallTable = kept["_balls"]
        return found

    def contact(self, race: Race, table: BallTable | None = None) -> HertzContact:
        """Ellipse and pressure of every contact of a race, likewise; of another table anew."""
        if table is not None and table is not self.balls():
            return super().contact(race, table)
        kept = self.__dict__
        name = f"_{race}_contact"
        if name not in kept:
            kept[name] = super().contact(race, self.balls())
        found: HertzContact = kept[name]
        return found
