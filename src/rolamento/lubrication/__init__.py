"""The lubricant film between balls and races, and what it means for the surfaces.

`film_of` for a state, `film_of_batch` for many cases at once. From the outside in: `film` and
`record` (one state), `table` (a batch), `contact_film` (one race), `running` (what is read of the
balls), `entrainment`, `film_thickness`, `thermal`, `starvation` (a model a function), `oil_state`
(the oil at its temperature), `viscosity_ratio`, `regime`, `roughness` (of a measured profile).
"""

from rolamento.lubrication.film import film_of
from rolamento.lubrication.record import BallFilm, ContactFilm, Film
from rolamento.lubrication.table import FilmTable, film_of_batch

__all__ = ["BallFilm", "ContactFilm", "Film", "FilmTable", "film_of", "film_of_batch"]
