import { queryById } from '@/api'

import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { money } from '@/money/words'
import { day as dayName, plural } from '@/ui/format'

export type NextSteps = components['schemas']['NextSteps']
export type NextStep = components['schemas']['NextStep']
export type Awaited = components['schemas']['Awaited']

/** What the current person is to do in a project, the first thing first, and for whom they wait. */
export const nextStepsQuery = queryById('/v1/projects/{project_id}/next-steps', queryKeys.nextSteps)

type Kind = NextStep['kind']

/** Steps that stand under Contract. */
const OF_CONTRACT: ReadonlySet<Kind> = new Set([
  'send_nda',
  'sign_contract',
  'change_contract',
  'sign_change_order',
  'agree_statement',
  'propose_changes',
  'think_of_day',
  'send_contract',
  'pay_invoice',
  'invoice_deposit',
  'deposit_due',
  'invoice_due',
  'agree_days',
  'agree_hours',
  'correct_work',
  'agree_round',
])
/** Steps that their page shows by itself, with the sounds that they are about. */
const SHOWN_ELSEWHERE: ReadonlySet<Kind> = new Set(['review', 'send_changes', 'fix', 'match', 'make'])

/** The steps that need a line of their own on Today and Desk. */
export const stepsToName = ({ steps }: NextSteps): NextStep[] => steps.filter(({ kind }) => !SHOWN_ELSEWHERE.has(kind))

/** How much waits under Contract, and what else stands as a line on Today. */
export function badgesOf(next: NextSteps): { contract: number; today: number } {
  const named = stepsToName(next)
  return { contract: named.filter(({ kind }) => OF_CONTRACT.has(kind)).length, today: named.length }
}

const sum = ({ amount_minor: minor, currency }: NextStep): string =>
  minor !== null && minor !== undefined && currency ? money(minor, currency) : ''

interface Words {
  /** What to do: "Sign Effects for Alpha". */
  head: string
  /** What it is for, or what follows. */
  why: string
  /** On the button. */
  act: string
  path: string
}

/** A step in words, and where it is done. */
export function wordsOf(step: NextStep, projectId: string): Words {
  const project = `/projects/${projectId}`
  const contract = `${project}/contracts${step.contract_id ? `/${step.contract_id}` : ''}`
  const { subject, who, count } = step
  switch (step.kind) {
    case 'add_cues':
      return {
        head: 'Add the sounds that the game needs',
        why: 'Type them, paste rows, or import a sheet.',
        act: 'Import or paste',
        path: `${project}/sound-list/import`,
      }
    case 'write_brief':
      return {
        head: 'Write the brief',
        why: 'What a designer will ask, in plain questions. You can skip it: a project works without one.',
        act: 'Write the brief',
        path: `${project}/brief`,
      }
    case 'invite_designer':
      return {
        head: 'Invite a sound designer',
        why: 'The invitation shows the list and the spec right away. Or post the work under People, Postings, and compare bids.',
        act: 'Invite',
        path: `${project}/people`,
      }
    case 'answer_candidates':
      return {
        head: count === 1 ? 'Answer a candidate’s question' : `Answer ${plural(count, 'question')} of candidates`,
        why: `About ${subject}.`,
        act: 'Answer',
        path: `${project}/postings/${step.posting_id}`,
      }
    case 'compare_bids':
      return {
        head: count === 1 ? 'Look at a bid' : `Compare ${plural(count, 'bid')}`,
        why: `On ${subject}.`,
        act: count === 1 ? 'Look at it' : 'Compare',
        path: `${project}/postings/${step.posting_id}/bids`,
      }
    case 'name_approver':
      return {
        head: 'Name an approver, if it is not you',
        why: 'You approve every sound until someone else is named.',
        act: 'Name an approver',
        path: `${project}/people`,
      }
    case 'send_nda':
      return {
        head: `Send ${who} the NDA`,
        why: 'The project stays closed to them until both sides have signed it.',
        act: 'Go to contracts',
        path: `${project}/contracts`,
      }
    case 'sign_contract':
      return { head: `Sign ${subject}`, why: `With ${who}.`, act: 'Read and sign', path: contract }
    case 'change_contract':
      return {
        head: `${who} asks for a change in ${subject}`,
        why: 'It is a draft again.',
        act: 'Open',
        path: contract,
      }
    case 'sign_change_order':
      return {
        head: `Sign a change order to ${subject}`,
        why: `With ${who}. Nothing changes until both have signed.`,
        act: 'Read and sign',
        path: `${contract}/changes`,
      }
    case 'agree_statement':
      return {
        head: `Agree to the statement of ${subject}`,
        why: `The contract with ${who} ends early: what each cue is owed stands there.`,
        act: 'Read the statement',
        path: `${contract}/ending`,
      }
    case 'propose_changes':
      return {
        head: count === 1 ? `Something changed under ${subject}` : `${count} things changed under ${subject}`,
        why: 'Propose a change order, or dismiss it with a reason.',
        act: 'See what changed',
        path: `${contract}/changes`,
      }
    case 'think_of_day':
      return {
        head: `${dayName(step.day ?? '')}: ${step.what ?? ''}`,
        why: `By ${subject}. It is a reminder to both sides, and stays for two weeks.`,
        act: 'Open the contract',
        path: contract,
      }
    case 'send_contract':
      return { head: `Finish and send ${subject}`, why: `A draft, for ${who}.`, act: 'Open the draft', path: contract }
    case 'pay_invoice':
      return {
        head: `Pay invoice ${subject}: ${sum(step)}`,
        why: `From ${who}. Record the payment once it is made.`,
        act: 'Go to money',
        path: `${project}/money`,
      }
    case 'invoice_deposit':
      return {
        head: `Invoice the deposit: ${sum(step)}`,
        why: `${subject} is signed.`,
        act: 'Draft the invoice',
        path: `${project}/money`,
      }
    case 'deposit_due':
      return {
        head: `Deposit due to ${who}: ${sum(step)}`,
        why: `${subject} is signed. Ask for the invoice, then record the payment.`,
        act: 'Go to money',
        path: `${project}/money`,
      }
    case 'invoice_due':
      return {
        head: `Invoice what is due: ${sum(step)}`,
        why: subject,
        act: 'Draft the invoice',
        path: `${project}/money`,
      }
    case 'agree_days':
      return {
        head: `Agree to ${plural(count, 'logged day')}`,
        why: `Logged by ${who}.`,
        act: 'Go to money',
        path: `${project}/money`,
      }
    case 'agree_hours':
      return {
        head: count === 1 ? 'Agree to logged hours' : `Agree to ${count} entries of hours`,
        why: `Logged by ${who}. Agree to each, or refuse it and say why.`,
        act: 'Go to money',
        path: `${project}/money`,
      }
    case 'correct_work':
      return {
        head: count === 1 ? 'Correct work that was refused' : `Correct ${count} entries that were refused`,
        why: 'The studio says why. Correct the entry and send it again.',
        act: 'Go to money',
        path: `${project}/money`,
      }
    case 'agree_round':
      return {
        head: `Agree to another round for ${subject}, or not`,
        why: `Beyond those that the contract with ${who} includes.`,
        act: 'Go to money',
        path: `${project}/money`,
      }
    case 'answer_questions':
      return {
        head: count === 1 ? 'Answer a question' : `Answer ${plural(count, 'question')}`,
        why: 'The answer is added to the cue.',
        act: 'Answer',
        path: `${project}/today`,
      }
    case 'answer_follow_ups':
      return {
        head: count === 1 ? 'Answer a question about the brief' : `Answer ${plural(count, 'question')} about the brief`,
        why: 'A designer asked for more than the answer says.',
        act: 'Answer',
        path: `${project}/brief`,
      }
    case 'send_changes':
      return { head: `Send ${plural(count, 'change')}`, why: '', act: 'Send', path: `${project}/today` }
    case 'review':
      return { head: `Review ${plural(count, 'cue')}`, why: '', act: 'Review', path: `${project}/review` }
    case 'fix':
      return { head: `Fix ${plural(count, 'sound')}`, why: '', act: 'Fix', path: `${project}/desk` }
    case 'match':
      return {
        head: count === 1 ? 'Choose a cue for 1 file' : `Choose cues for ${plural(count, 'file')}`,
        why: '',
        act: 'Choose',
        path: `${project}/desk`,
      }
    case 'record':
      return {
        head: count === 1 ? 'Record a sound' : `Record ${plural(count, 'sound')}`,
        why: 'The sound list names you, and no version has come yet.',
        act: 'Show',
        path: `${project}/sound-list`,
      }
    case 'implement':
      return {
        head: count === 1 ? 'Put an accepted sound in the game' : `Put ${plural(count, 'accepted sound')} in the game`,
        why: 'The sound list names you. They are not in the build yet.',
        act: 'Show',
        path: `${project}/sound-list`,
      }
    case 'make':
      return { head: `Make ${plural(count, 'sound')}`, why: '', act: 'Deliver', path: `${project}/desk` }
  }
}

/** What another person is to do: "sign NDA". */
export function awaitedWords({ kind, subject, count }: Awaited): string {
  switch (kind) {
    case 'join':
      return 'to join, invited'
    case 'bids':
      return `to bid on ${subject}`
    case 'nda':
      return 'to send the NDA'
    case 'signature':
      return `to sign ${subject}`
    case 'change_order':
      return `to sign a change order to ${subject}`
    case 'statement':
      return `to agree to the statement of ${subject}`
    case 'verdicts':
      return `to judge ${plural(count, 'cue')}`
    case 'answer':
      return `to answer ${plural(count, 'question')}`
    case 'fixes':
      return `to fix ${plural(count, 'cue')}`
    case 'invoice':
      return `to invoice ${subject}`
    case 'payment':
      return `to pay invoice ${subject}`
  }
}
