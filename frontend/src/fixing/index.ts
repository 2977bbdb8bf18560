export { type Fix, type FixOffer, fixQuery, fixesQuery, useFix, useSounds } from './api'
export { FixPanel } from './FixPanel'
export { type FixedTake, type Fixing, useFixing } from './useFixing'
