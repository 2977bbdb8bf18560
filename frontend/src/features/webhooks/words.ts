import type { Call, WebhookEvent, WebhookForm } from './api'

/** The events to choose from; a test is sent by its button, whatever is chosen. */
export const EVENT_WORDS: Record<Exclude<WebhookEvent, 'webhook.test'>, string> = {
  'take.in_review': 'A version is ready for review',
  'take.returned': 'A version is returned by the check',
  'take.approved': 'A version is approved',
  'changes.requested': 'Changes are requested',
  'question.asked': 'A question is asked',
  'list.revised': 'The sound list is revised',
  'cue.cut': 'A cue is cut',
  'pack.made': 'A pack is made',
  'build.posted': 'A build reports its checks',
  'audit.posted': 'A build is audited',
  'contract.agreed': 'A contract is signed by both sides',
  'invoice.issued': 'An invoice is issued',
  'payment.recorded': 'A payment is recorded',
}
export const EVENTS = Object.keys(EVENT_WORDS) as (keyof typeof EVENT_WORDS)[]

export const FORM_WORDS: Record<WebhookForm, string> = {
  json: 'JSON, for your own program',
  slack: 'Slack',
  discord: 'Discord',
  teams: 'Microsoft Teams',
}

export const eventWords = (event: WebhookEvent): string => (event === 'webhook.test' ? 'Test' : EVENT_WORDS[event])

export const STATE_WORDS: Record<Call['state'], string> = {
  waiting: 'Waiting',
  delivered: 'Delivered',
  failed: 'Failed',
}
