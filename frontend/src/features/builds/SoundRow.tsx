import { plural } from '@/ui/format'
import { StatusBadge } from '@/ui/StatusBadge'

import type { AuditSummary } from './api'
import classes from './Drift.module.css'
import type { DriftGroup } from './groups'
import { SoundDetail } from './SoundDetail'
import { faceOf, signed, describeChange } from './words'

interface SoundRowProps {
  group: DriftGroup
  audit: AuditSummary
  projectId: string
  isOpen: boolean
  onOpen: () => void
}

/** One sound, or one set that drifted alike; the selected one is open. */
export function SoundRow({ group, audit, projectId, isOpen, onOpen }: SoundRowProps) {
  const { first, sounds, name } = group
  const [move] = first.moves
  const list = move?.changelist
  return (
    <li className={`border-b ${classes.row}`} data-open={isOpen || undefined}>
      <button type="button" className={`hover ${classes.rowButton}`} aria-expanded={isOpen} onClick={onOpen}>
        <span className="cut-text">
          <span className={isOpen ? 'strong' : undefined}>{name}</span>{' '}
          <span className="small dim">{plural(sounds.length, 'file')}</span>
          {first.is_new && <span className={`small ${classes.new}`}> new</span>}
        </span>
        <StatusBadge kind={faceOf(first)}>{describeChange(first)}</StatusBadge>
        <span className="mono small cut-text">{move ? `${endOf(move.object)}, ${move.property}` : first.path}</span>
        <span className="small mid cut-text">{list ? [list.id, list.on].filter(Boolean).join(', ') : ''}</span>
        <span className={`num ${first.has_drifted ? 'strong' : ''}`}>
          {first.gain_db === null ? '' : signed(first.gain_db)}
        </span>
      </button>
      {isOpen && <SoundDetail key={audit.id} group={group} audit={audit} projectId={projectId} />}
    </li>
  )
}

/** The last two names of an object's path: the row has no room for more, and what is open shows all of it. */
const endOf = (object: string): string => {
  const names = object.split(/[\\/]/).filter(Boolean)
  return names.length > 2 ? `…\\${names.slice(-2).join('\\')}` : object
}
