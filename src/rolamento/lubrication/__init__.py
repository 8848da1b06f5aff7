"""The lubricant film between elements and races, and what it means for the surfaces.

`film` of solved cases. Inside: `films` (the record, and how it is put together), `film_thickness`
(a model a function: Hamrock and Dowson, inlet heat, starvation), `regime` (what to expect of the
surfaces), `roughness` (of a measured profile), `notes`, `film_control` (the film in the balance of
the balls).
"""

from rolamento.lubrication.films import ContactFilms, Film, film

__all__ = ["ContactFilms", "Film", "film"]
