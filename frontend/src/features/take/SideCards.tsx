import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { historyQuery } from '@/verdicts/api'
import { byWhom, happened, sentence, spot, historyText } from '@/verdicts/words'
import { LossPanel } from '@/losses'
import { Card, CardHead } from '@/ui/Card'
import { age, bytes, channels, clock, day, figure, sampleFormat, rate } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { SEVERITY_LOOK } from '@/ui/severity'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Check, type Finding, type GameFile } from './api'
import { groupsOf, judgementsOf, type Line, textsOf } from './figures'
import classes from './Take.module.css'

/** Every figure of the report, in words and units; what is over a limit is marked. */
export function FiguresCard({ check, findings }: { check: Check | null | undefined; findings: readonly Finding[] }) {
  if (!check) return null
  const facts = check.facts ?? {}
  const severities = new Map(findings.toReversed().map(({ check: name, severity }) => [name, severity]))
  const groups = groupsOf(facts, check.measurements)
  const judged = judgementsOf(check.judgements)
  const texts = textsOf(facts)
  return (
    <Card aria-labelledby="figures">
      <CardHead id="figures" title="Measurements" end={`audio-checks ${check.tool_version}`} />
      <div className="grid gap-14px p-3-inset-14px">
        {groups.length === 0 && <p className="mid">No measurements: the file could not be read.</p>}
        {groups.map(({ title, lines }) => (
          <Lines key={title} title={title} lines={lines} severities={severities} />
        ))}
        {judged.length > 0 && <Lines title="Analysis" lines={judged} severities={severities} />}
        {texts.length > 0 && <Lines title="File metadata" lines={texts} severities={severities} />}
      </div>
    </Card>
  )
}

interface LinesProps {
  title: string
  lines: readonly Line[]
  severities: ReadonlyMap<string, Finding['severity']>
}

function Lines({ title, lines, severities }: LinesProps) {
  return (
    <section aria-label={title}>
      <h3 className="small mid">{title}</h3>
      <dl className={classes.lines}>
        {lines.map(({ name, what, said, check }) => {
          const severity = check === undefined ? undefined : severities.get(check)
          return (
            <div key={name}>
              <dt className="dim">{what}</dt>
              <dd className={severity && `tone-${SEVERITY_LOOK[severity].tone} toned`}>
                {severity && (
                  <>
                    <Icon name={SEVERITY_LOOK[severity].icon} size={14} />
                    <span className="visually-hidden">{SEVERITY_LOOK[severity].label}</span>
                  </>
                )}
                {said}
              </dd>
            </div>
          )
        })}
      </dl>
    </section>
  )
}

/** What was made of it for the game, or why not. */
export function GameFilesCard({ files }: { files: readonly GameFile[] }) {
  return (
    <Card aria-labelledby="game-files">
      <CardHead id="game-files" title="Game files" />
      <ul className={classes.files}>
        {files.map((file) => (
          <li key={file.target}>
            <p className="row">
              <span className="strong">{file.target}</span>
              <span className="end">
                {file.state === 'made' && <StatusBadge kind="passed">Rendered</StatusBadge>}
                {file.state === 'refused' && <StatusBadge kind="refused" />}
                {file.state === 'waiting' && <span className="small dim">not rendered</span>}
              </span>
            </p>
            <p className="small mid">{madeOf(file)}</p>
            {file.file_url && (
              <a className="link small" href={file.file_url} download>
                Download<span className="visually-hidden"> the file for {file.target}</span>
              </a>
            )}
            {file.state === 'made' && file.id && <Lost renderId={file.id} target={file.target} />}
          </li>
        ))}
      </ul>
    </Card>
  )
}

/** What the file lost, asked for when it is opened. */
function Lost({ renderId, target }: { renderId: string; target: string }) {
  const [open, setOpen] = useState(false)
  return (
    <details onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary className="small pointer min-h-24px pt-3px">
        Quality loss<span className="visually-hidden"> for {target}</span>
      </summary>
      {open && <LossPanel renderId={renderId} target={target} />}
    </details>
  )
}

function madeOf({ state, refusal, facts, attenuation_db: down, file_bytes: size }: GameFile): string {
  if (state === 'refused') return sentence(refusal ?? 'Refused.')
  if (state === 'waiting') return 'Game files are rendered once the version passes the check.'
  const { sample_rate_hz: hz, bit_depth: bits, channels: count } = facts as Record<string, number | undefined>
  const parts = [hz && rate(hz), sampleFormat(bits, facts.encoding), count && channels(count), size && bytes(size)]
  const lowered = down !== null && down > 0.005 ? `lowered by ${figure(down, 2)} dB to stay under the peak limit` : ''
  return [...parts, lowered].filter(Boolean).join(', ')
}

/** What happened to it, the newest first. */
export function HistoryCard({ takeId }: { takeId: string }) {
  const { data: history } = useQuery(historyQuery(takeId))
  if (!history) return null
  return (
    <Card aria-labelledby="history">
      <CardHead id="history" title="History" />
      <ol className={classes.history}>
        {history.toReversed().map((entry, at) => (
          <li key={`${entry.at} ${at}`}>
            <p className="row small">
              <span className="strong">{happened(entry)}</span>
              <span className="mid cut-text">{byWhom(entry)}</span>
              <time dateTime={entry.at} className="dim end nowrap" title={`${day(entry.at)}, ${clock(entry.at)}`}>
                {age(entry.at)}
              </time>
            </p>
            {historyText(entry) && (
              <p className="small mid wrap-anywhere">
                {entry.start_s !== null && <span className="mono dim">{spot(entry.start_s, entry.end_s)} </span>}
                {historyText(entry)}
              </p>
            )}
          </li>
        ))}
      </ol>
    </Card>
  )
}
