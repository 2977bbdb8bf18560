"""The commands of the command line: one module each, with `add_arguments(parser)` and `run(options)`.

`run` returns the exit code. A module is imported when its command is given, so what it imports at
its top costs no other command anything.
"""
