"""The version of the tool: two versions may judge one file differently, so every report names it."""

try:
    from audio_checks._version import VERSION as TOOL_VERSION  # written where the package is built, from the tag
except ImportError:  # a checkout that was never installed
    TOOL_VERSION = "0.0.0"

__all__ = ["TOOL_VERSION"]
