"""Errors of a file, a spec, a render or a sandboxed call, each named after the fact."""

from __future__ import annotations

from collections.abc import Sequence


class AudioChecksError(Exception):
    """Anything that audio_checks reports about what it was given."""

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""


class Unreadable(AudioChecksError):
    """A file that breaks one of the structure rules R1-R7, R11 or R12.

    Parameters
    ----------
    message : str
        What was found and what was wanted, for a sound designer.
    rule : str
        "R1" … "R12".
    code : str
        Stable name of the condition, such as "structure:truncated" or "container:mp3".
    fix : str
        How to fix it.
    """

    def __init__(self, message: str, rule: str, code: str, fix: str) -> None:
        super().__init__(message, rule, code, fix)
        self.rule = rule
        self.code = code
        self.fix = fix


class SpecError(AudioChecksError):
    """A spec or a sound list that cannot be understood.

    Parameters
    ----------
    message : str
        What is wrong.
    where : str
        The file, row or dotted key it was found at; empty when the whole is meant.
    """

    def __init__(self, message: str, where: str = "") -> None:
        super().__init__(message, where)
        self.where = where


class SpecErrors(SpecError):
    """A spec in which several things are wrong; it says them all.

    Parameters
    ----------
    errors : sequence of SpecError
        Two or more, each with its place.
    """

    def __init__(self, errors: Sequence[SpecError]) -> None:
        self.errors = tuple(errors)
        first = self.errors[0]
        more = [f"{error.where}: {error}" if error.where else str(error) for error in self.errors[1:]]
        super().__init__("\n".join([str(first), *more]), first.where)

    def __reduce__(self) -> tuple[type[SpecErrors], tuple[tuple[SpecError, ...]]]:
        return SpecErrors, (self.errors,)


class _Refusal(AudioChecksError):
    """A request that is not carried out.

    Parameters
    ----------
    message : str
        What was asked or found, and why nothing is done.
    code : str
        Stable name of the condition, such as "render:upwards", "fix:over-master" or "split:one-sound".
    fix : str
        What to do instead.
    """

    def __init__(self, message: str, code: str, fix: str) -> None:
        super().__init__(message, code, fix)
        self.code = code
        self.fix = fix


class RenderRefused(_Refusal):
    """A render that would harm the sound, such as one to a higher rate than its master's."""


class FixRefused(_Refusal):
    """A fix that cannot be made without harm, such as one that would overwrite its master."""


class SplitRefused(_Refusal):
    """A split of a master that cannot be made, such as one of a file that holds one sound."""


class SandboxFailed(AudioChecksError):
    """A sandboxed call that gave no result; never the file's fault in itself.

    Parameters
    ----------
    message : str
        What happened to the child.
    detail : str
        The child's traceback, when it had one to give.
    """

    def __init__(self, message: str, detail: str = "") -> None:
        super().__init__(message, detail)
        self.detail = detail


class SandboxTimedOut(SandboxFailed):
    """The call took longer than its sandbox allows."""


class SandboxOutOfMemory(SandboxFailed):
    """The call wanted more memory than its sandbox allows."""


class SandboxCrashed(SandboxFailed):
    """The child died, or raised something other than an AudioChecksError.

    Parameters
    ----------
    message, detail : str
        As for SandboxFailed.
    signal : int or None
        The signal that ended the child; None when it ended by itself.
    """

    def __init__(self, message: str, detail: str = "", signal: int | None = None) -> None:
        super().__init__(message, detail)
        self.args = (message, detail, signal)
        self.signal = signal
