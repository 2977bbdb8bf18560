export { StatusSlot } from './StatusSlot'
export { dismissToast, showToast, TOAST_MS } from './store'
export { useIsLoading } from './useIsLoading'
