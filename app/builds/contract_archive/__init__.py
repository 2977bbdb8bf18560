"""An ended contract's handover to the next designer."""
