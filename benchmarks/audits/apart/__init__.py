"""Projects kept apart from the readers: written from the formats alone, with what the first projects do not have.

Each is written from the gains of its places, with the sounds that each place moves and what their level depends on.
"""

from benchmarks.audits.apart.fmod import FMOD
from benchmarks.audits.apart.godot import GODOT
from benchmarks.audits.apart.unity import UNITY
from benchmarks.audits.apart.unreal import UNREAL
from benchmarks.audits.apart.wwise import WWISE

APART = {"wwise": WWISE, "fmod": FMOD, "unity": UNITY, "unreal": UNREAL, "godot": GODOT}
