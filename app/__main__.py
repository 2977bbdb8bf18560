"""`python -m app` is `soundlist`."""

import sys


def run() -> None:
    """Run the command line; the client's commands start without loading what a server needs."""
    if sys.argv[1:2] in (["pull"], ["why"], ["desk"]):
        from app.client.commands import main as run_client

        sys.exit(run_client(sys.argv[1:]))
    from app.cli import main as run_server

    run_server()


run()
