import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { type ReactNode, useRef, useState } from 'react'

import { proposalQuery, useApplyProposal } from '@/api/briefSpec'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'

import type { Cue, Spec } from '../api'
import { listed } from '../words'
import { Categories, CategoryFields } from './Categories'
import { useChecks } from './checks'
import { useWriting } from './fields'
import { AcceptFields, CheckFields, LimitFields } from './GroupFields'
import { fits } from './naming'
import {
  categorySentence,
  changeSentence,
  DRY_CHECKS,
  EDGE_CHECKS,
  expertSettings,
  faultChecks,
  LEVEL_CHECKS,
  MASTER_CHECKS,
  NAME_STYLES,
  type Sentence,
  sentencesOf,
} from './sentences'
import classes from './Sentences.module.css'
import { EngineFields, NamingFields } from './SpecForm'
import { at, put, tableIn } from './tables'
import { Targets } from './Targets'
import { TryFile } from './TryFile'

const SHOWN_CATEGORIES = 6

interface SentencesViewProps {
  projectId: string
  cues: readonly Cue[]
  /** The spec as it is written now, as far as the server has read it. */
  read: Pick<Spec, 'resolved'>
  basedOn: number
  isChanged: boolean
  /** Saves, or says what saving does. */
  children: ReactNode
}

/** The delivery spec as sentences, each with a small editor of the fields that it is derived from. */
export function SentencesView({ projectId, cues, read, basedOn, isChanged, children }: SentencesViewProps) {
  const { tables } = useWriting()
  const checks = useChecks()
  const [open, setOpen] = useState<string | null>(null)
  const [showsAll, setShowsAll] = useState(false)
  const page = useRef<HTMLDivElement>(null)
  const named = Object.keys(tableIn(tables.categories))
  const shownCategories = showsAll || named.length <= SHOWN_CATEGORIES ? named : named.slice(0, SHOWN_CATEGORIES - 1)
  const experts = expertSettings(tables, checks)
  const row = (sentence: Sentence, editor: ReactNode) => (
    <SentenceRow
      key={sentence.key}
      sentence={sentence}
      editor={editor}
      isOpen={open === sentence.key}
      onOpen={(isOpen) => setOpen(isOpen ? sentence.key : null)}
    />
  )
  const editors: Record<string, ReactNode> = {
    masters: (
      <>
        <AcceptFields base={[]} />
        <CheckFields of={MASTER_CHECKS} />
      </>
    ),
    targets: <Targets />,
    names: <Names cues={cues} />,
    levels: <Limited of={LEVEL_CHECKS} />,
    dryness: (
      <>
        <Reverb />
        <EngineFields />
        <CheckFields of={DRY_CHECKS} />
      </>
    ),
    edges: <Limited of={EDGE_CHECKS} />,
    faults: <Limited of={faultChecks(checks)} />,
  }
  const step = (by: 1 | -1) => {
    const buttons = [...(page.current?.querySelectorAll<HTMLElement>('[data-edit]') ?? [])]
    const current = buttons.findIndex((button) => button.closest('[data-sentence]')?.contains(document.activeElement))
    buttons[Math.min(buttons.length - 1, Math.max(0, current + by))]?.focus()
  }
  useHotkeys([
    { keys: 'j', label: 'Next sentence', group: 'Delivery spec', run: () => step(1), repeats: true },
    { keys: 'k', label: 'Previous sentence', group: 'Delivery spec', run: () => step(-1), repeats: true },
    {
      keys: 'Escape',
      label: 'Close the editor',
      group: 'Delivery spec',
      run: () => setOpen(null),
      disabled: open === null,
    },
  ])
  return (
    <div className="columns side-356" ref={page}>
      <div className="stack">
        <Card aria-labelledby="every-sound">
          <CardHead id="every-sound" title="Every sound" />
          {sentencesOf(tables, read, checks).map((sentence) => row(sentence, editors[sentence.key]))}
          {experts.map((sentence) => row(sentence, null))}
        </Card>
        <Card aria-labelledby="by-category">
          <CardHead
            id="by-category"
            title="By category"
            note="what differs from the above"
            end={
              <Button
                variant="quiet"
                icon="plus"
                aria-expanded={open === 'add'}
                onClick={() => setOpen(open === 'add' ? null : 'add')}
              >
                Add
              </Button>
            }
          />
          {open === 'add' && <Categories cues={cues} isAdding />}
          {shownCategories.map((category) =>
            row(categorySentence(tables, category, checks), <CategoryFields name={category} />),
          )}
          {shownCategories.length < named.length && (
            <div className="grid justify-items-start gap-2 wrap-anywhere p-3-inset">
              <Button
                onClick={() => setShowsAll(true)}
              >{`Show ${plural(named.length - shownCategories.length, 'more category', 'more categories')}`}</Button>
            </div>
          )}
        </Card>
      </div>
      <aside className="stack" aria-label="Brief and saving">
        <TryFile projectId={projectId} />
        {children}
        <FromBrief projectId={projectId} read={read} basedOn={basedOn} isChanged={isChanged} />
        <p className="small dim">
          {`All settings has every limit and the TOML. ${experts.length === 0 ? 'Each setting of this spec stands here in a sentence.' : `${plural(experts.length, 'setting')} of this spec ${experts.length === 1 ? 'has' : 'have'} no sentence, and ${experts.length === 1 ? 'is' : 'are'} named.`}`}
        </p>
      </aside>
    </div>
  )
}

interface SentenceRowProps {
  sentence: Sentence
  editor: ReactNode
  isOpen: boolean
  onOpen: (isOpen: boolean) => void
}

function SentenceRow({ sentence: { label, text, note }, editor, isOpen, onOpen }: SentenceRowProps) {
  return (
    <div
      className={`grid items-baseline gap-1-4 p-2-4 border-b narrow-grid-cols-1-auto ${classes.sentence}`}
      data-open={isOpen || undefined}
      data-sentence
    >
      <span className={`dim text-small ${classes.key}`}>{label}</span>
      <div>
        <p className={`wrap-anywhere ${classes.text}`}>
          {text.split('**').map((words, at) => (at % 2 === 1 ? <b key={at}>{words}</b> : words))}
        </p>
        {note && <p className="small dim">{note}</p>}
      </div>
      {editor !== null && (
        <Button
          variant="quiet"
          keys={isOpen ? 'Escape' : undefined}
          aria-expanded={isOpen}
          aria-label={`${isOpen ? 'Close' : 'Edit'} ${label}`}
          data-edit
          onClick={() => onOpen(!isOpen)}
        >
          {isOpen ? 'Close' : 'Edit'}
        </Button>
      )}
      {isOpen && <div className={`grid grid-cols-1 gap-3 ${classes.editor}`}>{editor}</div>}
    </div>
  )
}

const Limited = ({ of }: { of: readonly string[] }) => (
  <>
    <LimitFields base={[]} of={of} />
    <CheckFields of={of} />
  </>
)

/** The question that decides whether sounds come dry. */
function Reverb() {
  const { tables, set } = useWriting()
  const adds = at(tables, ['engine', 'adds'])
  const effects: unknown[] = Array.isArray(adds) ? adds : []
  const isAdded = effects.includes('reverb')
  const answer = (yes: boolean) =>
    yes !== isAdded &&
    set(['engine', 'adds'], yes ? ['reverb', ...effects] : effects.filter((effect) => effect !== 'reverb'))
  return (
    <div role="group" aria-labelledby="adds-reverb" className="row wrap">
      <span id="adds-reverb">Does the game add reverb?</span>
      <Button pressed={isAdded} onClick={() => answer(true)}>
        Yes
      </Button>
      <Button pressed={!isAdded} onClick={() => answer(false)}>
        No
      </Button>
    </div>
  )
}

/** Names by an example that looks like one’s own, with how many of the list fit; a pattern for all others. */
function Names({ cues }: { cues: readonly Cue[] }) {
  const { tables, set } = useWriting()
  const pattern = at(tables, ['naming', 'pattern']) ?? 'any'
  const stems = cues.flatMap((cue) => cue.stems)
  const styles = [...NAME_STYLES, { example: 'Any name; we match by sound list', pattern: 'any' }]
  return (
    <>
      <fieldset className={`grid gap-2 m-0 p-0 border-0 ${classes.styles}`}>
        <legend className="small mid">Choose the one that looks like yours</legend>
        {styles.map((style) => {
          const count = stems.filter((stem) => fits(style.pattern, stem) === true).length
          return (
            <label
              key={style.pattern}
              className={`row border-edge rounded bg-raised narrow-min-h-44px ${classes.style}`}
            >
              <input
                type="radio"
                name="name-style"
                checked={pattern === style.pattern}
                onChange={() => set(['naming', 'pattern'], style.pattern)}
              />
              <span className={`grow ${style.pattern === 'any' ? '' : 'mono'}`}>{style.example}</span>
              {stems.length > 0 && <span className="small mid">{`${count} of ${stems.length} fit`}</span>}
            </label>
          )
        })}
      </fieldset>
      <NamingFields cues={cues} />
      <CheckFields of={['naming']} />
    </>
  )
}

interface FromBriefProps {
  projectId: string
  read: Pick<Spec, 'resolved'>
  basedOn: number
  isChanged: boolean
}

/** Answers of the brief that the spec does not have, each named, and one press to use them. */
function FromBrief({ projectId, read, basedOn, isChanged }: FromBriefProps) {
  const { tables } = useWriting()
  const checks = useChecks()
  const { data: proposal } = useQuery(proposalQuery(projectId))
  const apply = useApplyProposal(projectId)
  if (!proposal) return null
  const { changes, errors, brief_revision: revision } = proposal
  // What is proposed reads as the sentences that it would make.
  const proposed = changes.reduce((now, { place, after }) => put(now, place.split('.'), after ?? undefined), tables)
  const now = new Map(sentencesOf(tables, read, checks).map(({ key, text }) => [key, text]))
  const changed = sentencesOf(proposed, read, checks).filter(({ key, text }) => now.get(key) !== text)
  const numbers = [...new Set(changes.map(({ number }) => String(number)))]
  const others = changes
    .filter(({ place }) => /^(targets|categories)\./.test(place) || changed.length === 0)
    .map(({ place, after }) => changeSentence(place, after, proposed, checks))
  const sentences = [...new Map([...changed, ...others].map((sentence) => [sentence.key, sentence])).values()]
  const use = () =>
    apply.mutate(
      { based_on_version: basedOn, brief_revision: revision },
      {
        onSuccess: ({ version }) => showToast(`Version ${version} of the spec saved. Affected versions are rechecked.`),
      },
    )
  return (
    <Card aria-labelledby="from-brief">
      <CardHead
        id="from-brief"
        title="From the brief"
        end={changes.length === 0 ? 'nothing differs' : `${plural(changes.length, 'answer')} not used yet`}
      />
      <div className={classes.brief}>
        {sentences.map(({ key, label, text }) => (
          <p key={key}>
            <span className="small mid">{label}</span>
            {text.replaceAll('**', '')}
          </p>
        ))}
        {changes.length > 0 && (
          <p className="small mid">
            {`From ${numbers.length === 1 ? 'question' : 'questions'} ${listed(numbers)} of the brief.`}
          </p>
        )}
        {changes.length === 0 && <p className="small mid">The spec has what the answers ask for.</p>}
        {errors.map((error) => (
          <p key={error} className="tone-bad">
            {error}
          </p>
        ))}
        <Refusal error={apply.error} />
        {changes.length > 0 && (
          <div className="row wrap">
            <Button disabled={isChanged || errors.length > 0} aria-busy={apply.isPending} onClick={use}>
              {changes.length === 1 ? 'Use the answer' : `Use ${changes.length} answers`}
            </Button>
            <Link className="link small" to="/projects/$projectId/brief" params={{ projectId }} search={{}}>
              Brief
            </Link>
          </div>
        )}
        {isChanged && changes.length > 0 && <p className="small mid">Save or discard your changes first.</p>}
      </div>
    </Card>
  )
}
