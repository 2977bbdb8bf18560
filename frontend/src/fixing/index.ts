export { type Fix, type FixOffer, fixesQuery, fixQuery, useSounds, useUseFixes } from './api'
export { FixPanel } from './FixPanel'
export { type FixedTake, type Fixing, useFixing } from './useFixing'
