import { useMyProject } from '@/api/me'
import { Checkbox } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { useState } from 'react'

import { ApiProblem } from '@/api'
import { ButtonLink } from '@/ui/Button'
import { ClearanceLinks } from '@/ui/ClearanceLinks'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { bytes, figure, plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { sentence } from '@/ui/sentence'

import { keyUrl, type Pack, packsQuery, packUrl } from './api'
import classes from './Project.module.css'

/** The accepted sounds as the game takes them, for each target. */
export function PackCard({ projectId }: { projectId: string }) {
  const { data: packs, error } = useQuery(packsQuery(projectId))
  const [masters, setMasters] = useState(false)
  const first = packs?.[0]
  const nothing = first !== undefined && first.cues_accepted === 0
  const noTarget = error instanceof ApiProblem && error.code === 'target-unknown'
  return (
    <Card aria-labelledby="pack">
      <CardHead
        id="pack"
        title="Approved pack"
        note={first && !nothing ? `${figure(first.cues_accepted)} of ${plural(first.cues_wanted, 'cue')}` : undefined}
        end={
          <Link className="link" to="/projects/$projectId/packs" params={{ projectId }}>
            Seal<span className="visually-hidden"> a pack; see earlier packs</span>
          </Link>
        }
      />
      {noTarget ? (
        <p className="mid p-3-inset">
          The spec has no targets, so no game files are rendered. Add a target to the spec.
        </p>
      ) : (
        <Refusal inset error={error} />
      )}
      {nothing && (
        <div className="p-inset">
          <EmptyState head="Nothing is accepted yet." level={3}>
            The pack contains the game files of accepted sounds, with a documentation key.
          </EmptyState>
        </div>
      )}
      {!nothing && (
        <ul>
          {packs?.map((pack) => (
            <PackLine key={pack.target} pack={pack} projectId={projectId} masters={masters} />
          ))}
        </ul>
      )}
      <p className={`small ${classes.ways}`}>
        <Link className="link" to="/projects/$projectId/game-files" params={{ projectId }}>
          Targets, memory and batches
        </Link>
      </p>
      {first && !nothing && (
        <div className="p-10px-inset">
          <Checkbox
            checked={masters}
            onChange={({ currentTarget }) => setMasters(currentTarget.checked)}
            label={`With masters, ${bytes(first.masters_bytes)} more`}
          />
        </div>
      )}
    </Card>
  )
}

function PackLine({ pack, projectId, masters }: { pack: Pack; projectId: string; masters: boolean }) {
  const isProducer = useMyProject(projectId)?.is_producer ?? false
  const { target, files, bytes: size, missing } = pack
  return (
    <li className="border-b p-2-inset">
      <div className="row">
        <p className="grow">
          <span className="strong">{target}</span>{' '}
          <span className="mid">{`${plural(files, 'file')}, ${bytes(size)}`}</span>
        </p>
        <ButtonLink
          href={packUrl(projectId, target, { masters, allowMissing: missing.length > 0 })}
          download
          aria-label={`Download ${target}${missing.length > 0 ? ` without ${plural(missing.length, 'missing file')}` : ''}`}
        >
          Download
        </ButtonLink>
      </div>
      <p className="row wrap small mid">
        Documentation key
        <a
          className="link"
          href={keyUrl(projectId, target, 'csv')}
          download
          aria-label={`Documentation key of ${target} as CSV`}
        >
          CSV
        </a>
        <a
          className="link"
          href={keyUrl(projectId, target, 'xlsx')}
          download
          aria-label={`Documentation key of ${target} as XLSX`}
        >
          XLSX
        </a>
        <a
          className="link"
          href={keyUrl(projectId, target, 'pdf')}
          download
          aria-label={`Documentation key of ${target} as PDF`}
        >
          PDF
        </a>
      </p>
      {isProducer && (
        <ClearanceLinks
          path={`/v1/projects/${projectId}`}
          query={`?target=${encodeURIComponent(target)}`}
          of={target}
        />
      )}
      {missing.length > 0 && (
        <details className="small">
          <summary className={`row tone-warn min-h-24px pointer ${classes.missing}`}>
            <Icon name="triangle" />
            <span className="toned">{`${plural(missing.length, 'accepted file')} missing`}</span>
          </summary>
          <ul>
            {missing.map(({ file_name, label, reason }) => (
              <li key={file_name} className="mid">
                <span className="mono">{file_name}</span> {`(${label}): ${sentence(reason)}`}
              </li>
            ))}
          </ul>
        </details>
      )}
    </li>
  )
}
