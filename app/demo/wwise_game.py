"""A small project of Wwise that plays the demo's approved sounds, and the audit of it that the game's CI would run."""

import re
import shutil
import subprocess
from collections import defaultdict
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from uuid import NAMESPACE_OID, uuid5

import audio_checks

MASTER = "{1514A4D8-1DA6-412A-A17E-75CA0C2149F3}"  # the master bus of every project
BUS = "Effects"
GIT = (
    "git",
    "-c",
    "user.name=Programmer",
    "-c",
    "user.email=programmer@soundlist.example",
    "-c",
    "commit.gpgsign=false",
)


def write_game(root: Path, sounds: Mapping[str, bytes], volumes_db: Mapping[str, float]) -> Path:
    """Write the project: a container for each set with its volume, an event that plays it, one bus; return its file."""
    for name, content in sounds.items():
        path = root / "Originals" / "SFX" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    sets: dict[str, list[str]] = defaultdict(list)
    for name in sorted(sounds):
        sets[re.sub(r"_\d\d$", "", Path(name).stem)].append(name)
    project = root / "Shield Wing.wproj"
    project.write_text(
        '<?xml version="1.0" encoding="utf-8"?>\n'
        '<WwiseDocument Type="Project" SchemaVersion="110" WwiseVersion="v2022.1.3"/>\n'
    )
    mixer = (
        f'<ActorMixer Name="Sounds" ID="{_id("mixer")}">\n{_reference("OutputBus", _id("bus"), BUS)}<ChildrenList>\n'
        + "".join(_container(name, files, volumes_db.get(name)) for name, files in sets.items())
        + "</ChildrenList>\n</ActorMixer>\n"
    )
    buses = (
        f'<Bus Name="Master Audio Bus" ID="{MASTER}">\n<ChildrenList>\n'
        f'<Bus Name="{BUS}" ID="{_id("bus")}">\n</Bus>\n</ChildrenList>\n</Bus>\n'
    )
    _put(root, "Actor-Mixer Hierarchy", "AudioObjects", mixer)
    _put(root, "Master-Mixer Hierarchy", "Busses", buses)
    _put(root, "Events", "Events", "".join(_event(name) for name in sets))
    return project


def commit_game(root: Path, subject: str) -> None:
    """Keep the state of the project in Git, where that is installed, so that an audit names the change."""
    if shutil.which("git") is None:
        return
    for command in (("init", "-q"), ("add", "-A"), ("commit", "-q", "-m", subject)):
        subprocess.run([*GIT, *command], cwd=root, check=True, capture_output=True)


def audit_game(manifest: Path, project: Path) -> dict[str, Any]:
    """Return the report of `audio-checks audit --manifest … --project …`."""
    approved = audio_checks.read_manifest(manifest)
    folder = project.parent / "Originals"
    files = [(str(path), path.relative_to(folder).as_posix()) for path in sorted(folder.rglob("*.wav"))]
    audit = audio_checks.audit_build(approved, audio_checks.fingerprint_files(files), by_ends=True)
    return audio_checks.with_project(audit, approved, audio_checks.read_project(project)).to_dict()


def _container(name: str, files: list[str], volume_db: float | None) -> str:
    volume = (
        '<PropertyList>\n<Property Name="Volume" Type="Real64"><ValueList><Value>'
        f"{volume_db:g}</Value></ValueList></Property>\n</PropertyList>\n"
        if volume_db is not None
        else ""
    )
    held = "".join(
        f'<Sound Name="{Path(file).stem}" ID="{_id("sound", file)}">\n<ChildrenList>\n'
        f'<AudioFileSource Name="{Path(file).stem}" ID="{_id("source", file)}">\n<Language>SFX</Language>\n'
        f"<AudioFile>{file.replace('/', chr(92))}</AudioFile>\n</AudioFileSource>\n</ChildrenList>\n</Sound>\n"
        for file in files
    )
    return (
        f'<RandomSequenceContainer Name="{name}" ID="{_id("container", name)}">\n{volume}<ChildrenList>\n{held}'
        "</ChildrenList>\n</RandomSequenceContainer>\n"
    )


def _event(name: str) -> str:
    return (
        f'<Event Name="Play_{name}" ID="{_id("event", name)}">\n<ChildrenList>\n'
        f'<Action Name="" ID="{_id("action", name)}">\n{_reference("Target", _id("container", name), name)}</Action>\n'
        "</ChildrenList>\n</Event>\n"
    )


def _reference(name: str, id_: str, what: str) -> str:
    return (
        f'<ReferenceList>\n<Reference Name="{name}">\n<ObjectRef Name="{what}" ID="{id_}"/>\n</Reference>\n'
        "</ReferenceList>\n"
    )


def _put(root: Path, folder: str, category: str, body: str) -> None:
    id_ = _id("unit", category)
    path = root / folder / "Default Work Unit.wwu"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(
        f'<?xml version="1.0" encoding="utf-8"?>\n<WwiseDocument Type="WorkUnit" ID="{id_}" SchemaVersion="110">\n'
        f'<{category}>\n<WorkUnit Name="Default Work Unit" ID="{id_}" PersistMode="Standalone">\n<ChildrenList>\n'
        f"{body}</ChildrenList>\n</WorkUnit>\n</{category}>\n</WwiseDocument>\n"
    )


def _id(*names: str) -> str:
    return f"{{{str(uuid5(NAMESPACE_OID, '/'.join(names))).upper()}}}"
