import { useMediaQuery } from '@mantine/hooks'
import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { useEffect, useMemo, useRef } from 'react'

import { ApiProblem } from '@/api'
import { cuesQuery } from '@/api/soundList'
import { useHotkeys } from '@/app/keys'
import { NotFoundPage } from '@/app/NotFoundPage'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Icon } from '@/ui/Icon'
import { KeysLine } from '@/ui/KeysLine'
import { PageWait } from '@/ui/PageWait'
import { SaveStatus, type SaveStatusProps } from '@/ui/SaveStatus'

import { type Brief, briefQuery, type Question, type Topic, useRecordRead } from './api'
import classes from './Brief.module.css'
import { QuestionCard } from './QuestionCard'
import { ReadBy, SideCards } from './SideCards'
import { type Saving, useAnswers } from './useAnswers'
import { openWords, questionsOf } from './words'

const GROUP = 'Brief'
const SAVING: Record<Saving, SaveStatusProps> = {
  saved: { state: 'saved' },
  saving: { state: 'saving' },
  lost: {
    state: 'failed',
    why: 'the server can’t be reached. Your answers are kept here and sent again.',
  },
  refused: { state: 'failed', why: 'an answer was refused' },
}

/** What a designer must know before work starts: one topic a page, saved as it is typed. */
export function BriefPage() {
  useTitle('Brief')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/brief' })
  const { data: brief, error } = useQuery(briefQuery(projectId))
  useRead(projectId, brief)
  if (error instanceof ApiProblem && error.status === 404) return <NotFoundPage />
  if (!brief) {
    return <PageWait title="Brief" error={error} />
  }
  return <OpenBrief key={projectId} projectId={projectId} brief={brief} />
}

/** A designer who opens the brief has read its newest version: the team sees which. */
function useRead(projectId: string, brief: Brief | undefined) {
  const { mutate } = useRecordRead(projectId)
  const version = brief?.may_ask ? brief.newest_version : 0
  useEffect(() => {
    if (version > 0) mutate(version)
  }, [mutate, version])
}

function OpenBrief({ projectId, brief }: { projectId: string; brief: Brief }) {
  const { topic: topicKey } = useSearch({ from: '/shell/projects/$projectId/brief' })
  const navigate = useNavigate()
  const answers = useAnswers(projectId, brief)
  const { data: cues } = useQuery(cuesQuery(projectId))
  const names = useMemo(
    () => [...new Set((cues ?? []).flatMap(({ stems }) => stems.map((stem) => `${stem}.wav`)))],
    [cues],
  )
  const categories = useMemo(
    () => [...new Set((cues ?? []).map(({ category }) => category).filter((category) => category !== ''))],
    [cues],
  )
  const index = brief.topics.findIndex(({ key }) => key === topicKey)
  const at = Math.max(0, index)
  const topic = brief.topics[at]
  const asked = topic?.questions.filter(({ applies }) => applies) ?? []
  const isWide = useMediaQuery('(min-width: 1181px)', true, { getInitialValueInEffect: false })
  const heading = useRef<HTMLHeadingElement>(null)
  const wasMoved = useRef(false)
  const scroll = useRef<HTMLDivElement>(null)

  useEffect(() => {
    if (!wasMoved.current) return
    wasMoved.current = false
    if (scroll.current) scroll.current.scrollTop = 0
    heading.current?.focus()
  }, [at])

  const go = (to: number) => {
    const next = brief.topics[to]
    if (!next) return
    wasMoved.current = true
    void navigate({
      to: '/projects/$projectId/brief',
      params: { projectId },
      search: { topic: next.key },
      replace: true,
      resetScroll: true,
    })
  }
  const focusOn = (question: Question | undefined) => {
    if (!question) return
    const card = document.getElementById(`question-${question.key}`)
    card?.focus({ preventScroll: true })
    card?.scrollIntoView({ block: 'nearest' })
  }
  const step = (by: 1 | -1) => {
    const place = asked.findIndex(({ key }) => key === focusedKey())
    focusOn(asked[place < 0 ? (by > 0 ? 0 : asked.length - 1) : Math.min(asked.length - 1, Math.max(0, place + by))])
  }
  const chosenQuestion = () => asked.find(({ key }) => key === focusedKey()) ?? asked[0]
  const pick = (place: number) => {
    const chosen = chosenQuestion()
    const choice = chosen?.choices[place - 1]
    if (!chosen || !choice || !brief.may_answer) return
    const value = answers.of(chosen)?.value
    if (chosen.kind === 'choice') answers.change(chosen, { value: choice.key, is_unknown: false })
    if (chosen.kind === 'choices') {
      const picked = Array.isArray(value) ? (value as string[]) : []
      const next = picked.includes(choice.key)
        ? picked.filter((other) => other !== choice.key)
        : [...picked, choice.key]
      answers.change(chosen, { value: next, is_unknown: false })
    }
  }
  const unknown = () => {
    const chosen = chosenQuestion()
    if (!chosen || !brief.may_answer) return
    answers.change(chosen, { value: null, is_unknown: !(answers.of(chosen)?.is_unknown ?? false) })
  }
  useHotkeys([
    { keys: 'n', label: 'Next topic', group: GROUP, run: () => go(at + 1) },
    { keys: 'p', label: 'Previous topic', group: GROUP, run: () => go(at - 1) },
    { keys: 'j', label: 'Next question', group: GROUP, run: () => step(1), repeats: true },
    { keys: 'k', label: 'Previous question', group: GROUP, run: () => step(-1), repeats: true },
    ...(brief.may_answer
      ? [
          { keys: '0', label: 'I don’t know yet', group: GROUP, run: unknown },
          { keys: '1', label: 'Pick an answer, 1 to 9', group: GROUP, run: () => pick(1) },
          ...[2, 3, 4, 5, 6, 7, 8, 9].map((place) => ({
            keys: String(place),
            label: `Pick answer ${place}`,
            group: GROUP,
            run: () => pick(place),
            unlisted: true,
          })),
        ]
      : []),
  ])
  if (!topic) return null
  const open = asked.filter(({ key }) => brief.open.includes(key)).length
  const nextOpen = questionsOf(brief).find(
    ({ key }) => brief.open.includes(key) && !asked.some((question) => question.key === key),
  )
  return (
    <div className={`grid overflow-hidden ${classes.room}`}>
      <nav className={`wide-only border-r ${classes.rail}`} aria-label="Topics">
        <div className={`flex items-center between border-b ${classes.railHead}`}>
          <span className="strong">Brief</span>
          <Link className="link small" to="/projects/$projectId/brief/versions" params={{ projectId }} search={{}}>
            {versionWords(brief)}
          </Link>
        </div>
        <Completeness brief={brief} />
        <ol>
          {brief.topics.map((item, place) => (
            <li key={item.key}>
              <TopicLink topic={item} projectId={projectId} isCurrent={place === at} onGo={() => go(place)} />
            </li>
          ))}
        </ol>
        {!brief.may_ask && <ReadBy projectId={projectId} newest={brief.newest_version} />}
        <div className={`border-t p-14px ${classes.railFoot}`}>
          <KeysLine
            keys={[
              { keys: ['j', 'k'], label: 'next question' },
              { keys: ['n', 'p'], label: 'next topic' },
              ...(brief.may_answer
                ? [
                    { keys: ['1', '9'], label: 'answer' },
                    { keys: ['0'], label: 'I don’t know yet' },
                  ]
                : []),
            ]}
          />
        </div>
      </nav>
      <div className="flex flex-col min-h-0 min-w-0">
        <div className={`grid gap-3 content-start flex-1 min-h-0 overflow-y-auto ${classes.scroll}`} ref={scroll}>
          <div className={classes.narrowHead}>
            <p className="small mid">{`Brief, ${brief.answered} of ${brief.total}. Topic ${at + 1} of ${brief.topics.length}`}</p>
            <Bar brief={brief} />
          </div>
          <header className={`flex top between gap-4 ${classes.head}`}>
            <div>
              <h1 ref={heading} tabIndex={-1}>
                {topic.title}
              </h1>
              <p className="mid">{`${topic.lead} ${asked.length === 1 ? 'One question' : `${asked.length} questions`}, ${open === 0 ? 'none open' : `${open} open`}.`}</p>
            </div>
            {brief.may_answer && <SaveStatus {...SAVING[answers.saving]} />}
          </header>
          {asked.map((question) => (
            <QuestionCard
              key={question.key}
              question={question}
              projectId={projectId}
              answers={answers}
              mayAnswer={brief.may_answer}
              mayAsk={brief.may_ask}
              followUps={brief.follow_ups.filter((followUp) => followUp.question === question.key)}
              names={names}
              categories={categories}
            />
          ))}
          {!isWide && (
            <aside className="grid gap-3 border rounded-l bg-surface" aria-label="Versions and open questions">
              <SideCards projectId={projectId} brief={brief} saving={answers.saving} />
            </aside>
          )}
        </div>
        <div className={`flex items-center between gap-4 flex-none bg-surface ${classes.foot}`}>
          <div className="wide-only">
            <p className="strong">{nextOpen ? `Next open: ${lower(nextOpen.text)}` : 'No other question is open.'}</p>
            <p className="small mid">
              Every question can be skipped. What a contract needs and is still open is named in its text, so both sides
              see it.
            </p>
          </div>
          <div className={`flex gap-2 flex-none ${classes.footActs}`}>
            <Button keys="p" disabled={at === 0} onClick={() => go(at - 1)}>
              Back
            </Button>
            {at === brief.topics.length - 1 ? (
              <Button
                variant="primary"
                keys="n"
                onClick={() => void navigate({ to: '/projects/$projectId', params: { projectId } })}
              >
                To the project
              </Button>
            ) : (
              <Button variant="primary" keys="n" onClick={() => go(at + 1)}>
                Next topic
              </Button>
            )}
          </div>
        </div>
      </div>
      {isWide && (
        <aside className={`border-l ${classes.side}`} aria-label="Versions and open questions">
          <SideCards projectId={projectId} brief={brief} saving={answers.saving} />
        </aside>
      )}
    </div>
  )
}

/** The question that the focus is in. */
const focusedKey = (): string => document.activeElement?.closest<HTMLElement>('[data-question]')?.dataset.question ?? ''

const lower = (text: string) => text.charAt(0).toLowerCase() + text.slice(1)

function versionWords({ newest_version: newest, differs }: Brief): string {
  if (newest === 0) return 'no version yet'
  return differs ? `changed since version ${newest}` : `version ${newest}`
}

function Bar({ brief }: { brief: Brief }) {
  const percent = brief.total === 0 ? 0 : Math.round((100 * brief.answered) / brief.total)
  return (
    <div
      className={`overflow-hidden rounded-s ${classes.bar}`}
      role="progressbar"
      aria-label="Questions answered"
      aria-valuenow={brief.answered}
      aria-valuemin={0}
      aria-valuemax={brief.total}
    >
      <span style={{ width: `${percent}%` }} />
    </div>
  )
}

function Completeness({ brief }: { brief: Brief }) {
  return (
    <div className="grid gap-2 border-b p-14px">
      <p className="row between">
        <span className="strong">{`${brief.answered} of ${brief.total}`}</span>
        <span className="small mid">{openWords(brief)}</span>
      </p>
      <Bar brief={brief} />
    </div>
  )
}

function TopicLink({
  topic,
  projectId,
  isCurrent,
  onGo,
}: {
  topic: Topic
  projectId: string
  isCurrent: boolean
  onGo: () => void
}) {
  const isDone = topic.answered === topic.total
  return (
    <Link
      to="/projects/$projectId/brief"
      params={{ projectId }}
      search={{ topic: topic.key }}
      className={`flex items-center gap-10px hover border-b ${classes.topic}`}
      aria-current={isCurrent ? 'page' : undefined}
      onClick={(event) => {
        if (event.ctrlKey || event.metaKey || event.shiftKey) return
        event.preventDefault()
        onGo()
      }}
    >
      <span className={isDone ? 'tone-ok toned' : topic.answered > 0 ? 'tone-warn toned' : 'dim'}>
        <Icon name={isDone ? 'tick' : topic.answered > 0 ? 'question' : 'ring'} />
      </span>
      <span className="grow">{topic.title}</span>
      <span className="small mid">{`${topic.answered} of ${topic.total}`}</span>
    </Link>
  )
}
