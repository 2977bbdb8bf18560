import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { sameSoundsQuery } from './api'

/** Where else in the studio a version's sound is; a designer reads of their own versions only. */
export function SameSounds({ takeId }: { takeId: string }) {
  const { data: read } = useQuery(sameSoundsQuery(takeId))
  if (!read) return null
  if (read.sounds.length === 0) {
    if (read.is_compared === null) return null
    return (
      <p className="small dim">
        {read.is_compared
          ? 'No approved version of another project has the same sound.'
          : 'Not compared with other projects yet.'}
      </p>
    )
  }
  return (
    <div>
      <p className="small">Also in other projects:</p>
      <ul className="small" aria-label="Same sound in other projects">
        {read.sounds.map((sound) => (
          <li key={sound.take_id}>
            <Link to="/takes/$takeId" params={{ takeId: sound.take_id }} className="link">
              {sound.project_name}: {sound.cue}
              {sound.version === null ? '' : `, version ${sound.version}`}
            </Link>
            . This version is {sound.words}.
          </li>
        ))}
      </ul>
    </div>
  )
}
