export { StatusSlot } from './StatusSlot'
export { dismissToast, showToast } from './store'
export { useIsLoading } from './useIsLoading'
