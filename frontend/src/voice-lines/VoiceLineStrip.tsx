import { Link } from '@tanstack/react-router'

import type { VoiceLine } from './api'
import { LineState } from './LineState'
import classes from './VoiceLines.module.css'
import { languageName, percentOf } from './words'

/** What is spoken in a cue, with the lines around it; a changed text says what the take still says. */
export function VoiceLineStrip({ projectId, line }: { projectId: string; line: VoiceLine }) {
  return (
    <section className="grid gap-2" aria-label="Voice line">
      <header className="flex wrap items-center gap-1-3">
        <h3>{line.character.name}</h3>
        <span className="small dim">
          {languageName(line.language)}
          {line.scene && `, ${line.scene}`}
        </span>
        <LineState state={line.state} />
        <Link
          className="link small end"
          to="/projects/$projectId/voice-lines"
          params={{ projectId }}
          search={{ language: line.language }}
        >
          All voice lines
        </Link>
      </header>
      {line.before && <Beside of={line.before} />}
      <blockquote className={`pre-line wrap-anywhere ${classes.text}`} lang={line.language}>
        {line.text}
      </blockquote>
      {line.after && <Beside of={line.after} />}
      {line.direction && <p className="small mid">Direction: {line.direction}</p>}
      {line.recorded_text !== null && (
        <p className="small tone-warn toned">The text changed. The take says: {line.recorded_text}</p>
      )}
      {line.length_is_off && line.length_percent !== null && (
        <p className="small tone-warn toned">Length {percentOf(line.length_percent)} against the original</p>
      )}
    </section>
  )
}

function Beside({ of }: { of: NonNullable<VoiceLine['before']> }) {
  return (
    <p className="small dim">
      {of.character}: {of.text}
    </p>
  )
}
