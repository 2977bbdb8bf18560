import { useQuery } from '@tanstack/react-query'

import { useHotkeys } from '@/app/keys'
import { sentence } from '@/ui/sentence'
import { Button, ButtonLink } from '@/ui/Button'
import { Count } from '@/ui/Count'
import { EmptyState } from '@/ui/EmptyState'
import { languageName, LineState, type VoiceLine } from '@/voice-lines'
import { Refusal } from '@/ui/Refusal'

import { pickUpsQuery } from './api'
import type { LinesSearch } from './search'
import classes from './VoiceLines.module.css'

/** What the next session records, by language and character, with the reason of each line; made to be printed. */
export function PickUpsView({ projectId, search }: { projectId: string; search: LinesSearch }) {
  const pickUps = useQuery(pickUpsQuery(projectId, search))
  const print = () => window.print()
  useHotkeys([{ keys: 'p', label: 'Print the pick-up list', group: 'Voice lines', run: print }])
  const query = new URLSearchParams(
    Object.entries({ language: search.language, character: search.character }).filter(
      (entry): entry is [string, string] => entry[1] !== undefined,
    ),
  ).toString()
  const at = (ending: string) => `/v1/projects/${projectId}/pick-ups.${ending}${query && `?${query}`}`
  if (pickUps.error) return <Refusal error={pickUps.error} />
  if (pickUps.data?.lines.length === 0)
    return (
      <EmptyState head="Nothing to record">Every line has a take of its present text that no one sent back.</EmptyState>
    )
  return (
    <>
      <div className={`${classes.acts} ${classes.screenOnly}`}>
        <ButtonLink component="a" href={at('xlsx')} icon="download">
          XLSX
        </ButtonLink>
        <ButtonLink component="a" href={at('csv')} icon="download">
          CSV
        </ButtonLink>
        <Button keys="p" onClick={print}>
          Print
        </Button>
      </div>
      {partsOf(pickUps.data?.lines ?? []).map(({ key, language, name, performer, directedBy, lines }) => (
        <section key={key} className={`grid gap-2 ${classes.scene}`} aria-label={`${name}, ${languageName(language)}`}>
          <header className={classes.partHead}>
            <h2>{name}</h2>
            <span className="small dim">
              {languageName(language)}
              {performer && `, ${performer}`}
              {directedBy && `, directed by ${directedBy}`}
            </span>
            <Count of={lines.length} />
          </header>
          <ul>
            {lines.map((line) => (
              <li key={line.id} className={classes.pickUp}>
                <span className={`small dim mono wrap-anywhere ${classes.path}`}>{filesToRecord(line).join(', ')}</span>
                <div className={`pre-line ${classes.context}`}>
                  {line.before && (
                    <p className="small dim">
                      {line.before.character}: {line.before.text}
                    </p>
                  )}
                  <p lang={language}>{line.text}</p>
                  {line.after && (
                    <p className="small dim">
                      {line.after.character}: {line.after.text}
                    </p>
                  )}
                  {line.direction && <p className="small mid">({line.direction})</p>}
                </div>
                <div>
                  <LineState state={line.state} />
                  {(line.state !== 'no_take' || line.files.length > 1) && (
                    <p className="small mid">{sentence(line.reason)}</p>
                  )}
                </div>
              </li>
            ))}
          </ul>
        </section>
      ))}
    </>
  )
}

const filesToRecord = ({ files }: VoiceLine): string[] =>
  files.filter(({ state }) => state !== 'approved' && state !== 'in_review').map(({ path }) => path)

interface Part {
  key: string
  language: string
  name: string
  performer: string | null
  directedBy: string
  lines: VoiceLine[]
}

/** The lines of one character in one language, together; they come sorted by both. */
function partsOf(lines: readonly VoiceLine[]): Part[] {
  const parts: Part[] = []
  for (const line of lines) {
    const key = `${line.language} ${line.character.id}`
    const last = parts.at(-1)
    if (last?.key === key) last.lines.push(line)
    else
      parts.push({
        key,
        language: line.language,
        name: line.character.name,
        performer: line.performer,
        directedBy: line.directed_by,
        lines: [line],
      })
  }
  return parts
}
