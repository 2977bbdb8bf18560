import { Button } from '@/ui/Button'
import { LazyMenu } from '@/ui/LazyMenu'

const loadMenu = () => import('./ViewsMenu').then(({ ViewsMenu }) => ViewsMenu)

interface ViewsProps {
  projectId: string
  search: object
  onOpen: (search: Record<string, unknown>) => void
}

/** A button with the filters that a person kept. */
export function Views(given: ViewsProps) {
  return <LazyMenu load={loadMenu} given={given} button={<Button icon="sliders">Views</Button>} />
}
