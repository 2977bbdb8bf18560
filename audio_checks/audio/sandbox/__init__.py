"""Calls in a throw-away child: what it does to itself, the caller survives.

On POSIX a small server process, warm with the modules that calls need, forks one child for each
call, or for a few calls that belong together, limits it, watches it and reaps it. Where there is no
fork, each call gets a new interpreter with a time limit alone.
"""

from audio_checks.audio.sandbox.answers import ensure_declared, returned_type
from audio_checks.audio.sandbox.calls import Sandbox, SandboxChild
from audio_checks.audio.sandbox.child import is_inside
from audio_checks.audio.sandbox.confinement import gaps as confinement_gaps

__all__ = [
    "Sandbox",
    "SandboxChild",
    "confinement_gaps",
    "ensure_declared",
    "is_inside",
    "returned_type",
]
