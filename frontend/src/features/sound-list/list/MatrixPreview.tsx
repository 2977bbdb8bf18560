import { useDebouncedValue } from '@mantine/hooks'
import { keepPreviousData, useQuery } from '@tanstack/react-query'

import { figure, plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'

import classes from './AddCues.module.css'
import { matrixQuery, type MatrixRow } from './matrix'

const TYPING_MS = 300
const SHOWN = 12

interface MatrixPreviewProps {
  projectId: string
  line: string
  category: string
}

/** The cues that one typed line makes, before they are added; those whose names are taken come first. */
export function MatrixPreview({ projectId, line, category }: MatrixPreviewProps) {
  const [asked] = useDebouncedValue({ line, category }, TYPING_MS)
  const { data, error } = useQuery({
    ...matrixQuery(projectId, asked.line, asked.category),
    placeholderData: keepPreviousData,
  })
  if (error) return <Refusal error={error} />
  if (data === undefined) return null
  const taken = data.rows.filter(({ owner }) => owner !== null)
  const rows = [...taken, ...data.rows.filter(({ owner }) => owner === null)]
  const files = data.rows.reduce((sum, { variations }) => sum + variations, 0)
  return (
    <section className="border-t p-2-14px" aria-label={`Cues of ${line}`}>
      <p role="status">
        <span className="strong">{plural(rows.length, 'cue')}</span>, {plural(files, 'file')} from “{line}”.
        {taken.length > 0 && (
          <span className="tone-bad toned"> {plural(taken.length, 'name')} in the list already; change a part.</span>
        )}
      </p>
      <ul className={`grid gap-2px-4 ${classes.made}`}>
        {rows.slice(0, SHOWN).map((row) => (
          <li key={row.name}>
            <span className="strong">{row.name}</span> <span className="mono small mid">{stemsOf(row)}</span>
            {row.owner && <span className="small tone-bad toned"> belongs to {row.owner}</span>}
          </li>
        ))}
      </ul>
      {rows.length > SHOWN && <p className="small dim">and {figure(rows.length - SHOWN)} more</p>}
    </section>
  )
}

const stemsOf = ({ stems }: MatrixRow): string =>
  stems.length > 1 ? `${stems[0]} to ${stems.at(-1)}` : (stems[0] ?? '')
