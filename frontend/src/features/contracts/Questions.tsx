import { Checkbox, Radio, TextInput } from '@mantine/core'
import { keptCuesQuery } from '@/api/soundList'
import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate } from '@tanstack/react-router'
import { type ReactNode, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { type Plan, planQuery } from '@/money/api'
import { money, percent } from '@/money/words'
import { Button, ButtonLink } from '@/ui/Button'
import { plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { Refusal } from '@/ui/Refusal'
import { Skeleton } from '@/ui/Skeleton'
import { sentence } from '@/ui/sentence'

import { useContractAction, versionQuery } from './api'
import { TermField } from './ClauseFields'
import { withStanding } from './clauses'
import classes from './Draft.module.css'
import { DraftText } from './DraftText'
import { type Price, PriceQuestion, usePrice } from './PriceQuestion'
import {
  isOrder,
  type Question,
  QUESTION_NAMES,
  questionOf,
  questionsOf,
  saysRights,
  saysRounds,
  saysWho,
} from './questions'
import { SignerFields } from './Signers'
import type { Drafting } from './useDrafting'

interface QuestionsProps {
  drafting: Drafting
  back: string
}

/** The five questions of a draft, the text that the answers make beside them, and the button that sends it. */
export function Questions(props: QuestionsProps) {
  const { contract } = props.drafting
  const { data: plan, error } = useQuery({ ...planQuery(contract.id), enabled: isOrder(contract) })
  const first = useQuery({
    ...versionQuery(contract.id, 1),
    enabled: contract.version.number > 1,
  })
  if (isOrder(contract) && !plan) return error ? <Refusal error={error} /> : <Skeleton rows={12} />
  return <Answers {...props} plan={plan ?? NO_PLAN} begun={first.data ?? contract.version} />
}

const NO_PLAN: Plan = {
  contract_id: '',
  state: 'draft',
  currency: 'USD',
  milestones: [],
  advice: [],
  price: { total_minor: 0, deposit_minor: 0, bid_minor: null, bid_currency: null, above_bid_minor: null },
  concepts: { count: 0, cues: 0, amount_minor: 0 },
}

interface AnswersProps extends QuestionsProps {
  plan: Plan
  begun: Drafting['contract']['version']
}

function Answers({ drafting, back, plan, begun }: AnswersProps) {
  const { contract, draft, library, problems, save, canSave, isChanged } = drafting
  const navigate = useNavigate()
  const send = useContractAction(contract.id)
  const price = usePrice(drafting, plan)
  const { data: cues } = useQuery({ ...keptCuesQuery(contract.project_id), enabled: isOrder(contract) })
  const questions = questionsOf(contract, library)
  const covered = new Set(plan.milestones.flatMap((milestone) => milestone.cues.map(({ cue }) => cue.id)))
  const sounds = (cues ?? []).filter(({ id }) => covered.size === 0 || covered.has(id))
  const isByDay = draft.terms.price_mode === 'day_rate'
  const openReasons: Record<Question, string> = {
    who: '',
    what: cues?.length === 0 ? 'The sound list is empty. Add the sounds that the contract is on.' : '',
    price: isByDay || price.isSaved ? '' : price.typed.price === '' ? 'Enter a price.' : 'Use a plan for this price.',
    rounds: '',
    rights: '',
  }
  for (const problem of problems) {
    const question = questionOf(problem, draft, library)
    if (question) openReasons[question] ||= sentence(problem.message)
  }
  const others = problems.filter((problem) => questionOf(problem, draft, library) === null)
  const open = questions.filter((question) => openReasons[question] !== '')
  const [chosen, setChosen] = useState<Question | null>()
  const current = chosen === undefined ? (open[0] ?? null) : chosen
  const [refused, setRefused] = useState(false)
  const says: Record<Question, string> = {
    who: saysWho(contract),
    what: `${plural(sounds.length, 'sound')}, ${plural(
      sounds.reduce((sum, { variations }) => sum + variations, 0),
      'file',
    )}`,
    price: saysPrice(price, draft.currency, isByDay),
    rounds: saysRounds(draft),
    rights: saysRights(draft, contract.designer.name),
  }
  const show = (question: Question | null) => {
    setChosen(question)
    requestAnimationFrame(() => {
      const body = question && document.getElementById(`answer-${question}`)
      body?.querySelector<HTMLElement>('input, select, button, a')?.focus()
    })
  }
  const next = (question: Question) => show(open.find((other) => other !== question) ?? null)
  const sendIt = async () => {
    const [first] = open
    setRefused(first !== undefined || others.length > 0)
    if (first) show(first)
    if (first || others.length > 0 || send.isPending || (isChanged && !canSave) || !(await save())) return
    await send
      .mutateAsync({ does: 'send', note: '' })
      .then(() => {
        showToast(`${contract.title} sent. Both sides can sign it now.`)
        void navigate({ to: back })
      })
      .catch(() => undefined) // said above the button
  }
  useHotkeys([
    ...questions.map((question, place) => ({
      keys: String(place + 1),
      label: `Open: ${QUESTION_NAMES[question].toLowerCase()}`,
      group: 'Draft',
      run: () => show(question),
    })),
    {
      keys: 'Enter',
      label: 'Accept the answer, and go to the next open question',
      group: 'Draft',
      disabled: current === null || current === 'price',
      run: () => current && next(current),
    },
    { keys: 'mod+Enter', label: 'Send', group: 'Draft', run: () => void sendIt() },
  ])
  const bodies: Record<Question, ReactNode> = {
    who: <Who drafting={drafting} />,
    what: <What contract={contract} back={back} />,
    price: <PriceQuestion drafting={drafting} price={price} plan={plan} back={back} onUsed={() => next('price')} />,
    rounds: <Rounds drafting={drafting} />,
    rights: <Rights drafting={drafting} />,
  }
  const figures: Record<string, string> =
    price.isSaved || price.totalMinor === null ? {} : { total: money(price.totalMinor, draft.currency) }
  return (
    <>
      <div className={`grid bg-raised border rounded-l mid-grid-cols-1 ${classes.answers}`}>
        <ol className={`bg-surface border-r ${classes.questions}`} aria-label="Questions">
          {questions.map((question, place) => {
            const isOpen = question === current
            const reason = openReasons[question]
            return (
              <li key={question} className={`border-b ${classes.question}`} data-open={isOpen || undefined}>
                <button type="button" aria-expanded={isOpen} onClick={() => show(isOpen ? null : question)}>
                  <span className={`grid border-edge ${classes.number}`} data-done={reason === '' || undefined}>
                    {reason === '' ? <Icon name="tick" /> : place + 1}
                  </span>
                  <span>
                    <span className={isOpen ? 'strong' : 'small mid'}>{QUESTION_NAMES[question]}</span>
                    {!isOpen && <span className="block">{reason === '' ? says[question] : reason}</span>}
                  </span>
                </button>
                {isOpen && <div id={`answer-${question}`}>{bodies[question]}</div>}
              </li>
            )
          })}
        </ol>
        <DraftText drafting={drafting} begun={begun} current={current} figures={figures} onPlan={() => show('price')} />
      </div>
      <section className={`row wrap sticky bottom-0 bg-surface ${classes.bar}`} aria-label="Send">
        <div className="grow">
          {refused && open[0] && (
            <p className="tone-bad" role="alert">
              {`Not sent: ${QUESTION_NAMES[open[0]].toLowerCase()} is open. ${openReasons[open[0]]}`}
            </p>
          )}
          {others.map(({ message }) => (
            <p key={message} className="tone-bad" role={refused ? 'alert' : undefined}>
              {sentence(message)}
            </p>
          ))}
          <Refusal error={send.error} />
          {isOrder(contract) && <p className="strong">{saysSum(price, plan, draft.currency, isByDay)}</p>}
          <p className="small mid">
            {open.length === 0
              ? 'Every question is answered.'
              : `${open.length} of ${questions.length} ${open.length === 1 ? 'is' : 'are'} open: ${open.map((question) => QUESTION_NAMES[question].toLowerCase()).join(', ')}. Then it can be sent.`}
          </p>
        </div>
        <ButtonLink
          href={`/v1/contracts/${contract.id}/versions/${contract.version.number}/contract.docx`}
          icon="download"
        >
          Download for Word
        </ButtonLink>
        <Button
          variant={open.length === 0 ? 'primary' : 'plain'}
          keys="mod+Enter"
          aria-disabled={open.length > 0 || others.length > 0}
          onClick={sendIt}
        >
          {`Send to ${contract.designer.name}`}
        </Button>
      </section>
    </>
  )
}

function saysPrice({ totalMinor, parts, isSaved }: Price, currency: string, isByDay: boolean): string {
  if (isByDay) return 'By the day, up to a number of days'
  if (!isSaved || totalMinor === null) return 'Not agreed yet'
  const deposit = parts.filter(({ is_deposit }) => is_deposit).reduce((sum, { amount_minor }) => sum + amount_minor, 0)
  const signing = deposit > 0 ? `; ${percent(Math.round((deposit * 10_000) / totalMinor))} at signing` : ''
  return `${money(totalMinor, currency)} in ${plural(parts.length, 'part')}${signing}`
}

function saysSum({ totalMinor, price, isSaved }: Price, plan: Plan, currency: string, isByDay: boolean): string {
  if (isByDay) return 'Paid by the day.'
  if (!totalMinor) return 'No price yet.'
  const {
    bid_minor: bid,
    bid_currency: bidCurrency,
    deposit_minor: deposit,
  } = (isSaved ? plan.price : price) ?? plan.price
  const above = bid !== null && bidCurrency === currency ? totalMinor - bid : null
  const beside =
    above === null
      ? ''
      : above === 0
        ? ', the same as the bid'
        : `, ${money(Math.abs(above), currency)} ${above > 0 ? 'more' : 'less'} than the bid`
  return `${money(totalMinor, currency)} in all${beside}.${deposit > 0 ? ` Deposit ${money(deposit, currency)} of it at signing.` : ''}`
}

function Who({ drafting: { contract, draft, setDraft } }: { drafting: Drafting }) {
  return (
    <div className={`grid grid-cols-1 gap-3 justify-items-start ${classes.body}`}>
      <p>{`${contract.studio_name} engages ${contract.designer.name}.`}</p>
      <TextInput
        label="Title of the contract"
        value={draft.title}
        maxLength={120}
        onChange={({ currentTarget: { value } }) => setDraft((now) => ({ ...now, title: value }))}
      />
      <SignerFields contract={contract} />
    </div>
  )
}

function What({ contract, back }: { contract: Drafting['contract']; back: string }) {
  const project = `/projects/${contract.project_id}`
  return (
    <div className={`grid grid-cols-1 gap-3 justify-items-start ${classes.body}`}>
      <p>
        The contract names each sound of its plan, with its files and lengths, from the newest revision of the sound
        list and the newest version of the delivery spec. Sounds that are cut, or under another contract, are left out.
      </p>
      <div className="row wrap">
        <ButtonLink component={Link} to={`${project}/sound-list`}>
          Sound list
        </ButtonLink>
        <ButtonLink component={Link} to={`${back}/plan`}>
          Choose sounds
        </ButtonLink>
      </div>
    </div>
  )
}

/** Fields of terms, from the library's own labels. */
function Terms({ drafting: { draft, setDraft, library }, names }: { drafting: Drafting; names: readonly string[] }) {
  const terms = library.flatMap((clause) => clause.terms)
  return names
    .filter((name) => name in draft.terms)
    .map((name) => (
      <TermField
        key={name}
        name={name}
        known={terms.find((term) => term.name === name)}
        value={draft.terms[name] ?? ''}
        currency={draft.currency}
        onChange={(value) => setDraft((now) => ({ ...now, terms: { ...now.terms, [name]: value } }))}
      />
    ))
}

/** Let a clause stand or not; the library's is added where the draft lacks it. */
const withClause = ({ setDraft, library }: Drafting, key: string, stands: boolean) =>
  setDraft((now) => withStanding(now, library, key, stands))

const standsIn = ({ draft }: Drafting, key: string) =>
  draft.clauses.some((clause) => clause.key === key && clause.stands)

function Rounds({ drafting }: { drafting: Drafting }) {
  return (
    <div className={`grid grid-cols-1 gap-3 justify-items-start ${classes.body}`}>
      <Terms drafting={drafting} names={['rounds_included', 'extra_round_bp']} />
      <Checkbox
        label="A sound counts as accepted when nobody answers in time"
        checked={standsIn(drafting, 'silence')}
        onChange={({ currentTarget }) => withClause(drafting, 'silence', currentTarget.checked)}
      />
      {standsIn(drafting, 'silence') && <Terms drafting={drafting} names={['silence_days']} />}
    </div>
  )
}

function Rights({ drafting }: { drafting: Drafting }) {
  const { contract } = drafting
  const value = ['ownership', 'ownership_on_creation'].find((key) => standsIn(drafting, key)) ?? 'own'
  const choose = (key: string) => {
    for (const each of ['ownership', 'ownership_on_creation']) withClause(drafting, each, each === key)
  }
  return (
    <div className={`grid grid-cols-1 gap-3 justify-items-start ${classes.body}`}>
      <Radio.Group label="Rights in a sound pass to the studio" value={value} onChange={choose}>
        <div className={`grid gap-2 ${classes.choices}`}>
          <Radio value="ownership" label="when it is paid" />
          <Radio value="ownership_on_creation" label="when it is made" />
        </div>
      </Radio.Group>
      <Checkbox
        label={`${contract.designer.name} may show the work`}
        checked={standsIn(drafting, 'reel')}
        onChange={({ currentTarget }) => withClause(drafting, 'reel', currentTarget.checked)}
      />
      {standsIn(drafting, 'reel') && <Terms drafting={drafting} names={['reel_from']} />}
    </div>
  )
}
