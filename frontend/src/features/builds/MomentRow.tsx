import { TextInput } from '@mantine/core'
import type { KeyboardEvent } from 'react'

import { Button } from '@/ui/Button'

import type { CueToHear } from './api'
import { type Moment, timeOf } from './moments'
import classes from './Recording.module.css'
import { SAID_WORDS } from './words'

interface MomentRowProps {
  moment: Moment
  sound: CueToHear | null
  /** The id of the list of sounds. */
  sounds: string
  onSeek: () => void
  onChange: (change: Partial<Moment>) => void
  onRemove: () => void
  onKeep: () => void
}

/** One mark: where it is, what was heard, of which sound. */
export function MomentRow({ moment, sound, sounds, onSeek, onChange, onRemove, onKeep }: MomentRowProps) {
  const { atS, said, text } = moment
  const at = timeOf(atS)
  const keep = ({ key, nativeEvent }: KeyboardEvent) => {
    if (key === 'Enter' && !nativeEvent.isComposing && sound) onKeep()
  }
  const isUnknown = moment.sound.trim() !== '' && sound === null
  return (
    <li className={`grid items-center gap-2 border-t p-2-14px ${classes.row}`}>
      <Button variant="quiet" aria-label={`Play from ${at}`} onClick={onSeek}>
        {at}
      </Button>
      <span className="strong">{SAID_WORDS[said]}</span>
      <TextInput
        aria-label={`Sound at ${at}`}
        list={sounds}
        value={moment.sound}
        placeholder="Sound or event"
        error={isUnknown ? 'Several sounds, or none, have this. Type on, or choose one.' : undefined}
        description={sound && sound.cue.name !== moment.sound ? sound.cue.name : undefined}
        onKeyDown={keep}
        onChange={({ currentTarget: { value } }) => onChange({ sound: value })}
      />
      <TextInput
        aria-label={`Comment at ${at}`}
        maxLength={1_000}
        value={text}
        placeholder="Comment (optional)"
        onKeyDown={keep}
        onChange={({ currentTarget: { value } }) => onChange({ text: value })}
      />
      <Button square variant="quiet" icon="cross" aria-label={`Remove the mark at ${at}`} onClick={onRemove} />
    </li>
  )
}
