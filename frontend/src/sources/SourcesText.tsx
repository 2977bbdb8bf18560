import { Icon } from '@/ui/Icon'

import classes from './Sources.module.css'

interface SourcesTextProps {
  /** What was stated as one line of text; null where nothing was. */
  words: string | null
  openPoints: readonly string[]
}

/** What a sound was made from, and what is still open about it. */
export function SourcesText({ words, openPoints }: SourcesTextProps) {
  return (
    <>
      <p className={words === null ? 'mid' : `wrap-anywhere ${classes.words}`}>
        {words === null ? 'Not stated yet.' : `${words}.`}
      </p>
      {words !== null && openPoints.length > 0 && (
        <ul className="" aria-label="Open points">
          {openPoints.map((point) => (
            <li key={point} className="small tone-warn toned">
              <Icon name="triangle" size={14} /> {point}
            </li>
          ))}
        </ul>
      )}
    </>
  )
}
