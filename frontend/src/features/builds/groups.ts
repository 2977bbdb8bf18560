import type { AuditedSound } from './api'

/** Sounds of one cue that drifted alike: they are decided together. */
export interface DriftGroup {
  key: string
  name: string
  first: AuditedSound
  sounds: readonly AuditedSound[]
}

const nameOf = ({ cue, path }: AuditedSound): string => cue?.name ?? path.split('/').at(-1) ?? path

const alikeOf = (sound: AuditedSound): string =>
  JSON.stringify([
    sound.cue?.id ?? sound.path,
    sound.status,
    sound.played_status,
    sound.gain_db === null ? '' : sound.gain_db.toFixed(1),
    sound.moves[0] ? `${sound.moves[0].object} ${sound.moves[0].property}` : '',
    sound.accepted ? sound.accepted.reason : '',
    sound.task_id === null ? '' : 'sent back',
  ])

/** Group sounds in the order in which they come. */
export function groupsOf(sounds: readonly AuditedSound[]): DriftGroup[] {
  const groups = new Map<string, AuditedSound[]>()
  for (const sound of sounds) {
    const key = alikeOf(sound)
    groups.set(key, [...(groups.get(key) ?? []), sound])
  }
  return [...groups].flatMap(([key, own]) => {
    const [first] = own
    return first ? [{ key, name: nameOf(first), first, sounds: own }] : []
  })
}
