"""A ball on a groove: the elliptical Hertz contact, and the stresses beneath it."""
