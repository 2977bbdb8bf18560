"""`python -m soundlist` is `soundlist`."""

from soundlist import main

main()
