"""Friction of rolling bearings: slip inside the contacts, torque, power and heat.

From the inside out: `slip` (velocity at every point of a contact), `traction` (integrals of
friction over a contact), `closed_forms` (spin, Heathcote slip, hysteresis), `minimum_power` (how a
ball moves where friction alone decides), `rolling_resistance` (the oil at the inlets),
`line_losses` (of the lines of contact of rollers), `coefficient` (of friction by the regime of
lubrication); `model` (what a torque model is), a file a
model: `jones_full`, `jones_control`, `jones_simplified`, `harris_1971`, `todd` for balls with dry
and boundary friction at low speed, `rollers`, and `palmgren`, `skf` for lubricated machine
bearings, all listed in `models`; `bounds` (where the torque is an upper bound), `summary` (all of
it).
"""

from rolamento.friction.machine import MachineBearing, machines_of
from rolamento.friction.model import ContactLoss, ModelValidity, Torque, TorqueModel
from rolamento.friction.models import CONTACT_MODELS, ROLLER_MODEL, TORQUE_MODELS
from rolamento.friction.summary import Friction, friction

__all__ = [
    "CONTACT_MODELS",
    "ROLLER_MODEL",
    "TORQUE_MODELS",
    "ContactLoss",
    "Friction",
    "MachineBearing",
    "ModelValidity",
    "Torque",
    "TorqueModel",
    "friction",
    "machines_of",
]
