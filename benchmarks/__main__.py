"""Speed and exactness compared with other tools, in one run: `make bench`, or `python -m benchmarks checking --quick`.

Prints Markdown and writes benchmarks/results.json. Ratios are what counts: machines are shared and noisy, so ours
and theirs take turns, and figures are medians of their runs. `--docs` writes promised figures into
docs/reference/benchmarks.md.
"""

import argparse
import json
import os
import tempfile
from importlib import import_module
from pathlib import Path

from benchmarks.rows import markdown, plain, promised
from benchmarks.tables import DOCS, machine, write_between

RESULTS = Path(__file__).with_name("results.json")
SUBJECTS = ("checking", "reading", "metering", "rendering")


def main() -> None:
    """Measure what is asked for."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks", description="Measure speed and exactness compared with other tools."
    )
    parser.add_argument("subjects", nargs="*", help=f"{', '.join(SUBJECTS)}; all without")
    parser.add_argument("--quick", action="store_true", help="fewer runs")
    parser.add_argument("--full", action="store_true", help="rendering: all 33 pairs of rates")
    parser.add_argument("--docs", action="store_true", help="write what is promised into docs/reference/benchmarks.md")
    asked = parser.parse_args()
    if unknown := set(asked.subjects) - set(SUBJECTS):
        parser.error(f"no subject {', '.join(sorted(unknown))}; there are {', '.join(SUBJECTS)}")
    results = {}
    for subject in asked.subjects or SUBJECTS:
        with tempfile.TemporaryDirectory() as folder:
            more = {"full": asked.full} if subject == "rendering" else {}
            rows = import_module(f"benchmarks.{subject}").rows(Path(folder), asked.quick, **more)
        results[subject] = plain(rows)
        measured_on = f"{machine()}; load average {os.getloadavg()[0]:.1f}."
        print(f"\n## {subject.capitalize()}\n\n{markdown(rows)}\n\n{measured_on}", flush=True)
        if asked.docs and (kept := promised(rows)):
            write_between(DOCS / "reference/benchmarks.md", subject, f"{markdown(kept)}\n\n{measured_on}")
    RESULTS.write_text(json.dumps(results, indent=1) + "\n")


if __name__ == "__main__":
    main()
