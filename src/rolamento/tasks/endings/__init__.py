"""What may end a bearing: a file an ending, all of them named once, in `laws`."""

from rolamento.tasks.endings.ending import Ending, EndingLaw
from rolamento.tasks.endings.laws import ENDINGS

__all__ = ["ENDINGS", "Ending", "EndingLaw"]
