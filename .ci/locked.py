#!/usr/bin/env python3
"""Print packages of uv.lock as pip's requirements with their hashes: what has to be there before uv is."""

import sys
import tomllib
from pathlib import Path

LOCK = tomllib.loads((Path(__file__).parent.parent / "uv.lock").read_text(encoding="utf-8"))

for name in sys.argv[1:]:
    (package,) = [package for package in LOCK["package"] if package["name"] == name]
    hashes = "".join(f" --hash={wheel['hash']}" for wheel in package["wheels"])
    sys.stdout.write(f"{name}=={package['version']}{hashes}\n")
