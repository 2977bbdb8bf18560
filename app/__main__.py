"""`python -m app` is `soundlist`."""

from app.cli import main

main()
