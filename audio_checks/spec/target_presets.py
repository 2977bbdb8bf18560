"""Targets to start from: what each engine is best handed, and what it takes."""

from dataclasses import dataclass


@dataclass(frozen=True)
class TargetPreset:
    """A target for one engine.

    Attributes
    ----------
    name : str
        What the target is called in a spec.
    engine : str
        Whom it is for.
    accepts : str
        What the engine imports, by its manual.
    why : str
        Why the target is as it is.
    sample_rate_hz, bit_depth : int
        What is handed over.
    keys : str
        The rest of the target's table, as TOML.
    """

    name: str
    engine: str
    accepts: str
    why: str
    sample_rate_hz: int
    bit_depth: int
    keys: str

    def to_toml(self) -> str:
        """Return the target's table, commented."""
        return (
            f"[targets.{self.name}]\n# {self.engine} accepts {self.accepts}.\n# {self.why}\n"
            f"sample_rate_hz = {self.sample_rate_hz}\nbit_depth = {self.bit_depth}\n{self.keys}"
        )


TARGET_PRESETS = {
    preset.name: preset
    for preset in (
        TargetPreset(
            "wwise",
            "Wwise",
            "WAV of 16 or 24 bit (32-bit float becomes 24) up to 96 kHz, mono to 7.1 and more by channel mask",
            "It converts for each platform itself, so it gets the whole quality, untouched.",
            48_000,
            24,
            'channels = "master"\ndither = "none"\ncodec_ratio = 4.0        # ADPCM; Vorbis or Opus about 10\n',
        ),
        TargetPreset(
            "fmod",
            "FMOD Studio",
            "WAV, AIFF, FLAC, Ogg Vorbis and MP3, WAV of 16 or 24 bit at any rate, mono to 7.1",
            "It converts for each platform when banks are built, so it gets the whole quality, untouched.",
            48_000,
            24,
            'channels = "master"\ndither = "none"\ncodec_ratio = 10.0       # Vorbis; FADPCM about 4\n',
        ),
        TargetPreset(
            "unreal",
            "Unreal Engine",
            "WAV of 16 or 24 bit at any rate, mono, stereo, 4.0, 5.1 and 7.1",
            "It makes 16 bit of everything, without dither: so 16 bit is made here, with it.",
            48_000,
            16,
            'channels = "master"\ndither = "tpdf"\ncodec_ratio = 10.0       # Bink Audio; ADPCM 4\n',
        ),
        TargetPreset(
            "unity",
            "Unity",
            "WAV, AIFF, Ogg Vorbis and MP3 of up to 8 channels",
            "Its own mono changes the level (Normalize): so mono is made here, at stated gains.",
            48_000,
            16,
            "channels = 1             # stereo beds: a category with channels = 2\n"
            'mono_gains = [0.5, 0.5]  # of left and right\ndither = "tpdf"\n'
            "codec_ratio = 3.5        # ADPCM; Vorbis about 10\n",
        ),
        TargetPreset(
            "raw",
            "In-house engine",
            "ask its programmers; nearly all read plain 16-bit WAV",
            "PCM as it is, resident in memory.",
            44_100,
            16,
            'channels = "master"\ndither = "tpdf"\ncodec_ratio = 1.0\n',
        ),
    )
}
"""By name."""
