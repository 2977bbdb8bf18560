"""The version of the tool: two versions may judge one file differently, so every report names it."""

TOOL_VERSION = "0.1.0"
