"""`audio-checks schema`: the JSON Schema of a document: spec, report, manifest, audit."""

import argparse
import json

from audio_checks.audit import manifest
from audio_checks.audit import report as audit
from audio_checks.cli.arguments import OK
from audio_checks.report import findings
from audio_checks.spec import delivery_spec as spec

SCHEMAS = {
    "spec": spec.schema,
    "report": findings.schema,
    "manifest": manifest.schema,
    "audit": audit.schema,
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the name of a document."""
    parser.add_argument("document", choices=tuple(SCHEMAS), help="the document that the schema is of")


def run(options: argparse.Namespace) -> int:
    """Print the schema."""
    print(json.dumps(SCHEMAS[options.document](), indent=2))
    return OK
