import { LazyDialog } from '@/app/LazyDialog'

import type { Reference } from './api'

const load = () => import('./ReferenceViewer').then((part) => part.ReferenceViewer)

/** A picture or a text in full, over the page, once one is chosen. */
export function ReferenceDialog({ reference, onClose }: { reference: Reference | null; onClose: () => void }) {
  return <LazyDialog load={load} opened={reference !== null} onClose={onClose} given={{ reference }} />
}
