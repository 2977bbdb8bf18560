import { Link } from '@tanstack/react-router'

import { Card, CardHead } from '@/ui/Card'
import { age } from '@/ui/format'
import { Icon, type IconName } from '@/ui/Icon'
import type { Tone } from '@/ui/StatusBadge'

import type { Happening } from './api'
import classes from './Project.module.css'
import { trueMinus } from './words'

const SIGNS: Record<Happening['kind'], { icon: IconName; tone: Tone }> = {
  delivery: { icon: 'upload', tone: 'idle' },
  build: { icon: 'box', tone: 'idle' },
  returned: { icon: 'back', tone: 'bad' },
  approved: { icon: 'tick', tone: 'ok' },
  changes: { icon: 'pencil', tone: 'change' },
  cut: { icon: 'struckRing', tone: 'idle' },
  question: { icon: 'question', tone: 'warn' },
  answer: { icon: 'comment', tone: 'idle' },
}
const SHOWN = 10
// What these say names its subject itself.
const SPEAKS_FOR_ITSELF = new Set<Happening['kind']>(['build', 'returned'])

/** The same said again, as when a set is approved sound by sound, is said once. */
function once(happened: readonly Happening[]): (Happening & { times: number })[] {
  const entries: (Happening & { times: number })[] = []
  for (const happening of happened) {
    const last = entries.at(-1)
    if (last && last.kind === happening.kind && last.who === happening.who && last.text === happening.text)
      last.times += 1
    else entries.push({ ...happening, times: 1 })
  }
  return entries
}

// Names of sounds and files keep their small letters.
const textOf = ({ kind, who, text, times }: Happening & { times: number }) => {
  const words = trueMinus(SPEAKS_FOR_ITSELF.has(kind) ? text : `${who} ${text}`)
  return times > 1 ? `${words}, ${times} files` : words
}

/** What happened last, the newest first. */
export function RecentActivityCard({ projectId, happened }: { projectId: string; happened: readonly Happening[] }) {
  const entries = once(happened).slice(0, SHOWN)
  return (
    <Card aria-labelledby="lately" className={classes.lately}>
      <CardHead
        id="lately"
        title="Recent activity"
        end={
          <Link className="link small" to="/projects/$projectId/deliveries" params={{ projectId }}>
            Deliveries
          </Link>
        }
      />
      {entries.length === 0 && <p className="mid p-3-inset">No activity yet.</p>}
      <ul>
        {entries.map((entry) => {
          const { icon, tone } =
            entry.kind === 'build' && entry.text.includes('refused')
              ? { ...SIGNS.build, tone: 'bad' }
              : SIGNS[entry.kind]
          return (
            <li key={`${entry.at} ${entry.text}`} className={`small grid gap-10px wrap-anywhere ${classes.act}`}>
              <span className="dim">{age(entry.at)}</span>
              <span className={`tone-${tone} ${classes.sign}`}>
                <Icon name={icon} />
              </span>
              <span className="mid">{textOf(entry)}</span>
            </li>
          )
        })}
      </ul>
    </Card>
  )
}
