import { Button } from '@/ui/Button'
import { LazyMenu } from '@/ui/LazyMenu'

import type { ViewedPage } from './api'

const loadMenu = () => import('./ViewsMenu').then(({ ViewsMenu }) => ViewsMenu)

interface ViewsProps {
  projectId: string
  /** Each person's own of the list; of the review queue the team shares them. */
  page?: ViewedPage
  search: object
  onOpen: (search: Record<string, unknown>) => void
}

/** A button with the filters that a person kept. */
export function Views(given: ViewsProps) {
  return <LazyMenu load={loadMenu} given={given} button={<Button icon="sliders">Views</Button>} />
}
