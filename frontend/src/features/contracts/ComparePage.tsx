import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'

import { contractQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { ButtonLink } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { Select } from '@/ui/Select'

import { comparisonQuery, versionsQuery } from './api'
import classes from './Contracts.module.css'
import { MarkedLine } from './MarkedLine'

/** Two versions of a contract, word by word. */
export function ComparePage() {
  const { projectId, contractId } = useParams({ from: '/shell/projects/$projectId/contracts/$contractId/compare' })
  const search = useSearch({ from: '/shell/projects/$projectId/contracts/$contractId/compare' })
  const navigate = useNavigate()
  useTitle('Compare versions')
  const { data: contract } = useQuery(contractQuery(contractId))
  const { data: versions, error } = useQuery(versionsQuery(contractId))
  const numbers = versions?.map(({ number }) => number) ?? []
  const to = search.to ?? numbers[0] ?? 1
  const from = search.from ?? numbers.find((number) => number < to) ?? to
  const compared = useQuery({ ...comparisonQuery(contractId, from, to), enabled: numbers.length > 0 })
  const changed = compared.data?.lines.filter(({ change }) => change !== 'same') ?? []
  const show = (next: { from: number; to: number }) =>
    void navigate({
      to: '/projects/$projectId/contracts/$contractId/compare',
      params: { projectId, contractId },
      search: next,
      replace: true,
      resetScroll: false,
    })
  return (
    <div className="page stack">
      <div className="flex wrap items-start between gap-2-4">
        <div>
          <h1>Compare versions</h1>
          <p className="mid" role="status">
            {compared.data &&
              (changed.length === 0
                ? `Versions ${from} and ${to} are identical.`
                : `${plural(changed.length, 'paragraph')} of ${contract?.title ?? 'the contract'} ${changed.length === 1 ? 'differs' : 'differ'} between version ${from} and ${to}.`)}
          </p>
        </div>
        <div className={classes.buttons}>
          {changed.length > 0 && (
            <ButtonLink
              icon="download"
              href={`/v1/contracts/${contractId}/versions/${to}/contract.docx?against=${from}`}
            >
              Word, with tracked changes
            </ButtonLink>
          )}
          <ButtonLink component={Link} to={`/projects/${projectId}/contracts/${contractId}`}>
            Back to contract
          </ButtonLink>
        </div>
      </div>
      <Refusal error={error ?? compared.error} />
      {numbers.length === 1 && (
        <EmptyState head="There is only one version.">
          Every saved draft, and every time you send it, adds a version.
        </EmptyState>
      )}
      {numbers.length > 1 && (
        <Card aria-label="Versions to compare" className="grid grid-cols-2 gap-3 p-3-inset">
          <VersionSelect label="From" value={from} numbers={numbers} onChange={(value) => show({ from: value, to })} />
          <VersionSelect label="To" value={to} numbers={numbers} onChange={(value) => show({ from, to: value })} />
        </Card>
      )}
      {compared.data && (
        <Card aria-label="Text" className={classes.sheet}>
          <div className={`wrap-anywhere ${classes.text}`}>
            {compared.data.lines.map((line, index) => (
              <MarkedLine key={index} line={line} />
            ))}
          </div>
        </Card>
      )}
    </div>
  )
}

interface VersionSelectProps {
  label: string
  value: number
  numbers: readonly number[]
  onChange: (value: number) => void
}

function VersionSelect({ label, value, numbers, onChange }: VersionSelectProps) {
  return (
    <Select label={label} value={value} onChange={({ currentTarget }) => onChange(Number(currentTarget.value))}>
      {numbers.map((number) => (
        <option key={number} value={number}>{`Version ${number}`}</option>
      ))}
    </Select>
  )
}
