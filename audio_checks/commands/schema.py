"""`audio-checks schema`: the JSON Schema of the spec or of the report."""

import argparse
import json

from audio_checks import findings, spec
from audio_checks.arguments import OK

SCHEMAS = {"spec": spec.schema, "report": findings.schema}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the name of a document."""
    parser.add_argument("document", choices=tuple(SCHEMAS), help="the document that the schema is of")


def run(options: argparse.Namespace) -> int:
    """Print the schema."""
    print(json.dumps(SCHEMAS[options.document](), indent=2))
    return OK
