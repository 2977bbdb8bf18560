"""The keys of a delivery spec, table by table, and the kind of value that each holds."""

from audio_checks.metadata.layouts import LAYOUTS
from audio_checks.spec.check_names import DEFAULT_SEVERITY, LIMITS_OF_CHECKS, OVER_FILES
from audio_checks.spec.codings import CODINGS, LOSSY_ENCODINGS
from audio_checks.spec.kinds import (
    ANY,
    Flag,
    Folder,
    Kind,
    Listed,
    MetadataField,
    Named,
    Number,
    Pair,
    Rows,
    Table,
    Text,
    Whole,
    Word,
)
from audio_checks.spec.parts import NO_LIMITS, Range

RATES = Whole(1000, 768_000)
LEVEL = Word(("error", "warning", "off"))
LEVEL_OVER_FILES = Word(
    ("warning", "off"),
    (
        "error",
        "this is found over files together and returns none of them: to stop a build at it, --fail-level warning",
    ),
)

DURATION = Table({"min": Number(0.0), "max": Number(0.0)}, may_be_any=True)

ACCEPT = Table(
    {
        "containers": Listed(Word(("wav", "rf64", "flac", "ogg", "mp3"))),
        "encodings": Listed(Word(("pcm", "float", "vorbis", "opus", "mp3"))),
        "bit_rate_kbps": DURATION,
        "sample_rates_hz": Listed(RATES),
        "bit_depths": Listed(Whole(8, 64)),
        "channels": Listed(Whole(1, 64)),
        "layouts": Listed(Word(tuple(LAYOUTS))),
        "duration_s": DURATION,
    }
)
LIMITS = Table(
    {
        key: Table({"min": Number(*bounds), "max": Number(*bounds)}, may_be_any=True)
        if isinstance(getattr(NO_LIMITS, key, None), Range)
        else Number(*bounds)
        for key, bounds in LIMITS_OF_CHECKS.items()
    }
)
TOKEN = Table(
    {
        "name": Text(),
        "one_of": Listed(Text(), may_be_any=False, most=1_000),
        "pattern": Text(regex=True),
        "digits": Whole(1, 9),
        "case": Word(("lower", "upper", "capital", "any")),
        "optional": Flag(),
        "repeats": Flag(),
    },
    needed=("name",),
)
NAMING = Table(
    {
        "pattern": Text(regex=True),
        "extension": Text(),
        "tokens": Rows(TOKEN),
        "separator": Text(),
        "grammar": Word(("ucs", ANY)),
        "ucs_list": Text(),
        "ucs_ids": Listed(Text(), most=5_000),  # the system has some 750
        "portable": Flag(),
    }
)
METADATA = Table({"required": Listed(MetadataField())})
ENGINE = Table({"adds": Listed(Word(("reverb", "occlusion", "pitch", "doppler")), may_be_any=False)})
TARGET = Table(
    {
        "sample_rate_hz": RATES,
        "bit_depth": Whole(8, 64),
        "encoding": Word(("pcm", "float", *CODINGS)),
        "quality": Number(0.0, 1.0),
        "channels": Whole(1, 2, words=("master",)),
        "dither": Word(("tpdf", "shaped", "none")),
        "over_peak": Word(("attenuate", "refuse")),
        "mono_gains": Pair(Number(-4.0, 4.0, words=())),
        "chunks": Word(("sound", "all")),
        "shelf_db": Number(0.0, 6.0, words=("auto",)),
        "trim_below_dbfs": Number(-200.0, 0.0),
        "fade_in_ms": Number(0.0, 60_000.0, words=()),
        "fade_out_ms": Number(0.0, 60_000.0, words=()),
        "budget_bytes": Whole(0, 1 << 53, words=(ANY,)),
        "codec_ratio": Number(1.0, 100.0, words=()),
        "streamed": Flag(),
        "stream_buffer_bytes": Whole(0, 1 << 30),
        "folder": Folder(),
        "keep_coded": Flag(),
    }
)
CHECKS = Table({name: LEVEL_OVER_FILES if name in OVER_FILES else LEVEL for name in DEFAULT_SEVERITY})
MOST_TARGETS = 50
KIND = Word(("event", "natural-decay", "ambience", "voice", "music"))

TABLES: dict[str, Kind] = {
    "accept": ACCEPT,
    "limits": LIMITS,
    "naming": NAMING,
    "metadata": METADATA,
    "engine": ENGINE,
    "targets": Named(TARGET, most=MOST_TARGETS),
    "checks": CHECKS,
}
CATEGORY = Table({"kind": KIND, **TABLES})
SPEC = Table(
    {
        "format": Whole(1, 1),
        "name": Text(),
        "extend": Text(),
        **TABLES,
        "targets": Named(
            Table(TARGET.keys, needed=("sample_rate_hz",), needed_unless=("bit_depth", "encoding", LOSSY_ENCODINGS)),
            most=MOST_TARGETS,
        ),
        "categories": Named(CATEGORY),
        "files": Named(Text(), slugs=False, most=1_000),
    },
    needed=("format",),
)
