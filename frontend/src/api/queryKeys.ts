import { onlineManager, type QueryClient, type QueryKey } from '@tanstack/react-query'

interface Family<Parts extends readonly unknown[]> {
  (...parts: Parts): readonly [string, ...Parts]
  /** The beginning of every key of the family, to refetch all of them. */
  readonly all: readonly [string]
}

/** Keys that begin with one word. Ids come next, so that a key without its last parts matches all that begin with it. */
const family = <Parts extends readonly unknown[] = []>(word: string): Family<Parts> =>
  Object.assign((...parts: Parts) => [word, ...parts] as const, { all: [word] as const })

/** The keys of the query cache, every one of them, in the order of the server's rooms. */
export const queryKeys = {
  // accounts
  session: family('session'),
  me: family('me'),
  visitor: family('visitor'),
  signUp: family('sign-up'),
  signUpLink: family<[secret: string]>('sign-up-link'),
  signIns: family('sign-ins'),
  deskTokens: family('desk-tokens'),
  secondFactors: family('second-factors'),
  passkeys: family('passkeys'),
  emailChange: family('email-change'),
  emailChangeLink: family<[secret: string]>('email-change-link'),
  secondFactorRequirement: family<[studioId: string]>('second-factor-requirement'),
  membersSee: family<[studioId: string]>('members-see'),
  signInProvider: family<[studioId: string]>('sign-in-provider'),
  providerOfDomain: family<[domain: string]>('provider-of-domain'),
  mailPreferences: family('mail-preferences'),
  mailChoice: family<[secret: string]>('mail-choice'),
  studioPeople: family<[studioId: string]>('studio-people'),
  departure: family<[studioId: string, personId: string, roles: string[]]>('departure'),
  studioInvitations: family<[studioId: string]>('studio-invitations'),
  studioInvitation: family<[secret: string]>('studio-invitation'),
  credits: family<[projectId: string]>('credits'),
  invoiceDetails: family<[owner: string]>('invoice-details'),
  studioCalendar: family<[studioId: string]>('studio-calendar'),
  quotas: family<[studioId: string]>('quotas'),
  securityEvents: family<[studioId: string, kind: string]>('security-events'),

  // projects
  projects: family<[filter: { archived: boolean }]>('projects'),
  project: family<[projectId: string]>('project'),
  approvers: family<[projectId: string]>('approvers'),
  deputies: family<[projectId: string]>('deputies'),
  projectMembers: family<[projectId: string]>('project-members'),
  projectInvitations: family<[projectId: string]>('project-invitations'),
  invitation: family<[secret: string]>('invitation'),
  spec: family<[projectId: string]>('spec'),
  specVersions: family<[projectId: string]>('spec-versions'),
  specVersion: family<[projectId: string, version: number]>('spec-version'),
  specDraftCheck: family<[projectId: string, written: unknown]>('spec-draft-check'),
  acceptedFiles: family<[projectId: string]>('accepted-files'),
  checks: family('checks'),
  checkPage: family<[check: string]>('check-page'),

  // briefs
  brief: family<[projectId: string, part?: 'spec' | 'vision']>('brief'),
  phases: family<[projectId: string]>('phases'),
  decisions: family<[projectId: string]>('decisions'),
  briefVersions: family<[projectId: string]>('brief-versions'),
  briefComparison: family<[projectId: string, from: number, to: number | 'now']>('brief-comparison'),
  briefReads: family<[projectId: string]>('brief-reads'),
  coverage: family<[projectId: string]>('coverage'),

  // sound lists
  soundList: family<[projectId: string, part?: SoundListPart, ...of: unknown[]]>('sound-list'),
  categories: family<[projectId: string, nameOfNew?: string]>('categories'),
  comparedRevisions: family<[projectId: string, from: number, to: number]>('revisions'),
  cue: family<[cueId: string]>('cue'),
  spokenPlaceholder: family<[cueId: string]>('spoken-placeholder'),
  kits: family('kits'),
  kit: family<[projectId: string, key?: string]>('kit'),
  importPlan: family<[projectId: string, sheet: unknown]>('import-plan'),

  // references
  references:
    family<
      [projectId: string, part?: 'board' | 'clip' | 'cue' | 'text' | 'versions' | 'openings' | 'words', of?: string]
    >('references'),

  // hiring
  askedCues: family<[postingId: string]>('asked-cues'),
  postings: family<[projectId: string]>('postings'),
  ownPostings: family('own-postings'),
  posting: family<[postingId: string]>('posting'),
  studioRecord: family<[postingId: string]>('studio-record'),
  postingLink: family<[secret: string]>('posting-link'),
  bids: family<[postingId: string]>('bids'),
  roster: family<[studioId: string, search: unknown]>('roster'),
  rosterEntry: family<[entryId: string, part?: 'work' | 'postings']>('roster-entry'),
  rosterImport: family<[studioId: string, sheet: unknown]>('roster-import'),
  ownWork: family<[part?: 'projects']>('own-work'),

  // contracts and money
  contracts: family<[projectId: string, part?: 'last' | 'handovers', ...of: unknown[]]>('contracts'),
  contract: family<[contractId: string, part?: ContractPart, ...of: unknown[]]>('contract'),
  contractLibrary: family<[kind: string]>('contract-library'),
  contractTemplates: family<[studioId: string]>('contract-templates'),
  money: family<[projectId: string] | [part: MoneyPart, id: string, ...of: unknown[]]>('money'),

  // deliveries
  deliveries: family<[projectId: string]>('deliveries'),
  deliveryList: family<[projectId: string]>('delivery-list'),
  delivery: family<[deliveryId: string]>('delivery'),
  deliveryFit: family<[deliveryId: string]>('delivery-fit'),
  unmatched: family<[projectId: string, count?: number]>('unmatched'),
  undecidedFiles: family<[projectId: string]>('undecided-files'),
  cueTakes: family<[cueId: string]>('cue-takes'),
  take: family<[takeId: string, part?: 'check' | 'fit' | 'source-bank', ...of: unknown[]]>('take'),
  takeSounds: family<[takeId: string]>('take-sounds'),
  sameSounds: family<[takeId: string]>('same-sounds'),
  soundLibraries: family<[projectId: string]>('sound-libraries'),
  handoffs: family<[cueId: string]>('handoffs'),
  sources: family<[of: 'take' | 'delivery', id: string]>('sources'),
  fix: family<[takeId: string]>('fix'),
  fixes: family<[projectId: string]>('fixes'),
  split: family<[takeId: string]>('split'),
  splits: family<[projectId: string]>('splits'),

  // renders
  targets: family<[projectId: string]>('targets'),
  batches: family<[projectId: string]>('batches'),
  batch: family<[batchId: string, ...progress: unknown[]]>('batch'),
  loss: family<[renderId: string]>('loss'),
  peaks: family<[url: string]>('peaks'),
  otherSounds: family<[projectId: string]>('other-sounds'),
  bands: family<[url: string | null]>('bands'),
  made: family<[kind: string, id: string | undefined, askedAt: number]>('made'),

  // reviews
  reviewQueue: family<[projectId: string, part?: 'count' | 'filtered', of?: object]>('review-queue'),
  cueReview: family<[cueId: string]>('cue-review'),
  changeRequests: family<[projectId: string, state: 'draft']>('change-requests'),
  takeHistory: family<[takeId: string]>('take-history'),
  approvalSettings: family<[projectId: string]>('approval-settings'),
  judged: family<[projectId: string]>('judged'),
  reviewReasons: family<[projectId: string]>('review-reasons'),
  reasons: family<[projectId: string, part: 'counts' | 'versions', of: object]>('reasons'),
  adoptions: family<[projectId: string]>('adoptions'),
  adoption: family<[adoptionId: string, part?: 'plan']>('adoption'),

  // scenes
  scene: family<[takeId: string]>('scene'),
  masking: family<[takeId: string, lanes: string]>('masking'),
  bedSources: family<[projectId: string]>('bed-sources'),
  comparison: family<[takeId: string, against: unknown]>('comparison'),

  // shares
  guestLinks: family<[projectId: string] | [part: 'visits', linkId: string]>('guest-links'),
  playlists: family<[projectId: string]>('playlists'),
  playlist: family<[playlistId: string, part?: 'live']>('playlist'),
  savedViews: family<[projectId: string]>('saved-views'),
  guestAccess: family<[secret: string]>('guest-access'),
  guestRoom: family<[visit: string]>('guest-room'),

  // voice lines
  voiceLines:
    family<[projectId: string, part?: 'script' | 'lines' | 'pick-ups' | 'releases' | 'cue', ...of: unknown[]]>(
      'voice-lines',
    ),
  scriptPlan: family<[projectId: string, script: unknown]>('script-plan'),

  // builds
  packs: family<[projectId: string, target?: string]>('packs'),
  sealedPacks: family<[projectId: string]>('sealed-packs'),
  sealedPack: family<[packId: string]>('sealed-pack'),
  placeholders: family<[projectId: string, part?: string]>('placeholders'),
  builds: family<[projectId: string]>('builds'),
  build: family<[buildId: string]>('build'),
  ci: family<[projectId: string]>('ci'),
  audits: family<[projectId: string, part?: 'one' | 'drift' | 'sounds' | 'history', of?: string]>('audits'),
  listening: family<[projectId: string, part?: 'states' | 'pass' | 'tasks' | 'tasks done']>('listening'),
  tokens: family<[projectId: string]>('tokens'),

  // notifications, dashboards and operations
  outbox: family<[studioId: string]>('outbox'),
  mailedLinks: family<[projectId: string]>('mailed-links'),
  notices: family<[part: 'unread' | 'list']>('notices'),
  peopleToMention: family<[takeId: string]>('people-to-mention'),
  webhooks: family<[studioId: string] | [part: 'calls', webhookId: string]>('webhooks'),
  today: family<[projectId: string]>('today'),
  nextSteps: family<[projectId: string]>('next-steps'),
  desk: family<[projectId: string, list?: string]>('desk'),
  overview: family<[projectId: string]>('overview'),
  hours: family<[projectId: string]>('hours'),
  effort: family<[projectId: string, of?: object]>('effort'),
  sizeEstimate: family<[projectId: string, kit: string, revision: number]>('size-estimate'),
  pace: family<[projectId: string]>('pace'),
  progress: family<[projectId: string, part?: 'cues' | 'counts']>('progress'),
  erasure: family<[kind: string, id: string]>('erasure'),
  operations: family<[scope: string, part: 'kept' | 'limits' | 'sums' | 'jobs', state?: string]>('operations'),
}

type SoundListPart =
  | 'list'
  | 'refused names'
  | 'columns'
  | 'people'
  | 'matrix'
  | 'open questions'
  | 'unmatched'
  | 'revisions'
  | 'changes'
  | 'clarity'
type ContractPart =
  | 'versions'
  | 'comparison'
  | 'preview'
  | 'record'
  | 'redlines'
  | 'redline-preview'
  | 'change-orders'
  | 'ending'
  | 'masters'
type MoneyPart =
  | 'cue'
  | 'ledger'
  | 'invoices'
  | 'invoice-draft'
  | 'estimates'
  | 'own-time'
  | 'milestone'
  | 'plan'
  | 'plan-check'
  | 'plan-proposal'
  | 'days'

const wordsOf = (...families: readonly { all: readonly [string] }[]): ReadonlySet<string> =>
  new Set(families.map(({ all: [word] }) => word))

/** Families of the review room, which shows each verdict itself and goes on without a connection. */
const KEPT = wordsOf(queryKeys.reviewQueue, queryKeys.cueReview)

/**
 * Refetch what is shown of these keys and of all that begin with one of them. What no page shows is forgotten, so that
 * no page begins with a state older than the act; without a connection it is kept, for there is nothing newer.
 */
export const invalidate = (client: QueryClient, ...touched: readonly QueryKey[]): Promise<void[]> =>
  Promise.all(
    touched.map((queryKey) => {
      const isForgotten = onlineManager.isOnline() && !KEPT.has(String(queryKey[0]))
      if (isForgotten) client.removeQueries({ queryKey, type: 'inactive' })
      return client.invalidateQueries({ queryKey })
    }),
  )

/** Families that no change on the server affects: texts of the product, and answers about something typed. */
export const FIXED = wordsOf(
  queryKeys.session,
  queryKeys.visitor,
  queryKeys.signUp,
  queryKeys.signUpLink,
  queryKeys.checkPage,
  queryKeys.contractLibrary,
  queryKeys.importPlan,
  queryKeys.scriptPlan,
  queryKeys.rosterImport,
  queryKeys.specDraftCheck,
  queryKeys.specVersion,
  queryKeys.bands,
  queryKeys.takeSounds,
  queryKeys.loss,
)

/** Families that a change in these rooms affects; a change in any other room may affect every family. */
export const AFFECTED_BY: Readonly<Record<string, ReadonlySet<string>>> = {
  notifications: wordsOf(queryKeys.outbox, queryKeys.mailedLinks, queryKeys.notices),
  webhooks: wordsOf(queryKeys.webhooks),
  references: wordsOf(queryKeys.references),
  shares: wordsOf(queryKeys.guestLinks, queryKeys.playlists, queryKeys.playlist, queryKeys.savedViews),
  accounts: wordsOf(
    queryKeys.me,
    queryKeys.studioPeople,
    queryKeys.studioInvitations,
    queryKeys.project,
    queryKeys.projects,
    queryKeys.quotas,
    queryKeys.today,
  ),
}
