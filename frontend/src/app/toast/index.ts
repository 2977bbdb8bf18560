export { dismissToast, showToast } from './store'
export { ToastRegion } from './ToastRegion'
