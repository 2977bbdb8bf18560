"""What is found in a file's name alone, before there is a file."""

from __future__ import annotations

from audio_checks.checks import all_checks
from audio_checks.report.findings import Finding
from audio_checks.run.severity import graded, ordered
from audio_checks.spec.delivery_spec import DeliverySpec


def check_name(name: str, spec: DeliverySpec) -> tuple[Finding, ...]:
    """Return what `naming` finds in a name, each with its severity, as the report on a file of this name has it.

    Parameters
    ----------
    name : str
        A file name without folders.
    spec : DeliverySpec
        The view that the file is judged by.
    """
    naming = all_checks()["naming"]
    if spec.checks.get("naming") == "off" or not naming.applies(spec, None):
        return ()
    found = (graded(one, spec) for one in naming.module.of_name(name, spec))
    return ordered(one for one in found if one is not None)
