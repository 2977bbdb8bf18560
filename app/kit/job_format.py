"""How a job's arguments are stored: as JSON, so that write access to the database is no way to run code in a worker.

Each row names the format of its own arguments, and DBOS reads pickles wherever a row says so, whatever serializer
it was given. So its reader of pickles is replaced by one that accepts plain values only: it reads the jobs that an
earlier version left waiting, and refuses any pickle that names a class or a function. That reader is private, so
pyproject.toml pins one version of DBOS.
"""

import base64
import io
import pickle
from typing import Any, NoReturn

from dbos import DBOSPortableJSONSerializer
from dbos._serialization import DefaultSerializer

SERIALIZER = DBOSPortableJSONSerializer()


class _PlainValues(pickle.Unpickler):
    """Reads text, numbers, lists and mappings; refuses every name that would be looked up in a module."""

    def find_class(self, module: str, name: str) -> NoReturn:
        """Refuse a name."""
        raise pickle.UnpicklingError(f"a stored job names {module}.{name}; only plain values are read")


def _read(_serializer: DefaultSerializer, stored: str) -> Any:
    return _PlainValues(io.BytesIO(base64.b64decode(stored))).load()


def refuse_pickled_classes() -> None:
    """Have DBOS read plain values only from pickles, in this process."""
    setattr(DefaultSerializer, "deserialize", _read)  # noqa: B010  mypy refuses an assignment to a method
