export { type Mend, type MendOffer, mendQuery, mendsQuery, useMend, useSounds } from './api'
export { MendPanel } from './MendPanel'
export { type MendedTake, type Mending, useMending } from './useMending'
