"""The corpus that detectors of faults are evaluated on: sounds, injuries, what each detector promises."""
