import { Button } from '@/ui/Button'

import { Dialog } from '../Dialog'
import type { OpenedProps } from '../LazyDialog'

interface LeaveDialogProps extends OpenedProps {
  onLeave: () => void
  onDiscard: () => void
}

/** What was typed is kept where the person leaves; they may stay, or throw it away. */
export function LeaveDialog({ opened, onClose, onLeave, onDiscard }: LeaveDialogProps) {
  return (
    <Dialog title="Leave this page?" opened={opened} onClose={onClose}>
      <p>What you typed here is not saved. If you leave, it stays in this browser until you come back.</p>
      <div className="flex wrap justify-end gap-2 mt-4">
        <Button onClick={onDiscard}>Discard it</Button>
        <Button onClick={onLeave}>Leave</Button>
        <Button variant="primary" data-autofocus onClick={onClose}>
          Stay
        </Button>
      </div>
    </Dialog>
  )
}
