export { phasesQuery, useApprovePalette } from './api'
export { ClosedGateNote } from './ClosedGateNote'
export { gateWords, type Phase, PHASE_WORDS, PHASES } from './words'
