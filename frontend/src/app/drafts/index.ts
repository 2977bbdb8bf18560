export { DraftNote } from './DraftNote'
export { LeaveGuard } from './LeaveGuard'
export { forgetDrafts, keepDraft, keptDraft, openDraftsOf } from './store'
export { type Draft, useDraft } from './useDraft'
