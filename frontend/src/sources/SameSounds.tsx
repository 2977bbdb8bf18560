import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { type SameSounds as Read, sameSoundsQuery } from './api'

/** Which files of sound libraries a version equals, and where else in the studio its sound is. */
export function SameSounds({ takeId }: { takeId: string }) {
  const { data: read } = useQuery(sameSoundsQuery(takeId))
  if (!read) return null
  return (
    <>
      <LibraryFiles files={read.libraries} />
      <OtherProjects read={read} />
    </>
  )
}

function LibraryFiles({ files }: { files: Read['libraries'] }) {
  if (files.length === 0) return null
  return (
    <div>
      <p className="small">Equals files of sound libraries:</p>
      <ul className="small" aria-label="Same sound in libraries">
        {files.map(({ library, licence, file, words, is_declared: isDeclared }) => (
          <li key={`${library}/${file}`}>
            <span className="mono">{file}</span>
            {` of ${library}${licence === '' ? '' : ` (${licence})`}. This version is ${words}. `}
            <strong>{isDeclared ? 'Declared in its sources.' : 'Not declared in its sources.'}</strong>
          </li>
        ))}
      </ul>
    </div>
  )
}

/** Where else in the studio the sound is; a designer reads of their own versions only. */
function OtherProjects({ read }: { read: Read }) {
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
