import { Modal } from '@mantine/core'
import type { ReactNode } from 'react'

import { Button } from '@/ui/Button'

import classes from './Dialog.module.css'
import { KeyScope } from './keys'

interface DialogProps {
  title: string
  opened: boolean
  onClose: () => void
  size?: number
  children: ReactNode
}

/** What opens over the page, only where nothing fits in place: its own keys, Escape closes, the focus goes back. */
export function Dialog({ title, opened, onClose, size = 520, children }: DialogProps) {
  return (
    <Modal.Root opened={opened} onClose={onClose} size={size} transitionProps={{ duration: 0 }}>
      <Modal.Overlay backgroundOpacity={0.2} />
      <Modal.Content className={classes.content}>
        <div className={`flex items-center between ${classes.head}`}>
          <Modal.Title>{title}</Modal.Title>
          <Button variant="quiet" square icon="cross" aria-label="Close" onClick={onClose} />
        </div>
        <Modal.Body className={classes.body}>{opened && <KeyScope>{children}</KeyScope>}</Modal.Body>
      </Modal.Content>
    </Modal.Root>
  )
}
