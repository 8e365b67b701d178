"""Public names of `rna_sdk.motion`."""

from .binding import Binding as Binding
from .binding import bind as bind
from .motion_file import Motion as Motion
from .motion_file import MotionFile as MotionFile
from .motion_file import open_motion as open_motion
from .motion_file import write_motion as write_motion
