"""What a render may be and what tells one from another, stated without a database."""

import hashlib
import json
from dataclasses import asdict
from enum import StrEnum

from audio_checks import DeliverySpec, Target

RENDERER_VERSION = "1"  # changes when the same master would give other bytes


class RenderState(StrEnum):
    """Whether the game file exists."""

    MADE = "made"
    REFUSED = "refused"


def render_key(
    master_sha256: str,
    target: Target,
    *,
    loop: bool,
    sample_peak_limit_dbfs: float | None,
    true_peak_limit_dbtp: float | None,
) -> str:
    """Return what tells one render from another: equal keys are equal bytes.

    A master's own loop points are part of the master, so its hash stands for them.
    """
    facts = {
        "master": master_sha256,
        "target": asdict(target),
        "loop": loop,
        "sample_peak_limit_dbfs": sample_peak_limit_dbfs,
        "true_peak_limit_dbtp": true_peak_limit_dbtp,
        "renderer": RENDERER_VERSION,
    }
    return hashlib.sha256(json.dumps(facts, sort_keys=True).encode()).hexdigest()


def render_keys(spec: DeliverySpec, master_sha256: str, *, category: str, loop: bool) -> dict[str, str]:
    """Return the key of each render that a spec wants of a master, by target."""
    view = spec.for_category(category or None)
    return {
        name: render_key(
            master_sha256,
            target,
            loop=loop,
            sample_peak_limit_dbfs=view.limits.sample_peak_dbfs,
            true_peak_limit_dbtp=view.limits.true_peak_dbtp,
        )
        for name, target in view.targets.items()
    }
