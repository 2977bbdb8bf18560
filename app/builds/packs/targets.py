"""The memory of each target in the game: of the accepted sounds, and of the whole list."""

from collections.abc import Iterator
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.builds.packs.service import Pack, ensure_team_or_build, pack_of
from app.builds.schemas import MemoryByCategory, PresetRead, TargetMemory, TargetsRead
from app.projects.queries import current_spec
from app.projects.service import project_access
from app.renders.queries import parsed_spec
from app.sound_lists.queries import cues_of
from app.sound_lists.rules import CueChannels, CueState
from audio_checks import TARGET_PRESETS, DeliverySpec, SoundSize, memory_use

CHANNEL_COUNTS = {CueChannels.MONO: 1, CueChannels.STEREO: 2}


def visible_targets(session: Session, actor: Actor, project_id: UUID) -> TargetsRead:
    """Return the targets of the newest spec, and what there is to start from."""
    access = project_access(session, actor, project_id)
    ensure_team_or_build(access)
    spec = parsed_spec(current_spec(session, project_id).toml)
    return TargetsRead(
        targets=[_target_read(session, spec, pack_of(session, access.project, name)) for name in spec.targets],
        presets=[
            PresetRead(
                name=preset.name, engine=preset.engine, accepts=preset.accepts, why=preset.why, toml=preset.to_toml()
            )
            for preset in TARGET_PRESETS.values()
        ],
    )


def _target_read(session: Session, spec: DeliverySpec, pack: Pack) -> TargetMemory:
    target, preset = spec.targets[pack.target], TARGET_PRESETS.get(pack.target)
    used = list(_sizes_there(pack))
    return TargetMemory(
        name=target.name,
        engine=preset.engine if preset else None,
        accepts=preset.accepts if preset else None,
        why=preset.why if preset else None,
        sample_rate_hz=target.sample_rate_hz,
        bit_depth=target.bit_depth,
        encoding=target.encoding,
        quality=target.quality,
        channels=target.channels,
        dither=target.dither,
        folder=target.folder,
        codec_ratio=target.codec_ratio,
        streamed=target.streamed,
        used=_memory(spec, target.name, used),
        forecast=_memory(spec, target.name, [*used, *_sizes_to_come(session, pack)]),
    )


def _memory(spec: DeliverySpec, target: str, sizes: list[SoundSize]) -> MemoryByCategory:
    return MemoryByCategory.model_validate(
        {key: value for key, value in memory_use(spec, target, sizes).to_dict().items() if key != "target"}
    )


def _sizes_there(pack: Pack) -> Iterator[SoundSize]:
    """Yield the size of each game file in the pack."""
    for sound in pack.sounds:
        if sound.made:
            facts = sound.made.facts
            yield SoundSize(sound.cue.category or None, facts["duration_s"], channels=facts["channels"])


def _sizes_to_come(session: Session, pack: Pack) -> Iterator[SoundSize]:
    """Yield the sounds of the list that the pack does not have."""
    there = {sound.cue.id for sound in pack.sounds if sound.made}
    for cue in cues_of(session, pack.project.id):
        if cue.state is not CueState.CUT and cue.id not in there:
            channels = CHANNEL_COUNTS[cue.channels] if cue.channels else None
            yield SoundSize(cue.category or None, cue.duration_s, channels=channels, files=cue.variations)
