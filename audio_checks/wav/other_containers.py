"""A file's possible content in place of PCM in a WAV file, by its first bytes or by its codec's tag."""

EXPORT_WAV = "export it from your audio editor as WAV (PCM); renaming a file does not convert it"
CODECS = {
    0x0002: "Microsoft ADPCM",
    0x0006: "A-law",
    0x0007: "µ-law",
    0x0011: "IMA ADPCM",
    0x0031: "GSM 6.10",
    0x0050: "MPEG audio",
    0x0055: "MP3",
    0x0069: "Xbox ADPCM",
    0x0092: "Dolby AC-3",
    0x00FF: "AAC",
    0x0161: "Windows Media Audio",
    0x0162: "Windows Media Audio Professional",
    0x0163: "Windows Media Audio Lossless",
    0x0270: "ATRAC3",
    0x566F: "Vorbis",
    0x676F: "Vorbis",
    0xF1AC: "FLAC",
}

# Bytes at the start of what is not a WAV file: (offset, bytes, code, name)
OTHER_CONTAINERS = (
    (0, b"version https://git-lfs", "git-lfs-pointer", "a Git LFS pointer, a text in place of the real file"),
    (0, b"RIFX", "rifx", "RIFX (big-endian RIFF)"),
    (0, b"BW64", "bw64", "BW64"),
    (0, b"riff\x2e\x91\xcf\x11", "w64", "Sony Wave64 (W64)"),
    (0, b"fLaC", "flac", "FLAC"),
    (0, b"OggS", "ogg", "Ogg (Vorbis, Opus or FLAC)"),
    (0, b"FORM", "aiff", "AIFF"),
    (0, b".snd", "au", "AU"),
    (0, b"caff", "caf", "Core Audio (CAF)"),
    (0, b"ID3", "mp3", "MP3 (it starts with an ID3 tag)"),
    (4, b"ftyp", "mp4", "MP4 or M4A"),
    (0, b"\x1aE\xdf\xa3", "matroska", "Matroska or WebM"),
    (0, b"0&\xb2u\x8ef\xcf\x11", "asf", "Windows Media (ASF)"),
    (0, b"wvpk", "wavpack", "WavPack"),
    (0, b"MAC ", "ape", "Monkey's Audio"),
    (0, b"MThd", "midi", "MIDI"),
    (0, b"DSD ", "dsf", "DSD"),
    (0, b"PK\x03\x04", "zip", "a ZIP archive"),
    (0, b"\x1f\x8b", "gzip", "a gzip archive"),
    (0, b"%PDF", "pdf", "a PDF"),
    (0, b"<!DOCTYPE", "html", "a web page"),
    (0, b"<html", "html", "a web page"),
)
