export { type VoiceLine } from './api'
export { LineState } from './LineState'
export { LINE_STATES, languageName, percentOf } from './words'
