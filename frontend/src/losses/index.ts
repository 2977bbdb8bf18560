export { type Loss, lossQuery } from './api'
export { LossPanel } from './LossPanel'
