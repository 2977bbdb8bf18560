export { DraftNote } from './DraftNote'
export { forgetDrafts, keepDraft, keptDraft, openDraftsOf } from './store'
export { type Draft, useDraft } from './useDraft'
