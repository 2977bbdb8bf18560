"""Words in the names of files that say nothing about the sound, and short words that do."""

# The state of the work. A number attached to one of them belongs to it: FINAL2.
STATE_WORDS = frozenset(
    {"approved", "bounce", "bounced", "draft", "edited", "export", "exported", "final", "finalfinal", "finished"}
    | {"fixed", "latest", "master", "mastered", "mixdown", "newest", "rendered", "render", "revised", "tmp", "wip"}
)
# The state of the work where they are shouted or follow such a word; part of the sound's name elsewhere: menu_new.
WEAK_STATE_WORDS = frozenset(
    {"done", "edit", "fix", "last", "mix", "new", "ok", "old", "print", "raw", "rough", "temp", "test", "update", "use"}
)
VERSION_WORDS = frozenset({"v", "ver", "vers", "version", "rev", "revision"})
TAKE_WORDS = frozenset({"take", "tk"})
COPY_WORDS = frozenset({"copy", "kopie", "copie", "copia", "duplicate"})
ALTERNATE_WORDS = frozenset({"alt", "alternate", "alternative", "option", "opt"})
FORMAT_WORDS = frozenset({"wav", "wave", "aif", "aiff", "flac", "ogg", "mp3", "mono", "stereo"})
# Part of the format behind one: 48k_ST, 32bit_float.
NEAR_FORMAT_WORDS = frozenset({"st", "ste", "mo", "float", "fp", "int", "interleaved", "bwf"})
UNITS = frozenset({"k", "khz", "hz", "bit", "b", "bits", "bpm", "db", "dbfs", "dbtp", "lufs", "ch"})
PREFIX_WORDS = frozenset({"sfx", "fx", "snd", "aud", "audio"})
MONTHS = {
    "jan": 1,
    "feb": 2,
    "mar": 3,
    "apr": 4,
    "may": 5,
    "jun": 6,
    "jul": 7,
    "aug": 8,
    "sep": 9,
    "oct": 10,
    "nov": 11,
    "dec": 12,
}

# Short words without a vowel that describe a sound or say whose it is: never a person's initials.
NO_INITIALS = frozenset(
    {"bck", "bg", "bgm", "blk", "btn", "bwd", "chr", "clk", "crtr", "dn", "dr", "drt", "ft", "fwd", "fx", "gls", "gn"}
    | {"gr", "grn", "grnd", "grs", "hd", "hp", "hr", "hvr", "hvy", "lft", "lg", "lght", "lng", "lo", "lp", "lr", "lrg"}
    | {"md", "med", "mdm", "mt", "mtl", "mvmt", "npc", "pl", "plr", "ply", "pnt", "pt", "rf", "rght", "rgt", "rk"}
    | {"rn", "rr", "rt", "shrt", "sft", "slw", "sm", "sml", "snd", "snw", "sp", "st", "stn", "str", "sw", "tnk", "trn"}
    | {"vfx", "vh", "vhcl", "vl", "vo", "wd", "wk", "wlk", "wpn", "wtr", "xl", "xs", "xxl"}
)
# Words that distinguish similar sounds: never the prefix of a project.
QUALITIES = frozenset(
    {
        "a",
        "alien",
        "back",
        "bad",
        "bass",
        "big",
        "black",
        "blue",
        "boss",
        "bottom",
        "bright",
        "broken",
        "cheap",
        "clean",
    }
    | {"close", "closed", "cold", "dark", "dead", "deep", "distant", "double", "down", "dry", "early", "empty", "end"}
    | {"enemy", "evil", "exit", "extra", "far", "fast", "female", "first", "front", "full", "giant", "gold", "good"}
    | {
        "great",
        "green",
        "hard",
        "heavy",
        "hi",
        "high",
        "hot",
        "huge",
        "in",
        "indoor",
        "inner",
        "inside",
        "iron",
        "large",
    }
    | {"late", "left", "light", "little", "lo", "long", "loop", "loud", "low", "main", "male", "medium", "metal", "mid"}
    | {"mini", "monster", "muffled", "multi", "near", "no", "non", "npc", "off", "on", "one", "open", "out", "outdoor"}
    | {"outer", "outside", "over", "player", "plastic", "power", "quick", "quiet", "re", "rear", "red", "reverse"}
    | {
        "right",
        "rock",
        "second",
        "sharp",
        "short",
        "side",
        "silent",
        "single",
        "slow",
        "small",
        "soft",
        "start",
        "steel",
    }
    | {
        "stone",
        "stop",
        "strong",
        "sub",
        "super",
        "tail",
        "thick",
        "thin",
        "tiny",
        "top",
        "triple",
        "two",
        "ui",
        "ultra",
    }
    | {
        "un",
        "under",
        "up",
        "vehicle",
        "vo",
        "warm",
        "water",
        "weak",
        "weapon",
        "wet",
        "white",
        "wide",
        "wood",
        "wooden",
    }
    | {"wrong", "young", "yellow", "zombie"}
)

# How the ids of the Universal Category System begin; a subcategory follows: UIClick, AMBForst.
UCS_CATEGORIES = frozenset(
    [
        "AERO",
        "AIR",
        "ALRM",
        "AMB",
        "ANML",
        "ARCH",
        "BEEP",
        "BELL",
        "BIRD",
        "BLLT",
        "BOAT",
        "BOTL",
        "CERM",
        "CHAIN",
        "CHEM",
        "CLOCK",
        "CLOTH",
        "CMPT",
        "COMM",
        "CREA",
        "CRWD",
        "DEST",
        "DIRT",
        "DOOR",
        "DRWR",
        "DSGN",
        "ELEC",
        "EQUIP",
        "EXPL",
        "FART",
        "FEET",
        "FGHT",
        "FIRE",
        "FOLY",
        "FOOD",
        "FRWK",
        "GAME",
        "GLAS",
        "GORE",
        "GUN",
        "HMN",
        "HORN",
        "ICE",
        "LASR",
        "LETHR",
        "LIQD",
        "MACH",
        "MAGC",
        "MECH",
        "METL",
        "MOTR",
        "MUSC",
        "MVMT",
        "OBJ",
        "PAPR",
        "PLAS",
        "RAIN",
        "ROBT",
        "ROCK",
        "ROPE",
        "RUBR",
        "SCI",
        "SNOW",
        "SPRT",
        "SWSH",
        "TOOL",
        "TOON",
        "TOY",
        "TRN",
        "UI",
        "VEGE",
        "VEH",
        "VOX",
        "WATR",
        "WEAP",
        "WHST",
        "WIND",
        "WING",
        "WNDW",
        "WOOD",
        "WTHR",
    ]
)
