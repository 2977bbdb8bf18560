import { TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, type LinkProps } from '@tanstack/react-router'
import { useState } from 'react'

import { proposalQuery, useApplyProposal } from '@/api/briefSpec'
import { coverageQuery, kitsQuery } from '@/api/project'
import { useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { hoursRange } from '@/money/words'
import { Button } from '@/ui/Button'
import { CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { Select } from '@/ui/Select'
import { plural } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'

import { type Brief, readsQuery, sizeQuery, usePublishBrief } from './api'
import classes from './Brief.module.css'
import { KickOffCard } from './KickOffCard'
import type { Saving } from './useAnswers'
import { questionsOf, refused } from './words'

interface SideCardsProps {
  projectId: string
  brief: Brief
  saving: Saving
}

export function SideCards({ projectId, brief, saving }: SideCardsProps) {
  return (
    <>
      <SpecCard projectId={projectId} mayApply={brief.may_answer} saving={saving} />
      {brief.may_answer && <PublishCard projectId={projectId} brief={brief} saving={saving} />}
      {brief.may_answer && <SizeCard projectId={projectId} revision={brief.revision} />}
      <KickOffCard projectId={projectId} brief={brief} />
      <CoverageCard projectId={projectId} />
      <OpenCard projectId={projectId} brief={brief} />
    </>
  )
}

/** What the answers ask of the delivery spec, each line with its question; saved in one act. */
function SpecCard({ projectId, mayApply, saving }: { projectId: string; mayApply: boolean; saving: Saving }) {
  const { data: proposal } = useQuery(proposalQuery(projectId))
  const apply = useApplyProposal(projectId)
  if (!proposal) return null
  const { changes, errors, based_on_version: basedOn, brief_revision: revision } = proposal
  const send = () =>
    apply.mutate(
      { based_on_version: basedOn, brief_revision: revision },
      {
        onSuccess: ({ version }) => showToast(`Version ${version} of the spec saved. Affected versions are rechecked.`),
      },
    )
  return (
    <section aria-label="Delivery spec">
      <CardHead
        title="Delivery spec"
        note={`version ${basedOn}`}
        end={
          <Link className="link" to={`/projects/${projectId}/spec/versions` as LinkProps['to']}>
            View
          </Link>
        }
      />
      {changes.length === 0 ? (
        <p className={`grid gap-3 ${classes.sideBody}`}>The spec has what the answers ask for.</p>
      ) : (
        <>
          <ul aria-label="Changes that the answers ask for">
            {changes.map(({ place, before, after, number, lines }) => (
              <li key={place} className="grid gap-2px border-b wrap-anywhere p-2-14px">
                <span className="row between small mid">
                  <span className="mono">{place}</span>
                  <span>{`question ${number}`}</span>
                </span>
                {before !== null && <span className="mono struck pre-wrap">{written(before)}</span>}
                <span className="mono pre-wrap">
                  {after === null ? 'removed' : lines.filter((line) => line !== '').join('\n')}
                </span>
              </li>
            ))}
          </ul>
          <div className={`grid gap-3 ${classes.sideBody}`}>
            {errors.map((error) => (
              <ErrorBanner key={error} detail={refused(error)} fix="Change the answer, or the spec itself." />
            ))}
            {mayApply && (
              <>
                <div>
                  <Button disabled={saving !== 'saved' || errors.length > 0} aria-busy={apply.isPending} onClick={send}>
                    {`Save as version ${basedOn + 1} of the spec`}
                  </Button>
                </div>
                <p className="small mid">Comments in the TOML are lost. Earlier versions stay.</p>
              </>
            )}
            <Refusal error={apply.error} />
          </div>
        </>
      )}
    </section>
  )
}

const written = (value: unknown): string => (typeof value === 'string' ? value : JSON.stringify(value))

/** Freezes the answers as a version that both sides can name. */
function PublishCard({ projectId, brief, saving }: SideCardsProps) {
  const publish = usePublishBrief(projectId)
  const [note, setNote, draft] = useDraft(`brief-version:${projectId}`, '')
  const next = brief.newest_version + 1
  const send = () =>
    publish.mutate(
      { revision: brief.revision, note },
      {
        onSuccess: ({ number }) => {
          draft.discard()
          showToast(`Version ${number} of the brief published.`)
        },
      },
    )
  return (
    <section aria-label="Publish">
      <CardHead title={brief.newest_version === 0 ? 'No version yet' : `Version ${brief.newest_version}`} />
      <div className={`grid gap-3 ${classes.sideBody}`}>
        {brief.differs ? (
          <>
            <TextInput
              label="Note (optional)"
              value={note}
              maxLength={5000}
              onChange={({ currentTarget }) => setNote(currentTarget.value)}
            />
            <div>
              <Button disabled={saving !== 'saved'} aria-busy={publish.isPending} onClick={send}>
                {`Publish version ${next}`}
              </Button>
            </div>
            <p className="small mid">A published version never changes. Designers see which answers differ.</p>
          </>
        ) : (
          <p className="small mid">
            {brief.newest_version === 0
              ? 'Answer a question, then publish a version that designers can rely on.'
              : 'The answers are those of this version.'}
          </p>
        )}
        <Refusal error={publish.error} />
      </div>
    </section>
  )
}

/** What the answers name and the sound list lacks. */
function CoverageCard({ projectId }: { projectId: string }) {
  const { data } = useQuery(coverageQuery(projectId))
  if (!data) return null
  const missing = [
    { problem: 'has no ambience on the list', names: data.scenes_without_ambience },
    { problem: 'is silent: neither ambience nor music', names: data.silent_scenes },
    { problem: 'has no cue on the list', names: data.categories_without_cue },
    { problem: 'has no cue on the list', names: data.priority_without_cue },
  ]
  const lines = missing.flatMap(({ problem, names }) => names.map((name) => ({ name, problem })))
  if (lines.length === 0) return null
  return (
    <section aria-label="Missing from the sound list">
      <CardHead title="Missing from the sound list" count={lines.length} />
      <ul>
        {lines.map(({ name, problem }) => (
          <li key={`${name} ${problem}`} className="grid gap-2px border-b wrap-anywhere p-2-14px">
            <span>
              <span className="strong">{name}</span> <span className="mid">{problem}</span>
            </span>
          </li>
        ))}
      </ul>
      <p className={`grid gap-3 ${classes.sideBody}`}>
        <Link className="link" to={`/projects/${projectId}/sound-list` as LinkProps['to']}>
          To the sound list
        </Link>
      </p>
    </section>
  )
}

/** How many sounds, and hours of work, the answers lead to before there is a list. */
function SizeCard({ projectId, revision }: { projectId: string; revision: number }) {
  const [kit, setKit] = useState('')
  const { data: kits } = useQuery(kitsQuery)
  const { data: size, error } = useQuery(sizeQuery(projectId, kit, revision))
  if (!size) return <Refusal inset error={error} />
  const isEmpty = size.lines.length === 0
  if (isEmpty && kit === '') return null
  const { low_cues: low, high_cues: high, listed_cues: listed, unknown } = size
  return (
    <section aria-label="Size">
      <CardHead title="Size" note="a guess" />
      <div className={classes.sideBody}>
        <p>
          {isEmpty
            ? 'This kit has none of the categories in the answers.'
            : `About ${low === high ? plural(high, 'cue') : `${low}–${high} cues`}, ${hoursRange(size)} of work. The list has ${listed}.`}
        </p>
        <details className="small">
          <summary>By scene and category</summary>
          <ul>
            {size.lines.map((line) => (
              <li key={`${line.scene} ${line.category}`}>
                {`${line.scene ? `${line.scene}, ` : ''}${line.category}: ${line.low_cues === line.high_cues ? plural(line.high_cues, 'cue') : `${line.low_cues}–${line.high_cues} cues`}, ${hoursRange(line)}`}
              </li>
            ))}
          </ul>
          {unknown.length > 0 && <p className="mid">{`Not counted: ${unknown.join(', ')}.`}</p>}
          <p className="mid">
            Ambience and music come from the scenes, the rest from the starter kits: their share of the cues that a
            small game usually has.
          </p>
        </details>
        {kits && (
          <Select label="Compared with" value={kit} onChange={({ currentTarget: { value } }) => setKit(value)}>
            <option value="">Small games of all kinds</option>
            {kits.map(({ key, name }) => (
              <option key={key} value={key}>
                {name}
              </option>
            ))}
          </Select>
        )}
      </div>
    </section>
  )
}

/** What nobody has answered yet, for both sides to see. */
function OpenCard({ projectId, brief }: { projectId: string; brief: Brief }) {
  const open = questionsOf(brief).filter(({ key }) => brief.open.includes(key))
  const topicOf = (key: string) =>
    brief.topics.find(({ questions }) => questions.some((question) => question.key === key))?.key
  return (
    <section aria-label="Undecided">
      <CardHead title="Undecided" count={open.length} />
      {open.length === 0 ? (
        <p className={`grid gap-3 ${classes.sideBody}`}>Every question is answered.</p>
      ) : (
        <ul className={classes.open}>
          {open.map(({ key, number, text, required }) => (
            <li key={key}>
              <Link to="/projects/$projectId/brief" params={{ projectId }} search={{ topic: topicOf(key) }}>
                <span className="dim">{number}</span>
                <span className="grow">{text}</span>
                {required && <span className="small mid nowrap">needed</span>}
              </Link>
            </li>
          ))}
        </ul>
      )}
    </section>
  )
}

/** Which version each designer opened last. */
export function ReadBy({ projectId, newest }: { projectId: string; newest: number }) {
  const { data: reads } = useQuery(readsQuery(projectId))
  if (!reads || reads.length === 0) return null
  return (
    <section className="grid gap-2 p-14px" aria-label="Read by">
      <h2>Read by</h2>
      <ul>
        {reads.map(({ designer, version, behind }) => (
          <li key={designer.id} className="row between small">
            <span className="cut-text">{designer.name}</span>
            <span className="mid nowrap">
              {version === null
                ? newest === 0
                  ? 'no version yet'
                  : 'not yet'
                : behind === 0
                  ? `version ${version}`
                  : `version ${version}, ${plural(behind, 'version')} behind`}
            </span>
          </li>
        ))}
      </ul>
    </section>
  )
}
