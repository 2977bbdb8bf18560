export { type Split, splitsQuery, useSplit } from './api'

export const loadSplitPanel = () => import('./SplitPanel').then(({ SplitPanel }) => SplitPanel)
