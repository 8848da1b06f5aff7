"""Balls on other grooves: two arcs a ring, washers, a sphere as outer race."""
