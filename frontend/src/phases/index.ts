export { phasesQuery, useApprovePalette } from './api'
export { ClosedGateNote } from './ClosedGateNote'
export { gateWords, PHASE_WORDS } from './words'
