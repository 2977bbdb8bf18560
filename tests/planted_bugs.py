"""Plant bugs chosen by dice, one at a time in a copy of the tree, and name those that the tests of their room miss.

    python -m tests.planted_bugs [--each 2] [--seed 1] [--only WORD]

A bug turns a comparison round, swaps an operator, moves a number by one, or drops a refusal. What is missed is read
by a person: some changes make no difference that can be seen.
"""

import argparse
import ast
import os
import random
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
FAST = "not slow and not lint"
PARTS = {"test": FAST, "test-slow": "slow"}  # the command that catches a bug, by the marks of its tests
TESTED_BY = {
    "app/accounts/rules.py": "tests/app/accounts/test_rules.py",
    "app/agreements/plan/amounts.py": "tests/app/agreements/test_amounts.py",
    "app/agreements/plan/validation.py": "tests/app/agreements/test_plan_check.py",
    "app/amendments/offer_rules.py": "tests/app/amendments/test_offers.py tests/app/amendments/test_offer_rules.py",
    "app/amendments/rules.py": "tests/app/amendments/test_ending.py",
    "app/briefs/rules.py": "tests/app/briefs",
    "app/briefs/spec_proposal.py": "tests/app/briefs/test_spec_proposal.py",
    "app/builds/packs/zip_stream.py": "tests/app/builds/test_zip_stream.py",
    "app/cli/verifying.py": "tests/app/agreements/test_verify.py tests/app/amendments/test_tampering.py",
    "app/client/desk_servers.py": "tests/app/client/test_desk.py",
    "app/client/lock.py": "tests/app/client/test_lock.py",
    "app/client/planning.py": "tests/app/client/test_pull.py",
    "app/conformance/fixing.py": "tests/app/conformance/test_fixes.py",
    "app/dashboards/desk/own_desk.py": "tests/app/dashboards/test_own_desk.py",
    "app/dashboards/velocity/cost_rules.py": "tests/app/dashboards/test_pace_costs.py",
    "app/dashboards/rules.py": "tests/app/dashboards/test_rules.py",
    "app/deliveries/cue_counts/rules.py": "tests/app/deliveries/test_sums.py",
    "app/demo/synth.py": "tests/app/demo/test_sounds.py",
    "app/hiring/roster/rules.py": "tests/app/hiring/test_roster_rules.py",
    "app/hiring/rules.py": "tests/app/hiring",
    "app/core/money.py": "tests/app/core/test_money.py",
    "app/core/outgoing.py": "tests/app/webhooks/test_outgoing.py",
    "app/core/record.py": "tests/app/core/test_record.py",
    "app/money/estimates/rules.py": "tests/app/money/test_estimating.py",
    "app/money/work/rules.py": "tests/app/money/test_hours.py",
    "app/money/ledger/book.py": "tests/app/money/test_ledger_book.py",
    "app/notifications/rules.py": "tests/app/notifications",
    "app/operations/service.py": "tests/app/operations/test_operations.py",
    "app/projects/rules.py": "tests/app/projects/test_projects.py",
    "app/references/rules.py": "tests/app/references/test_rules.py",
    "app/renders/rules.py": "tests/app/renders/test_rules.py",
    "app/reviews/palette_fit/rules.py": "tests/app/reviews/test_fit_rules.py",
    "app/reviews/rules.py": "tests/app/reviews/test_rules.py",
    "app/scenes/rules.py": "tests/app/scenes/test_rules.py",
    "app/shares/rules.py": "tests/app/shares/test_rules.py",
    "audio_checks/spec/list_cells.py": "tests/audio_checks/spec/test_list_cells.py",
    "app/voice_lines/rules.py": "tests/app/voice_lines/test_rules.py",
    "app/webhooks/rules.py": "tests/app/webhooks/test_webhooks.py",
    "audio_checks/audio/flac.py": "tests/audio_checks/audio/test_flac.py",
    "audio_checks/audit/statuses.py": "tests/audio_checks/audit/test_audit.py",
    "audio_checks/checks/duration.py": "tests/audio_checks/checks/test_duration.py",
    "audio_checks/checks/variation_set.py": "tests/audio_checks/checks/test_variation_set.py",
    "audio_checks/cli/outputs.py": "tests/audio_checks/cli/test_measure_and_render.py",
    "audio_checks/fixing/plan.py": "tests/audio_checks/fixing/test_fix_master.py",
    "audio_checks/judge/lossy.py": "tests/audio_checks/judge/test_lossy.py",
    "audio_checks/judge/reversed.py": "tests/audio_checks/judge/test_reversed.py",
    "audio_checks/matching/reading.py": "tests/audio_checks/matching",
    "audio_checks/measure/dropouts.py": "tests/audio_checks/checks/test_dropout.py",
    "audio_checks/measure/levels.py": "tests/audio_checks/measure/test_levels.py",
    "audio_checks/measure/masking.py": "tests/audio_checks/measure/test_masking.py",
    "audio_checks/metadata/points.py": "tests/audio_checks/metadata/test_lists_and_points.py",
    "audio_checks/middleware/unity_mixers.py": "tests/audio_checks/middleware/test_levels.py",
    "audio_checks/middleware/wwise.py": "tests/audio_checks/middleware/test_wwise.py",
    "audio_checks/placeholders/make.py": "tests/audio_checks/placeholders",
    "audio_checks/render/dither.py": "tests/audio_checks/render/test_dither.py",
    "audio_checks/report/findings.py": "tests/audio_checks/report",
    "audio_checks/run/baseline.py": "tests/audio_checks/cli/test_baseline.py",
    "audio_checks/spec/keys.py": "tests/audio_checks/spec",
    "audio_checks/spec/name_tokens.py": "tests/audio_checks/spec",
    "audio_checks/system/text_files.py": "tests/audio_checks/system/test_text_files.py",
    "audio_checks/wav/reader.py": "tests/audio_checks/wav",
}
SWAPS: dict[type[ast.AST], type[ast.AST]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.Add: ast.Sub, ast.Sub: ast.Add,
    ast.Mult: ast.Div, ast.Div: ast.Mult, ast.And: ast.Or, ast.Or: ast.And,
}  # fmt: skip


def places(tree: ast.Module) -> Iterator[tuple[ast.AST, str]]:
    """Yield what can be changed inside functions, and how."""
    for function in ast.walk(tree):
        if not isinstance(function, ast.FunctionDef):
            continue
        for node in (inner for statement in function.body for inner in ast.walk(statement)):
            if isinstance(node, ast.Compare) and type(node.ops[0]) in SWAPS:
                yield node, "ops"
            elif isinstance(node, ast.BinOp | ast.BoolOp) and type(node.op) in SWAPS:
                yield node, "op"
            elif isinstance(node, ast.Constant) and type(node.value) is int:
                yield node, "value"
            elif isinstance(node, ast.If) and isinstance(node.body[0], ast.Raise):
                yield node, "test"


def plant(node: ast.AST, how: str) -> str:
    """Change one place in its tree; return what it was and became."""
    before = ast.unparse(node).splitlines()[0]
    if isinstance(node, ast.Compare):
        node.ops[0] = SWAPS[type(node.ops[0])]()  # type: ignore[assignment]
    elif isinstance(node, ast.BinOp | ast.BoolOp):
        node.op = SWAPS[type(node.op)]()  # type: ignore[assignment]
    elif isinstance(node, ast.Constant):
        node.value = int(str(node.value)) + 1
    elif isinstance(node, ast.If):
        node.test = ast.Constant(value=False)
    return f"{before}  ->  {ast.unparse(node).splitlines()[0]}"


def is_caught(copy: Path, tests: str, marked: str) -> bool:
    """Return whether one of these tests, of those that are marked so, fails on the copy."""
    options = ["-n", "0", "-x", "-q", "-p", "no:cacheprovider", "--timeout", "900"]
    command = [sys.executable, "-m", "pytest", *options, "-m", marked, *tests.split()]
    environment = os.environ | {"PYTHONPATH": str(copy)}
    ended = subprocess.run(command, cwd=copy, env=environment, capture_output=True).returncode
    return ended not in {0, pytest.ExitCode.NO_TESTS_COLLECTED}


def main() -> None:
    """Plant, test, put back, and print a line for each."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--each", type=int, default=2, help="bugs in each module")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="modules whose path has this")
    options = parser.parse_args()
    results = Counter[str]()
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "tree"
        left_out = shutil.ignore_patterns(".git", ".venv", "node_modules", "data", "build", "__pycache__")
        shutil.copytree(ROOT, copy, ignore=left_out, symlinks=True)
        (copy / ".venv").symlink_to(ROOT / ".venv")
        (copy / "frontend/node_modules").symlink_to(ROOT / "frontend/node_modules")
        for name, tests in TESTED_BY.items():
            if options.only not in name:
                continue
            if is_caught(copy, tests, FAST):
                print(f"{tests} fails as it is; {name} is left out", flush=True)
                continue
            source = (copy / name).read_text(encoding="utf-8")
            count = len(list(places(ast.parse(source))))
            dice = random.Random(f"{options.seed} {name}")
            for chosen in sorted(dice.sample(range(count), min(options.each, count))):
                tree = ast.parse(source)
                node, how = list(places(tree))[chosen]
                line, change = getattr(node, "lineno", 0), plant(node, how)
                (copy / name).write_text(ast.unparse(ast.fix_missing_locations(tree)), encoding="utf-8")
                result = next((part for part, marked in PARTS.items() if is_caught(copy, tests, marked)), "MISSED")
                (copy / name).write_text(source, encoding="utf-8")
                results[result] += 1
                print(f"{result:9}  {name}:{line}  {change}", flush=True)
    print(f"of {results.total()} bugs: " + ", ".join(f"{part} {results[part]}" for part in [*PARTS, "MISSED"]))


if __name__ == "__main__":
    main()
