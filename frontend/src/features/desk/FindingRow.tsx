import { wordsOf } from '@/verdicts/findings'
import { Icon } from '@/ui/Icon'
import { SEVERITY_LOOK } from '@/ui/severity'

import { type Finding } from './api'
import classes from './CameBack.module.css'

/** One finding of a version that came back: its figure and limit, what to do, and its page. */
export function FindingRow({ finding, onHear }: { finding: Finding; onHear?: () => void }) {
  const { head, rest, where } = wordsOf(finding)
  const { tone, icon, label } = SEVERITY_LOOK[finding.severity]
  return (
    <li className={`grid col-span-full items-start border-b ${classes.finding} tone-${tone}`}>
      <span className={`flex ${classes.icon}`}>
        <Icon name={icon} />
      </span>
      <span className="strong toned">
        <span className="visually-hidden">{label}</span>
        {head}
      </span>
      <span className="mid wrap-anywhere">
        {rest}{' '}
        {where !== '' &&
          (onHear ? (
            <button type="button" className={`link mono small nowrap ${classes.where}`} onClick={onHear}>
              <span className="visually-hidden">Play from </span>
              {where}
            </button>
          ) : (
            <span className="mono small nowrap">{where}</span>
          ))}
      </span>
      <a className="link small mid" href={`/checks/${finding.check}`} target="_blank" rel="noreferrer">
        {finding.check}
        <span className="visually-hidden">, about this check, in a new tab</span>
      </a>
    </li>
  )
}
