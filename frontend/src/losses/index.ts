export { type Loss } from './api'
export { LossPanel } from './LossPanel'
