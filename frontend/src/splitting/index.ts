export { type Split, splitQuery, splitsQuery, useSplit } from './api'
export { SplitPanel } from './SplitPanel'
